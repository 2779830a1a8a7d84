// A TOML table that is read strictly: every value has a type and a line, and a key nobody knows is an error.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

namespace artu::sim {

class StageTable {
 public:
  /// Refuses keys that are not in `keys`, with the nearest one that is.  `table` must outlive this.
  StageTable(const std::string& file, const std::string& name, const toml::table& table,
             const std::vector<std::string>& keys);

  bool has(const std::string& key) const { return table_->contains(key); }
  std::string where(const std::string& key) const;  // FILE:LINE of a value
  std::string where() const;                        // of the table
  [[noreturn]] void fail(const std::string& key, const std::string& what) const;

  double number(const std::string& key, double otherwise) const;
  double number(const std::string& key, double otherwise, double low, double high) const;
  bool boolean(const std::string& key, bool otherwise) const;
  std::string text(const std::string& key, const std::string& otherwise) const;
  glm::dvec3 vector(const std::string& key, const glm::dvec3& otherwise) const;
  glm::dvec3 required_vector(const std::string& key) const;
  /// Three numbers, or one that stands for all three.
  glm::dvec3 vector_or_number(const std::string& key, const glm::dvec3& otherwise) const;
  /// One string or an array of strings.
  std::vector<std::string> texts(const std::string& key) const;
  /// An array of tables ([[key]]), each checked against `keys`; empty if absent.
  std::vector<StageTable> tables(const std::string& key, const std::vector<std::string>& keys) const;
  std::optional<StageTable> table(const std::string& key, const std::vector<std::string>& keys) const;
  const toml::node* node(const std::string& key) const { return table_->get(key); }

 private:
  std::string file_, name_;
  const toml::table* table_;  // not a copy: copies of TOML nodes forget their lines
};

/// Throws InputError("FILE:LINE", ...) on a syntax error.
toml::table parse_stage_file(const std::string& path);

/// ", did you mean \"x\"?" with the nearest of `known`, or a list of them.
std::string suggest(const std::string& name, const std::vector<std::string>& known);

}  // namespace artu::sim
