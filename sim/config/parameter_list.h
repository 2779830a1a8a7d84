// All parameters as a flat list: what `--list-params` prints, and the names that messages suggest.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hw/unit_config.h"

namespace artu::sim {

enum class ParameterKind : std::uint8_t { integer, real, flag, table, choice };

/// "integer", "real" ...
const char* kind_name(ParameterKind kind);

struct ParameterInfo {
  std::string path;           // core.node_cache.size
  std::string default_value;  // as TOML
  std::string unit;           // "" for a pure number
  std::string range;          // "256 ... 67108864, a power of two"
  std::string text;
  ParameterKind kind = ParameterKind::integer;
  bool power_of_two = false;  // of an integer
};

/// In the order of declaration.
std::vector<ParameterInfo> parameter_list();

/// The value that each has in a configuration, as TOML, in the same order.
std::vector<std::string> parameter_values(const hw::UnitConfig& unit);

/// The paths of all groups: unit, core, core.node_cache ...
std::vector<std::string> parameter_groups();

/// The parameter that a misspelt path most likely means.
std::string nearest_parameter(const std::string& path);

/// What to say of a path that is none: "unknown parameter ..." with the nearest one, if any is near.
std::string unknown_parameter(const std::string& path);

/// The table that `--list-params` prints.
std::string format_parameter_list();

}  // namespace artu::sim
