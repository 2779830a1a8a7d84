#include "sim/import/stage_toml.h"

#include <algorithm>
#include <cmath>

#include "sim/config/edit_distance.h"
#include "sim/config/toml_texts.h"
#include "sim/import/resource_path.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

std::string line_of(const std::string& file, const toml::node& node) {
  const auto line = node.source().begin.line;
  return line ? file + ":" + std::to_string(line) : file;
}

}  // namespace

std::string suggest(const std::string& name, const std::vector<std::string>& known) {
  if (known.empty()) return "; there are none";
  std::vector<std::string> names;
  for (const std::string& k : known) {
    if (!k.empty()) names.push_back(k);
  }
  if (names.empty()) return "; it has " + std::to_string(known.size()) + ", and none has a name";
  const auto nearest = std::min_element(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return edit_distance(name, a) < edit_distance(name, b);
  });
  if (resembles(name, *nearest)) return ", did you mean \"" + *nearest + "\"?";
  std::string list;
  for (std::size_t i = 0; i < names.size() && i < 20; ++i) list += (i ? ", " : "") + names[i];
  return "; there are: " + list + (names.size() > 20 ? ", ..." : "");
}

toml::table parse_stage_file(const std::string& path) {
  const std::vector<std::uint8_t> bytes = read_file(path, std::uint64_t{1} << 24);
  try {
    toml::table root = toml::parse(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    refuse_zero_bytes(root, [&path](const toml::node& node) { return line_of(path, node); });
    return root;
  } catch (const toml::parse_error& e) {
    throw InputError(path + ":" + std::to_string(e.source().begin.line), std::string(e.description()));
  }
}

StageTable::StageTable(const std::string& file, const std::string& name, const toml::table& table,
                       const std::vector<std::string>& keys)
    : file_(file), name_(name), table_(&table) {
  for (const auto& [key, value] : *table_) {
    const std::string found(key.str());
    if (std::find(keys.begin(), keys.end(), found) == keys.end())
      throw InputError(file_ + ":" + std::to_string(key.source().begin.line),
                       "unknown key \"" + found + "\" in " + name_ + suggest(found, keys));
  }
}

std::string StageTable::where(const std::string& key) const {
  const toml::node* value = table_->get(key);
  return value ? line_of(file_, *value) : where();
}

std::string StageTable::where() const { return line_of(file_, *table_); }

void StageTable::fail(const std::string& key, const std::string& what) const {
  throw InputError(where(key), name_ + ": " + key + " " + what);
}

double StageTable::number(const std::string& key, double otherwise) const {
  if (!has(key)) return otherwise;
  const auto value = table_->get(key)->value<double>();
  if (!table_->get(key)->is_number() || !value || !std::isfinite(*value)) fail(key, "must be a finite number");
  return *value;
}

double StageTable::number(const std::string& key, double otherwise, double low, double high) const {
  const double value = number(key, otherwise);
  if (!(value >= low && value <= high)) {
    char range[80];
    std::snprintf(range, sizeof range, "is %g; %g ... %g is allowed", value, low, high);
    fail(key, range);
  }
  return value;
}

bool StageTable::boolean(const std::string& key, bool otherwise) const {
  if (!has(key)) return otherwise;
  if (!table_->get(key)->is_boolean()) fail(key, "must be true or false");
  return table_->get(key)->value_or(otherwise);
}

std::string StageTable::text(const std::string& key, const std::string& otherwise) const {
  if (!has(key)) return otherwise;
  if (!table_->get(key)->is_string()) fail(key, "must be a string");
  return table_->get(key)->value_or(otherwise);
}

glm::dvec3 StageTable::vector(const std::string& key, const glm::dvec3& otherwise) const {
  if (!has(key)) return otherwise;
  const toml::array* array = table_->get(key)->as_array();
  if (!array || array->size() != 3) fail(key, "must be an array of three numbers");
  glm::dvec3 out;
  for (int i = 0; i < 3; ++i) {
    const toml::node& element = (*array)[static_cast<std::size_t>(i)];
    const auto value = element.value<double>();
    if (!element.is_number() || !value || !(std::abs(*value) <= 1e12))
      fail(key, "must be an array of three finite numbers, none over 1e12");
    out[i] = *value;
  }
  return out;
}

glm::dvec3 StageTable::required_vector(const std::string& key) const {
  if (!has(key)) throw InputError(where(), name_ + ": " + key + " = [x, y, z] is missing");
  return vector(key, {});
}

glm::dvec3 StageTable::vector_or_number(const std::string& key, const glm::dvec3& otherwise) const {
  if (has(key) && table_->get(key)->is_number()) return glm::dvec3(number(key, 0, -1e12, 1e12));
  return vector(key, otherwise);
}

std::vector<std::string> StageTable::texts(const std::string& key) const {
  if (!has(key)) return {};
  if (table_->get(key)->is_string()) return {text(key, "")};
  const toml::array* array = table_->get(key)->as_array();
  std::vector<std::string> out;
  for (std::size_t i = 0; array && i < array->size(); ++i) {
    const auto value = (*array)[i].value<std::string>();
    if (!value) fail(key, "must be a string or an array of strings");
    out.push_back(*value);
  }
  if (!array) fail(key, "must be a string or an array of strings");
  return out;
}

std::vector<StageTable> StageTable::tables(const std::string& key, const std::vector<std::string>& keys) const {
  std::vector<StageTable> out;
  if (!has(key)) return out;
  const toml::array* array = table_->get(key)->as_array();
  if (!array) fail(key, "must be an array of tables, written [[" + key + "]]");
  for (const toml::node& element : *array) {
    if (!element.is_table()) fail(key, "must be an array of tables, written [[" + key + "]]");
    out.emplace_back(file_, "[[" + key + "]]", *element.as_table(), keys);
  }
  return out;
}

std::optional<StageTable> StageTable::table(const std::string& key, const std::vector<std::string>& keys) const {
  if (!has(key)) return std::nullopt;
  if (!table_->get(key)->is_table()) fail(key, "must be a table, written [" + key + "]");
  return StageTable(file_, "[" + key + "]", *table_->get(key)->as_table(), keys);
}

}  // namespace artu::sim
