// The parameters of GRID.toml.
#pragma once

#include <string>
#include <vector>

#include "sim/sweep/grid.h"
#include "sim/sweep/toml_file.h"

namespace artu::sim {

/// Reads values as the configuration does: with the same ranges and messages.
class AxisReader {
 public:
  AxisReader(const TomlFile& file, const Configuration& base);

  /// Parameters of a section in the order of the file; `keys` of the section are none.
  std::vector<Axis> lists(const toml::table& section) const;  // path = [value, value ...]
  std::vector<Axis> intervals(const toml::table& section, const std::vector<std::string>& keys) const;

  /// Points of [[point]] sections.  The axes are all that any of them names, where `axes` are not given.
  void points(const toml::array& sections, std::vector<Axis>& axes, std::vector<std::vector<std::string>>& rows,
              std::vector<std::string>& places) const;

 private:
  struct Entry {
    std::size_t parameter = 0;  // its place in parameters_
    const toml::node* node = nullptr;
  };
  void collect(const toml::table& table, const std::string& prefix, const std::vector<std::string>& keys,
               std::vector<Entry>& entries) const;
  std::vector<Entry> entries(const toml::table& section, const std::vector<std::string>& keys) const;
  Axis axis(const Entry& entry) const;
  std::vector<std::string> values(const Entry& entry, const toml::node& list) const;
  void interval(const Entry& entry, const toml::node& low, const toml::node& high, Axis& axis) const;
  /// As --dump-config writes it.
  std::string value(const Entry& entry, const toml::node& node) const;

  const TomlFile& file_;
  const Configuration& base_;
  const std::vector<ParameterInfo> parameters_;
  const std::vector<std::string> base_values_, groups_;
};

}  // namespace artu::sim
