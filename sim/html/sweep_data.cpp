#include "sim/html/sweep_data.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "sim/html/csv_file.h"
#include "sim/html/json_file.h"
#include "sim/html/run_data.h"
#include "traces/error.h"

namespace artu::sim {
namespace fs = std::filesystem;
namespace {

using Kind = JsonShape::Kind;
constexpr int sweep_schema = 1;

OrderedJson cell_of(const std::string& text) {
  if (text.empty()) return {};
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return text;
  return value;
}

OrderedJson read_description(const std::string& file) {
  OrderedJson description = read_json(file);
  const JsonShape shape(file);
  if (shape.need(description, {"schema"}, Kind::number) != sweep_schema) {
    shape.fail("has schema " + description["schema"].dump(), "schema 1");
  }
  for (const OrderedJson& parameter : shape.need(description, {"parameters"}, Kind::array)) {
    shape.need(parameter, {"path"}, Kind::string);
    shape.need(parameter, {"unit"}, Kind::string);
  }
  for (const OrderedJson& objective : shape.need(description, {"objectives"}, Kind::array)) {
    for (const char* key : {"figure", "goal"}) shape.need(objective, {key}, Kind::string);
  }
  shape.need(description, {"design", "kind"}, Kind::string);
  if (description.contains("screen")) shape.need(description, {"screen", "fidelity"}, Kind::string);
  return description;
}

}  // namespace

bool is_sweep_folder(const std::string& folder) {
  std::error_code ignored;
  return fs::exists(fs::path(folder) / "sweep.json", ignored);
}

nlohmann::ordered_json sweep_data(const std::string& folder) {
  const std::string table = (fs::path(folder) / "points.csv").string();
  const OrderedJson description = read_description((fs::path(folder) / "sweep.json").string());
  std::error_code ignored;
  if (!fs::exists(table, ignored)) {
    throw InputError(folder, "has no points.csv yet; a sweep that has ended would be right");
  }
  const CsvFile csv = read_csv(table);
  for (const char* column : {"point", "folder", "scene", "fidelity", "status"}) {
    if (std::find(csv.columns.begin(), csv.columns.end(), column) == csv.columns.end()) {
      throw InputError(table + ":1",
                       std::string("has no column ") + column + "; the file as artu wrote it would be right");
    }
  }
  if (csv.rows.empty()) throw InputError(table, "has no points; a sweep of one or more would be right");
  OrderedJson rows = OrderedJson::array();
  for (const std::vector<std::string>& row : csv.rows) {
    OrderedJson cells = OrderedJson::array();
    for (const std::string& cell : row) cells.push_back(cell_of(cell));
    rows.push_back(std::move(cells));
  }
  return {{"name", folder_name(folder)},
          {"folder", folder},
          {"description", description},
          {"columns", csv.columns},
          {"rows", std::move(rows)}};
}

}  // namespace artu::sim
