#include "sim/config/toml_assigner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/config/parameter_list.h"
#include "sim/config/text.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

std::string value_text(const toml::node& node) {
  if (const auto* v = node.as_integer()) return fmt::format("{}", v->get());
  if (const auto* v = node.as_floating_point()) {
    const std::string text = fmt::format("{}", v->get());
    return text.find_first_of(".einf") == std::string::npos ? text + ".0" : text;  // 4.0 is not the integer 4
  }
  if (const auto* v = node.as_boolean()) return v->get() ? "true" : "false";
  if (const auto* v = node.as_string()) return fmt::format("\"{}\"", v->get().substr(0, 80));
  if (node.is_array()) return "an array";
  if (node.is_table()) return "a table";
  return "a date or time";
}

std::string with_unit(const std::string& range, const std::string& unit) {
  return unit.empty() ? range : range + " " + unit;
}

constexpr std::int64_t beyond = std::numeric_limits<std::int64_t>::max();  // every range

/// Only digits; what does not fit is beyond every range.
std::int64_t saturated(const std::string& digits) {
  const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
  return digits.size() - first > 18 ? beyond : std::stoll(digits.substr(first));
}

/// An integer that is too long for TOML, which comes as text then.
bool is_long_integer(const std::string& text) {
  const std::string digits = text.substr(text.find_first_of("+-") == 0 ? 1 : 0);
  return digits.size() > 18 && digits.find_first_not_of("0123456789") == std::string::npos;
}

/// "16KiB" and the like; false if it is not a size.
bool byte_size(const std::string& text, std::int64_t& value) {
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  if (digits == 0) return false;
  value = saturated(text.substr(0, digits));
  const std::string suffix = text.substr(std::min(text.find_first_not_of(' ', digits), text.size()));
  const std::array<const char*, 4> suffixes{"B", "KiB", "MiB", "GiB"};
  const auto found = std::find(suffixes.begin(), suffixes.end(), suffix);
  if (found == suffixes.end()) return suffix.empty();
  const auto shift = 10 * (found - suffixes.begin());
  value = value > (beyond >> shift) ? beyond : value << shift;
  return true;
}

bool is_power_of_two(std::int64_t value) { return value > 0 && (value & (value - 1)) == 0; }

/// The powers of two around a value that is none, as far as the range allows.
std::string nearest_powers(std::int64_t value, const hw::IntegerRange& range) {
  std::int64_t below = 1;
  while (below * 2 <= value) below *= 2;
  const std::int64_t above = below * 2;
  if (above > range.maximum) return fmt::format("{}", below);
  if (below < range.minimum) return fmt::format("{}", above);
  return fmt::format("{} or {}", below, above);
}

}  // namespace

TomlAssigner::TomlAssigner(const toml::table& root, PlaceOf place_of) : place_of_(std::move(place_of)) {
  tables_.push_back(&root);
}

void TomlAssigner::enter(const char* name, const char* text) {
  PathVisitor::enter(name, text);
  const toml::node* node = tables_.back() ? tables_.back()->get(name) : nullptr;
  if (node && !node->is_table()) {
    throw InputError(place_of_(*node), fmt::format("{} is a group of parameters, not {}; a [{}] section would be right",
                                                   group(), value_text(*node), group()));
  }
  tables_.push_back(node ? node->as_table() : nullptr);
}

void TomlAssigner::leave() {
  PathVisitor::leave();
  tables_.pop_back();
}

const toml::node* TomlAssigner::find(const char* name) {
  const toml::node* node = tables_.back() ? tables_.back()->get(name) : nullptr;
  if (node) places_[path(name)] = place_of_(*node);
  return node;
}

std::uint32_t TomlAssigner::to_integer(const toml::node& node, const std::string& path, const hw::IntegerRange& range,
                                       const std::string& unit) const {
  const std::string allowed = with_unit(range_text(range), unit);
  std::int64_t value = 0;
  bool valid = false;
  if (const auto* number = node.as_integer()) {
    value = number->get();
    valid = true;
  } else if (unit == "bytes" && node.is_string()) {
    valid = byte_size(node.as_string()->get(), value);
  }
  if (!valid && node.is_string() && is_long_integer(node.as_string()->get())) {
    throw InputError(place_of_(node), fmt::format("{} = {} is out of range; {} would be right", path,
                                                  node.as_string()->get().substr(0, 80), allowed));
  }
  if (!valid) {
    std::string right = allowed;
    const auto* real = node.as_floating_point();
    if (real && std::floor(real->get()) == real->get() && real->get() >= range.minimum &&
        real->get() <= range.maximum) {
      right = fmt::format("{:.0f}", real->get());
    }
    throw InputError(place_of_(node),
                     fmt::format("{} = {} is not an integer; {} would be right", path, value_text(node), right));
  }
  if (value < range.minimum || value > range.maximum) {
    throw InputError(place_of_(node),
                     fmt::format("{} = {} is out of range; {} would be right", path, value_text(node), allowed));
  }
  if (range.power_of_two && !is_power_of_two(value)) {
    throw InputError(place_of_(node), fmt::format("{} = {} is not a power of two; {} would be right", path,
                                                  value_text(node), nearest_powers(value, range)));
  }
  return static_cast<std::uint32_t>(value);
}

