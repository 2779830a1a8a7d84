// Puts the values of a TOML table into the parameters that a config struct names.
#pragma once

#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "sim/config/path_visitor.h"

namespace artu::sim {

/// The place of a node for a message: FILE:LINE.
using PlaceOf = std::function<std::string(const toml::node&)>;

class TomlAssigner : public PathVisitor {
 public:
  TomlAssigner(const toml::table& root, PlaceOf place_of);

  void enter(const char* name, const char* text) override;
  void leave() override;
  void integer(const char* name, std::uint32_t& value, hw::IntegerRange range, const char* unit,
               const char* text) override;
  void real(const char* name, float& value, hw::RealRange range, const char* unit, const char* text) override;
  void flag(const char* name, bool& value, const char* text) override;
  void table(const char* name, hw::TableValues values, hw::IntegerRange range, const char* unit,
             const char* text) override;
  void choice(const char* name, unsigned& value, const std::vector<const char*>& names, const char* text) override;

  /// Where each parameter was given.
  const std::map<std::string, std::string>& places() const { return places_; }

 private:
  const toml::node* find(const char* name);
  std::uint32_t to_integer(const toml::node& node, const std::string& path, const hw::IntegerRange& range,
                           const std::string& unit) const;

  PlaceOf place_of_;
  std::vector<const toml::table*> tables_;  // of the groups that we are in; null where the file has none
  std::map<std::string, std::string> places_;
};

/// Refuses a key that is not a parameter, with the name that was probably meant.
void refuse_unknown_keys(const toml::table& root, const PlaceOf& place_of);

}  // namespace artu::sim
