#include "sim/sweep/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "sim/html/json_file.h"
#include "sim/report/csv.h"
#include "sim/report/durable.h"
#include "sim/sweep/database.h"
#include "traces/error.h"
#include "traces/trace.h"

namespace artu::sim {
namespace {

using Json = nlohmann::ordered_json;

Json parse(const std::string& file) {
  Json json = read_json(file);
  if (!json.is_object()) throw InputError(file, "is no JSON object; the folder without this point would be right");
  return json;
}

/// Of a point's file that somebody has changed.
InputError changed(const std::string& file) {
  return InputError(file, "is not what artu run writes; the folder without this point would be right");
}

std::string cell_text(const Json& cell) {
  if (cell.is_null()) return "";
  return csv_field(cell.is_string() ? cell.get<std::string>() : cell.dump());
}

/// Tables are text: "[1, 2]".
Json value_cell(const std::string& value) {
  const Json json = json_of_toml(value);
  return json.is_array() ? Json(value) : json;
}

/// The blocks' counters of a point that has a report.
std::vector<Counter> counters_of(const SweepFolder& folder, const SweepPoint& point) {
  std::vector<Counter> counters;
  std::error_code error;
  const std::string stats = folder.point(point.name) + "/stats.json";
  if (!std::filesystem::exists(stats, error)) return counters;
  const Json json = parse(stats);
  try {
    for (const auto& [block, names] : json.at("totals").at("blocks").items()) {
      for (const auto& [name, value] : names.items()) counters.push_back({point.number, block, name, value});
    }
  } catch (const Json::exception&) {
    throw changed(stats);
  }
  return counters;
}

}  // namespace

std::string error_json(const std::string& status, const std::string& message) {
  const Json json = {{"status", status}, {"message", message}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

SweepResult result_of(const SweepFolder& folder, const SweepPoint& point) {
  SweepResult result{point.number, "ok", {}};
  if (!point.refusal.empty()) {
    result.status = "refused";
    return result;
  }
  if (!folder.finished(point.name)) {
    result.status = "pending";
    return result;
  }
  const std::string place = folder.point(point.name);
  std::error_code error;
  if (std::filesystem::exists(place + "/error.json", error)) {
    const Json json = parse(place + "/error.json");
    const auto status = json.find("status");
    for (const char* known : {"refused", "dead-lock", "internal"}) {
      if (status == json.end() || *status != known) continue;
      result.status = known;
      return result;
    }
    throw changed(place + "/error.json");
  }
  const Json stats = parse(place + "/stats.json");
  try {
    result.figures = figures_of(stats);
    for (const Json& frame : stats.at("frames")) {
      if (!frame.at("violations").empty()) result.status = "violated";
    }
  } catch (const Json::exception&) {
    throw changed(place + "/stats.json");
  }
  return result;
}

std::vector<SweepResult> results_of(const SweepFolder& folder, const std::vector<SweepPoint>& points) {
  std::vector<SweepResult> results;
  for (const SweepPoint& point : points) results.push_back(result_of(folder, point));
  return results;
}

SweepTable table_of(const Grid& grid, const std::vector<SweepPoint>& points, const std::vector<SweepResult>& results) {
  SweepTable table;
  table.columns = {"point", "folder", "scene", "frames", "size", "fidelity", "status"};
  for (const Axis& axis : grid.axes) table.columns.push_back(axis.parameter.path);
  if (grid.screen) table.columns.emplace_back("confirms");
  std::map<std::string, std::size_t> places;
  for (const SweepResult& result : results) {
    for (const auto& [name, value] : result.figures) {
      if (places.emplace(name, table.columns.size()).second) table.columns.push_back(name);
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SweepPoint& point = points[i];
    const SourceOptions& source = grid.scenes[point.scene];
    const bool trace = traces::is_trace(source.path);
    std::vector<Json> row = {point.number,
                             "points/" + point.name,
                             grid.scene_names[point.scene],
                             source.frames.value_or(trace ? "first" : "0:1"),
                             source.size.value_or(trace ? "" : "640x360"),
                             fidelity_name(point.fidelity),
                             results[i].status};
    for (const std::string& value : point.values) row.push_back(value_cell(value));
    if (grid.screen) row.push_back(point.confirms ? Json(*point.confirms) : Json());
    row.resize(table.columns.size());
    for (const auto& [name, value] : results[i].figures) row[places.at(name)] = value;
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string csv_of(const SweepTable& table) {
  std::string out;
  const auto line = [&out](const auto& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) out += (i == 0 ? "" : ",") + cell_text(cells[i]);
    out += '\n';
  };
  line(table.columns);
  for (const auto& row : table.rows) line(row);
  return out;
}

void write_tables(const SweepFolder& folder, const SweepTable& table, const std::vector<SweepPoint>& points) {
  write_durably(folder.file("points.csv"), csv_of(table));
  const std::string name = folder.file("points.sqlite"), partial = name + ".partial";
  {
    Database database(partial);
    database.add_points(table);
    for (const SweepPoint& point : points) {
      if (point.refusal.empty() && folder.finished(point.name)) database.add_counters(counters_of(folder, point));
    }
    database.close();
  }
  rename_durably(partial, name);
}

}  // namespace artu::sim