void TomlAssigner::integer(const char* name, std::uint32_t& value, hw::IntegerRange range, const char* unit,
                           const char* text) {
  if (const toml::node* node = find(name)) value = to_integer(*node, path(name), range, unit);
}

void TomlAssigner::real(const char* name, float& value, hw::RealRange range, const char* unit, const char* text) {
  const toml::node* node = find(name);
  if (!node) return;
  const std::string allowed = with_unit(range_text(range), unit);
  if (!node->is_number()) {
    throw InputError(place_of_(*node),
                     fmt::format("{} = {} is not a number; {} would be right", path(name), value_text(*node), allowed));
  }
  const double given =
      node->is_integer() ? static_cast<double>(node->as_integer()->get()) : node->as_floating_point()->get();
  if (!(given >= range.minimum && given <= range.maximum)) {  // also refuses NaN
    throw InputError(place_of_(*node),
                     fmt::format("{} = {} is out of range; {} would be right", path(name), value_text(*node), allowed));
  }
  value = static_cast<float>(given);
}

void TomlAssigner::flag(const char* name, bool& value, const char* text) {
  const toml::node* node = find(name);
  if (!node) return;
  if (!node->is_boolean()) {
    throw InputError(place_of_(*node),
                     fmt::format("{} = {} is not a flag; true or false would be right", path(name), value_text(*node)));
  }
  value = node->as_boolean()->get();
}

void TomlAssigner::table(const char* name, hw::TableValues values, hw::IntegerRange range, const char* unit,
                         const char* text) {
  const toml::node* node = find(name);
  if (!node) return;
  const toml::array* array = node->as_array();
  if (!array || array->size() != values.size) {
    throw InputError(
        place_of_(*node),
        fmt::format("{} is {}; an array of {} integers would be right", path(name),
                    array ? fmt::format("an array of {}", array->size()) : value_text(*node), values.size));
  }
  for (std::size_t i = 0; i < values.size; ++i) {
    values.first[i] = to_integer(*array->get(i), fmt::format("{}[{}]", path(name), i), range, unit);
  }
}

void TomlAssigner::choice(const char* name, unsigned& value, const std::vector<const char*>& names, const char* text) {
  const toml::node* node = find(name);
  if (!node) return;
  const std::string given = node->is_string() ? node->as_string()->get() : std::string();
  const auto found = std::find(names.begin(), names.end(), given);
  if (found == names.end()) {
    throw InputError(place_of_(*node), fmt::format("{} = {} is not a choice; one of {} would be right", path(name),
                                                   value_text(*node), range_text(names)));
  }
  value = static_cast<unsigned>(found - names.begin());
}

namespace {

struct Unknown {
  const toml::node* node = nullptr;
  std::string path;
};

/// The unknown key that comes first in the file; toml++ keeps tables sorted by name, not by line.
void find_unknown(const toml::table& table, const std::string& prefix, const std::vector<std::string>& parameters,
                  const std::vector<std::string>& groups, Unknown& first) {
  const auto has = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const auto& [key, node] : table) {
    const std::string path = prefix.empty() ? std::string(key.str()) : prefix + "." + std::string(key.str());
    if (has(parameters, path)) continue;
    const toml::table* inner = node.as_table();
    if (inner && (!inner->empty() || has(groups, path))) {
      find_unknown(*inner, path, parameters, groups, first);
    } else if (!has(groups, path)) {
      if (!first.node || node.source().begin < first.node->source().begin) first = {&node, path};
    }
  }
}

}  // namespace

void refuse_unknown_keys(const toml::table& root, const PlaceOf& place_of) {
  std::vector<std::string> parameters;
  for (ParameterInfo& parameter : parameter_list()) parameters.push_back(std::move(parameter.path));
  Unknown first;
  find_unknown(root, "", parameters, parameter_groups(), first);
  if (!first.node) return;
  throw InputError(place_of(*first.node), unknown_parameter(first.path));
}

}  // namespace artu::sim
