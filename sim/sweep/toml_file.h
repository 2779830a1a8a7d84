// A TOML file whose errors are one line with FILE:LINE.
#pragma once

#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

#include <string>
#include <utility>
#include <vector>

namespace artu::sim {

class TomlFile {
 public:
  explicit TomlFile(const std::string& name);

  const toml::table& root() const { return root_; }
  std::string place(const toml::node& node) const;
  [[noreturn]] void refuse(const toml::node& node, const std::string& what) const;

  /// Throws unless every key is one of `keys`.
  void allow(const toml::table& table, const std::vector<std::string>& keys) const;
  std::string text(const toml::node& node, const std::string& key) const;
  std::vector<std::string> texts(const toml::node& node, const std::string& key) const;
  /// 0 ... 2^63 - 1.
  std::uint64_t count(const toml::node& node, const std::string& key, std::uint64_t minimum,
                      std::uint64_t maximum) const;
  double real(const toml::node& node, const std::string& key) const;
  const toml::table& table(const toml::node& node, const std::string& key) const;
  const toml::array& array(const toml::node& node, const std::string& key) const;

 private:
  std::string name_;
  toml::table root_;
};

/// A value as TOML on one line; throws nothing: a table is "a table".
std::string toml_text(const toml::node& node);

/// The keys of a table in the order of the file; toml++ keeps them by name.
std::vector<std::pair<std::string, const toml::node*>> in_order_of_file(const toml::table& table);

}  // namespace artu::sim
