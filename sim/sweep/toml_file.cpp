#include "sim/sweep/toml_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "sim/config/edit_distance.h"
#include "sim/config/text.h"
#include "sim/config/toml_texts.h"
#include "sim/report/file.h"
#include "traces/error.h"

namespace artu::sim {

TomlFile::TomlFile(const std::string& name) : name_(name) {
  const std::string bytes = read_file(name);
  try {
    root_ = toml::parse(bytes);
  } catch (const toml::parse_error& error) {
    std::string text(error.description());
    std::replace(text.begin(), text.end(), '\n', ' ');
    throw InputError(fmt::format("{}:{}", name, error.source().begin.line), "not valid TOML: " + text);
  }
  refuse_zero_bytes(root_, [this](const toml::node& node) { return place(node); });
}

std::string TomlFile::place(const toml::node& node) const {
  return fmt::format("{}:{}", name_, std::max<toml::source_index>(1, node.source().begin.line));
}

void TomlFile::refuse(const toml::node& node, const std::string& what) const { throw InputError(place(node), what); }

void TomlFile::allow(const toml::table& table, const std::vector<std::string>& keys) const {
  for (const auto& [key, node] : in_order_of_file(table)) {
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    const std::string wrong = key.substr(0, 100);
    const auto nearest = std::min_element(keys.begin(), keys.end(), [&](const std::string& a, const std::string& b) {
      return edit_distance(wrong, a) < edit_distance(wrong, b);
    });
    if (!resembles(wrong, *nearest)) {
      refuse(*node, fmt::format("unknown key {}; there are {}", wrong, fmt::join(keys, ", ")));
    }
    refuse(*node, fmt::format("unknown key {}; did you mean {}? There are {}", wrong, *nearest, fmt::join(keys, ", ")));
  }
}

std::string TomlFile::text(const toml::node& node, const std::string& key) const {
  if (const auto* value = node.as_string()) return value->get();
  refuse(node, fmt::format("{} = {} is no text; quotes around it would be right", key, toml_text(node)));
}

std::vector<std::string> TomlFile::texts(const toml::node& node, const std::string& key) const {
  std::vector<std::string> all;
  for (const toml::node& item : array(node, key)) all.push_back(text(item, key));
  return all;
}

std::uint64_t TomlFile::count(const toml::node& node, const std::string& key, std::uint64_t minimum,
                              std::uint64_t maximum) const {
  const auto* value = node.as_integer();
  if (value != nullptr && value->get() >= 0) {
    const auto number = static_cast<std::uint64_t>(value->get());
    if (number >= minimum && number <= maximum) return number;
  }
  refuse(node,
         fmt::format("{} = {} is no such count; {} ... {} would be right", key, toml_text(node), minimum, maximum));
}

double TomlFile::real(const toml::node& node, const std::string& key) const {
  if (const auto* value = node.as_floating_point()) return value->get();
  if (const auto* value = node.as_integer()) return static_cast<double>(value->get());
  refuse(node, fmt::format("{} = {} is no number; one would be right", key, toml_text(node)));
}

const toml::table& TomlFile::table(const toml::node& node, const std::string& key) const {
  if (const auto* value = node.as_table()) return *value;
  refuse(node, fmt::format("{} = {} is no table; a section [{}] would be right", key, toml_text(node), key));
}

const toml::array& TomlFile::array(const toml::node& node, const std::string& key) const {
  if (const auto* value = node.as_array()) return *value;
  refuse(node, fmt::format("{} = {} is no list; [{}] would be right", key, toml_text(node), toml_text(node)));
}

std::string toml_text(const toml::node& node) {
  if (const auto* v = node.as_integer()) return fmt::format("{}", v->get());
  if (const auto* v = node.as_floating_point()) {
    std::string text = fmt::format("{}", v->get());
    if (text.find_first_of(".einf") == std::string::npos) text += ".0";
    return text;
  }
  if (const auto* v = node.as_boolean()) return flag_text(v->get());
  if (const auto* v = node.as_string()) {
    std::string quoted = "\"";
    for (const char c : v->get()) {
      if (c == '"' || c == '\\') quoted += '\\';
      if (static_cast<unsigned char>(c) >= 32) quoted += c;
    }
    return quoted + "\"";
  }
  if (const auto* v = node.as_array()) {
    std::vector<std::string> items;
    for (const toml::node& item : *v) items.push_back(toml_text(item));
    return fmt::format("[{}]", fmt::join(items, ", "));
  }
  return node.is_table() ? "a table" : "a date or time";
}

std::vector<std::pair<std::string, const toml::node*>> in_order_of_file(const toml::table& table) {
  std::vector<std::pair<std::string, const toml::node*>> all;
  for (const auto& [key, node] : table) all.emplace_back(key.str(), &node);
  // A table that dotted keys have made stands where its first key does.
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.second->source().begin < b.second->source().begin; });
  return all;
}

}  // namespace artu::sim
