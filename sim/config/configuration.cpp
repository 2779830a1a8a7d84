#include "sim/config/configuration.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "sim/config/cross_check.h"
#include "sim/config/parameter_list.h"
#include "sim/config/toml_assigner.h"
#include "sim/config/toml_texts.h"
#include "sim/report/file.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

/// toml++ may describe an error in several lines; ours has one.
std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

toml::table parse(const std::string& text, const std::string& file) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}", file, error.source().begin.line),
                     fmt::format("not valid TOML: {}; a file as --dump-config prints it would be right",
                                 one_line(std::string(error.description()))));
  }
}

void assign(const toml::table& root, const PlaceOf& place_of, hw::UnitConfig& unit,
            std::map<std::string, std::string>& places) {
  refuse_zero_bytes(root, place_of);
  refuse_unknown_keys(root, place_of);
  hw::UnitConfig changed = unit;
  TomlAssigner assigner(root, place_of);
  changed.visit(assigner);
  if (assigner.places().count("memory.dram.preset") != 0) {
    // The part first, then what was given beside it.
    hw::apply(changed.memory.dram.preset, changed.memory.dram);
    TomlAssigner again(root, place_of);
    changed.visit(again);
  }
  unit = changed;
  for (const auto& [path, place] : assigner.places()) places[path] = place;
}

void trim(std::string& text) {
  const char* blanks = " \t";
  text.erase(0, text.find_first_not_of(blanks));
  text.erase(text.find_last_not_of(blanks) + 1);
}

/// The value as TOML, or else as a string without its quotes: `--set selective.magnitude=fixed`.
toml::table parse_assignment(const std::string& path, const std::string& value, const std::string& place) {
  try {
    return toml::parse(path + " = " + value);
  } catch (const toml::parse_error&) {
    std::string quoted;
    for (const char c : value) {
      if (c == '"' || c == '\\') quoted += '\\';
      if (static_cast<unsigned char>(c) >= 32) quoted += c;  // TOML strings hold no control characters
    }
    return parse(path + " = \"" + quoted + "\"", place);
  }
}

}  // namespace

Configuration Configuration::of(const std::vector<std::string>& files, const std::vector<std::string>& assignments) {
  Configuration configuration;
  for (const std::string& file : files) configuration.load(file);
  for (const std::string& assignment : assignments) configuration.set(assignment);
  configuration.check();
  return configuration;
}

void Configuration::load(const std::string& file) {
  const toml::table root = parse(read_file(file), file);
  const PlaceOf place = [&](const toml::node& node) { return fmt::format("{}:{}", file, node.source().begin.line); };
  assign(root, place, unit_, places_);
}

void Configuration::set(const std::string& assignment, const std::string& place) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || assignment.find('\n') != std::string::npos) {
    throw InputError(place, fmt::format("\"{}\" is not an assignment; path=value would be right, for example "
                                        "core.count=4",
                                        one_line(assignment)));
  }
  std::string path = assignment.substr(0, equals), value = assignment.substr(equals + 1);
  trim(path);
  trim(value);
  const auto parameters = parameter_list();
  const bool known = std::any_of(parameters.begin(), parameters.end(), [&](const auto& p) { return p.path == path; });
  if (!known) {
    throw InputError(place, unknown_parameter(path));
  }
  assign(
      parse_assignment(path, value, place), [&place](const toml::node&) { return place; }, unit_, places_);
}

void Configuration::check() const { cross_check(unit_, places_); }

}  // namespace artu::sim
