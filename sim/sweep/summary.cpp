#include "sim/sweep/summary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "sim/sweep/front.h"

namespace artu::sim {
namespace {

constexpr std::size_t rows_shown = 20;

std::string values_text(const Axis& axis) {
  if (!axis.is_interval()) return fmt::format("{}", fmt::join(axis.values, ", "));
  return fmt::format("{} ... {}{}", axis.low, axis.high, axis.logarithmic ? ", logarithmic" : "");
}

std::string figure_text(const nlohmann::ordered_json& cell) {
  if (cell.is_number_float()) return fmt::format("{:.6g}", cell.get<double>());
  return cell.is_string() ? cell.get<std::string>() : cell.dump();
}

/// Right-aligned columns, the last one left.
std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows[0].size());
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string out;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i + 1 == row.size()) {
        line += "  " + row[i];
      } else {
        line += fmt::format("{}{:>{}}", i == 0 ? "" : "  ", row[i], widths[i]);
      }
    }
    out += line + "\n";
  }
  return out;
}

}  // namespace

std::string describe(const SweepPoints& plan) {
  const Grid& grid = plan.grid;
  std::string out;
  const auto line = [&out](const char* name, const std::string& text) { out += fmt::format("{:<12}{}\n", name, text); };
  const std::size_t refused = static_cast<std::size_t>(std::count_if(
      plan.points.begin(), plan.points.end(), [](const SweepPoint& point) { return !point.refusal.empty(); }));
  std::string points = fmt::format("{} ({})", plan.points.size(), design_name(grid.design));
  if (refused != 0) points += fmt::format(", {} of which the unit refuses", refused);
  if (plan.repeated != 0) points += fmt::format(", {} samples left out that fall on others", plan.repeated);
  line("points", points);
  line("scenes", fmt::format("{}", fmt::join(grid.scene_names, ", ")));
  line("fidelity", grid.screen ? fmt::format("{}, the front {}", fidelity_name(grid.screen->fidelity),
                                             fidelity_name(grid.simulation.fidelity))
                               : fidelity_name(grid.simulation.fidelity));
  std::vector<std::string> objectives;
  for (const Objective& o : grid.objectives) objectives.push_back(o.figure + (o.maximise ? " (maximise)" : ""));
  if (!objectives.empty()) line("objectives", fmt::format("{}", fmt::join(objectives, ", ")));
  std::size_t width = 0;
  for (const Axis& axis : grid.axes) width = std::max(width, axis.parameter.path.size());
  for (std::size_t a = 0; a < grid.axes.size(); ++a) {
    line(a == 0 ? "parameters" : "",
         fmt::format("{:<{}}  {}", grid.axes[a].parameter.path, width, values_text(grid.axes[a])));
  }
  return out;
}

std::string summary_of(const SweepPoints& plan, const SweepTable& table, const std::vector<SweepResult>& results) {
  const Grid& grid = plan.grid;
  std::map<std::string, std::size_t> counts;
  for (const SweepResult& result : results) ++counts[result.status];
  std::vector<std::string> parts;
  for (const auto& [status, count] : counts) parts.push_back(fmt::format("{} {}", count, status));
  std::string out = fmt::format("{:<12}{}\n", "points", fmt::join(parts, ", "));
  // With a screen the front is that of the points that were confirmed: an estimate is not held against a figure.
  SweepTable exact = table;
  if (grid.screen) {
    exact.rows.erase(std::remove_if(exact.rows.begin(), exact.rows.end(),
                                    [&](const auto& row) { return row[5] != fidelity_name(grid.simulation.fidelity); }),
                     exact.rows.end());
  }
  const std::vector<std::size_t> front = front_of(exact, grid.objectives);
  if (front.empty()) return out;
  std::vector<std::string> names{"point"};
  for (const Axis& axis : grid.axes) names.push_back(axis.parameter.path);
  for (const Objective& objective : grid.objectives) {
    if (std::find(names.begin(), names.end(), objective.figure) == names.end()) names.push_back(objective.figure);
  }
  names.emplace_back("scene");
  std::vector<std::vector<std::string>> rows{names};
  for (std::size_t i = 0; i < std::min(front.size(), rows_shown); ++i) {
    std::vector<std::string>& row = rows.emplace_back();
    for (const std::string& name : names) {
      const auto column = std::find(exact.columns.begin(), exact.columns.end(), name) - exact.columns.begin();
      row.push_back(figure_text(exact.rows[front[i]][static_cast<std::size_t>(column)]));
    }
  }
  out += "\nnot dominated by another point:\n" + aligned(rows);
  if (front.size() > rows_shown) out += fmt::format("and {} more\n", front.size() - rows_shown);
  return out + "\n";
}

}  // namespace artu::sim
