#include "sim/sweep/grid_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "traces/error.h"

namespace artu::sim {
namespace {

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_number(const ParameterInfo& parameter) {
  return parameter.kind == ParameterKind::integer || parameter.kind == ParameterKind::real;
}

}  // namespace

AxisReader::AxisReader(const TomlFile& file, const Configuration& base)
    : file_(file),
      base_(base),
      parameters_(parameter_list()),
      base_values_(parameter_values(base.unit())),
      groups_(parameter_groups()) {}

void AxisReader::collect(const toml::table& table, const std::string& prefix, const std::vector<std::string>& keys,
                         std::vector<Entry>& entries) const {
  for (const auto& [key, node] : in_order_of_file(table)) {
    if (prefix.empty() && has(keys, key)) continue;
    const std::string path = prefix.empty() ? key : prefix + "." + key;
    const auto known =
        std::find_if(parameters_.begin(), parameters_.end(), [&](const ParameterInfo& p) { return p.path == path; });
    if (known != parameters_.end()) {
      entries.push_back({static_cast<std::size_t>(known - parameters_.begin()), node});
    } else if (node->is_table() && has(groups_, path)) {
      collect(*node->as_table(), path, keys, entries);
    } else {
      file_.refuse(*node, unknown_parameter(path));
    }
  }
}

std::vector<AxisReader::Entry> AxisReader::entries(const toml::table& section,
                                                   const std::vector<std::string>& keys) const {
  std::vector<Entry> all;
  collect(section, "", keys, all);
  std::stable_sort(all.begin(), all.end(),
                   [](const Entry& a, const Entry& b) { return a.node->source().begin < b.node->source().begin; });
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (all[i].parameter != all[j].parameter) continue;
      file_.refuse(*all[i].node,
                   fmt::format("{} is given twice; once would be right", parameters_[all[i].parameter].path));
    }
  }
  return all;
}

std::string AxisReader::value(const Entry& entry, const toml::node& node) const {
  Configuration scratch = base_;
  scratch.set(parameters_[entry.parameter].path + "=" + toml_text(node), file_.place(node));
  return parameter_values(scratch.unit())[entry.parameter];
}

Axis AxisReader::axis(const Entry& entry) const {
  Axis axis;
  axis.parameter = parameters_[entry.parameter];
  axis.place = file_.place(*entry.node);
  axis.base = base_values_[entry.parameter];
  return axis;
}

std::vector<std::string> AxisReader::values(const Entry& entry, const toml::node& list) const {
  const std::string& path = parameters_[entry.parameter].path;
  std::vector<std::string> values;
  for (const toml::node& item : file_.array(list, path)) {
    values.push_back(value(entry, item));
    if (std::count(values.begin(), values.end(), values.back()) > 1) {
      file_.refuse(item, fmt::format("{} has the value {} twice; once would be right", path, values.back()));
    }
  }
  if (values.empty()) file_.refuse(list, fmt::format("{} has no value; one or more would be right", path));
  return values;
}

void AxisReader::interval(const Entry& entry, const toml::node& low, const toml::node& high, Axis& axis) const {
  axis.low = std::strtod(value(entry, low).c_str(), nullptr);
  axis.high = std::strtod(value(entry, high).c_str(), nullptr);
  if (axis.low >= axis.high) {
    file_.refuse(high, fmt::format("{} ends at {}, not above its beginning {}; a larger end would be right",
                                   axis.parameter.path, toml_text(high), toml_text(low)));
  }
}

std::vector<Axis> AxisReader::lists(const toml::table& section) const {
  std::vector<Axis> axes;
  for (const Entry& entry : entries(section, {})) {
    axes.push_back(axis(entry));
    axes.back().values = values(entry, *entry.node);
  }
  return axes;
}

std::vector<Axis> AxisReader::intervals(const toml::table& section, const std::vector<std::string>& keys) const {
  std::vector<Axis> axes;
  for (const Entry& entry : entries(section, keys)) {
    Axis axis = this->axis(entry);
    const std::string& path = axis.parameter.path;
    const toml::table* table = entry.node->as_table();
    if (table != nullptr) file_.allow(*table, {"low", "high", "scale", "values"});
    if (table != nullptr && table->contains("values")) {
      if (table->size() > 1) file_.refuse(*entry.node, path + " has values and an interval; one would be right");
      axis.values = values(entry, *table->get("values"));
    } else if (!is_number(axis.parameter)) {
      axis.values = values(entry, *entry.node);
    } else if (table != nullptr) {
      if (!table->contains("low") || !table->contains("high")) {
        file_.refuse(*entry.node, path + " lacks its low or its high end; both would be right");
      }
      interval(entry, *table->get("low"), *table->get("high"), axis);
      if (const toml::node* scale = table->get("scale")) {
        const std::string name = file_.text(*scale, "scale");
        axis.logarithmic = name == "log";
        if (!axis.logarithmic && name != "linear") {
          file_.refuse(*scale, fmt::format("scale = \"{}\" is none; linear or log would be right", name.substr(0, 80)));
        }
        if (axis.logarithmic && axis.low <= 0) {
          file_.refuse(*scale, fmt::format("{} begins at {}, which has no logarithm; a low end above 0 would be right",
                                           path, axis.low));
        }
      }
    } else {
      const toml::array& ends = file_.array(*entry.node, path);
      if (ends.size() != 2) {
        file_.refuse(*entry.node, fmt::format("{} has {} ends; [low, high], or {{ values = [...] }}, would be right",
                                              path, ends.size()));
      }
      interval(entry, *ends.get(0), *ends.get(1), axis);
    }
    axes.push_back(axis);
  }
  return axes;
}

void AxisReader::points(const toml::array& sections, std::vector<Axis>& axes,
                        std::vector<std::vector<std::string>>& rows, std::vector<std::string>& places) const {
  std::vector<std::vector<Entry>> all;
  const bool open = axes.empty();
  const auto find = [&axes](const std::string& path) {
    return std::find_if(axes.begin(), axes.end(), [&](const Axis& a) { return a.parameter.path == path; });
  };
  for (const toml::node& section : sections) {
    all.push_back(entries(file_.table(section, "point"), {}));
    for (const Entry& entry : all.back()) {
      if (find(parameters_[entry.parameter].path) != axes.end()) continue;
      if (!open) file_.refuse(*entry.node, parameters_[entry.parameter].path + " is no axis of the search");
      axes.push_back(axis(entry));
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::vector<std::string> row;
    for (const Axis& axis : axes) row.push_back(axis.base);
    for (const Entry& entry : all[i]) {
      const auto axis = find(parameters_[entry.parameter].path);
      row[static_cast<std::size_t>(axis - axes.begin())] = value(entry, *entry.node);
    }
    places.push_back(file_.place(*sections.get(i)));
    const auto same = std::find(rows.begin(), rows.end(), row);
    if (open && same != rows.end()) {
      throw InputError(places.back(), fmt::format("the point is that of line {} again; once would be right",
                                                  places[same - rows.begin()].substr(places.back().rfind(':') + 1)));
    }
    rows.push_back(row);
  }
  if (!open) return;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    for (const auto& row : rows) {
      if (!has(axes[i].values, row[i])) axes[i].values.push_back(row[i]);
    }
  }
}

}  // namespace artu::sim
