// The unit's configuration from its defaults, files and `--set`, in the order given.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "hw/unit_config.h"

namespace artu::sim {

/// Every error is an InputError whose place is FILE:LINE or `--set`.  A failed call changes nothing.
class Configuration {
 public:
  Configuration() = default;
  /// From another's parameters on.
  explicit Configuration(const hw::UnitConfig& unit) : unit_(unit) {}
  /// Files, then assignments, then the check.
  static Configuration of(const std::vector<std::string>& files, const std::vector<std::string>& assignments);

  void load(const std::string& file);  // TOML
  /// "path=value"; the value as in TOML, quotes may be left out.  `place` is what an error names.
  void set(const std::string& assignment, const std::string& place = "--set");
  void check() const;  // the rules that tie two parameters together
  const hw::UnitConfig& unit() const { return unit_; }

 private:
  hw::UnitConfig unit_;
  std::map<std::string, std::string> places_;  // of each parameter that was set, for check()
};

}  // namespace artu::sim
