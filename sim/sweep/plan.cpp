#include "sim/sweep/plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "sim/command/frame_source.h"
#include "sim/config/dump.h"
#include "sim/report/digest.h"
#include "sim/sweep/figures.h"
#include "sim/sweep/samples.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

constexpr std::uint64_t maximum_points = 100'000;

using Rows = std::vector<std::vector<std::string>>;

/// All combinations; the last axis changes fastest.
Rows product(const Grid& grid) {
  std::uint64_t count = 1;
  for (const Axis& axis : grid.axes) {
    count *= axis.values.size();
    if (count > maximum_points) {
      throw InputError(
          axis.place,
          fmt::format("the grid has more than {} points; latin_hypercube or sobol would be right", maximum_points));
    }
  }
  Rows rows;
  for (std::uint64_t i = 0; i < count; ++i) {
    std::vector<std::string> row(grid.axes.size());
    std::uint64_t rest = i;
    for (std::size_t a = grid.axes.size(); a-- > 0; rest /= grid.axes[a].values.size()) {
      row[a] = grid.axes[a].values[rest % grid.axes[a].values.size()];
    }
    rows.push_back(row);
  }
  return rows;
}

Rows rows_of(const Grid& grid, const Rows& searched) {
  if (grid.design == Design::grid) return product(grid);
  if (grid.design == Design::list) return grid.listed;
  if (grid.design == Design::search) return searched;
  const auto sample = grid.design == Design::sobol ? sobol : latin_hypercube;
  Rows rows;
  for (const std::vector<double>& shares : sample(grid.samples, grid.axes.size(), grid.seed)) {
    std::vector<std::string>& row = rows.emplace_back();
    for (std::size_t a = 0; a < shares.size(); ++a) row.push_back(value_at(grid.axes[a], shares[a]));
  }
  return rows;
}

std::string row_text(const Grid& grid, const std::vector<std::string>& row) {
  std::vector<std::string> parts;
  for (std::size_t a = 0; a < row.size(); ++a) parts.push_back(grid.axes[a].parameter.path + " = " + row[a]);
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// Scene and size as they are if the grid does not say.
std::vector<std::string> source_words(const SourceOptions& source) {
  std::vector<std::string> words;
  if (source.frames) words.insert(words.end(), {"--frames", *source.frames});
  if (source.size) words.insert(words.end(), {"--size", *source.size});
  if (source.fps) words.insert(words.end(), {"--fps", fmt::format("{}", *source.fps)});
  return words;
}

void name(const SweepPoints& plan, SweepPoint& point) {
  std::string identity = plan.scene_sha256[point.scene] + "\n" + fidelity_name(point.fidelity) + "\n";
  identity += fmt::format("{}\n", fmt::join(source_words(plan.grid.scenes[point.scene]), " "));
  if (point.fidelity == Fidelity::sampled) identity += fmt::format("{}\n", fmt::join(plan.grid.sample_words, " "));
  identity += plan.grid.fault_words + "\n" + plan.grid.picture_words + "\n" + dump_config(point.unit);
  point.name = fmt::format("{:04}-{}", point.number, sha256_of(identity).substr(0, 8));
}

SweepPoint point_of(const Grid& grid, const std::vector<std::string>& row, const std::string& place) {
  SweepPoint point;
  Configuration configuration = grid.base;
  for (std::size_t a = 0; a < row.size(); ++a) {
    configuration.set(grid.axes[a].parameter.path + "=" + row[a], grid.axes[a].place);
  }
  point.unit = configuration.unit();
  try {
    configuration.check();
  } catch (const InputError& error) {
    point.refusal = error.what();
    if (!grid.skip_invalid) {
      throw InputError("", fmt::format("{}; that is the point {}{}; invalid = \"skip\" would leave such points out",
                                       point.refusal, row_text(grid, row), place.empty() ? "" : " of " + place));
    }
  }
  // A parameter may set others (memory.dram.preset), so what the unit has counts.
  const std::vector<ParameterInfo> parameters = parameter_list();
  const std::vector<std::string> values = parameter_values(point.unit);
  for (const Axis& axis : grid.axes) {
    for (std::size_t p = 0; p < parameters.size(); ++p) {
      if (parameters[p].path == axis.parameter.path) point.values.push_back(values[p]);
    }
  }
  return point;
}

void check_objectives(Grid& grid) {
  std::vector<std::string> known = figure_names(grid.simulation.fidelity);
  if (grid.screen) {
    const std::vector<std::string> screened = figure_names(grid.screen->fidelity);
    const auto lacks = [&](const std::string& figure) {
      return std::find(screened.begin(), screened.end(), figure) == screened.end();
    };
    known.erase(std::remove_if(known.begin(), known.end(), lacks), known.end());
  }
  const auto has = [&known](const std::string& figure) {
    return std::find(known.begin(), known.end(), figure) != known.end();
  };
  if (grid.objectives.empty()) {
    for (const char* figure : {"cycles_per_frame", "energy.frame_uj"}) {
      if (has(figure)) grid.objectives.push_back({figure, false});
    }
  }
  for (const Objective& objective : grid.objectives) {
    if (has(objective.figure)) continue;
    const auto varied = std::find_if(grid.axes.begin(), grid.axes.end(),
                                     [&](const Axis& a) { return a.parameter.path == objective.figure; });
    if (varied == grid.axes.end()) {
      throw InputError(grid.file,
                       fmt::format("the objective \"{}\" is no parameter that is varied, nor a figure that {} "
                                   "has; cycles_per_frame, for example, would be right",
                                   objective.figure.substr(0, 100),
                                   fidelity_name(grid.screen ? grid.screen->fidelity : grid.simulation.fidelity)));
    }
    if (varied->parameter.kind != ParameterKind::integer && varied->parameter.kind != ParameterKind::real) {
      throw InputError(grid.file,
                       fmt::format("the objective {} is no number; one that is would be right", objective.figure));
    }
  }
}

}  // namespace

SweepPoints plan_of(Grid grid, const Rows& searched) {
  SweepPoints plan;
  check_objectives(grid);
  plan.grid = std::move(grid);
  for (const SourceOptions& scene : plan.grid.scenes) plan.scene_sha256.push_back(sha256_of_input(scene.path));
  const Rows rows = rows_of(plan.grid, searched);
  if (rows.size() * plan.grid.scenes.size() > maximum_points) {
    throw InputError(plan.grid.file, fmt::format("has more than {} points; fewer would be right", maximum_points));
  }
  std::set<std::vector<std::string>> known;
  bool some = rows.empty();
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const std::string place = plan.grid.design == Design::list ? plan.grid.listed_places[r] : std::string();
    SweepPoint point = point_of(plan.grid, rows[r], place);
    if (plan.grid.design != Design::search && !known.insert(point.values).second) {
      ++plan.repeated;
      continue;
    }
    point.fidelity = plan.grid.screen ? plan.grid.screen->fidelity : plan.grid.simulation.fidelity;
    some = some || point.refusal.empty();
    for (std::size_t scene = 0; scene < plan.grid.scenes.size(); ++scene) {
      point.scene = scene;
      point.number = static_cast<std::uint32_t>(plan.points.size());
      name(plan, point);
      plan.points.push_back(point);
    }
  }
  if (!some) throw InputError("", plan.points[0].refusal + "; no point of the sweep is valid");
  return plan;
}

std::vector<SweepPoint> confirmations(const SweepPoints& plan, const std::vector<std::uint32_t>& numbers) {
  std::vector<SweepPoint> points;
  for (const std::uint32_t number : numbers) {
    SweepPoint point = plan.points.at(number);
    point.confirms = number;
    point.fidelity = plan.grid.simulation.fidelity;
    point.number = static_cast<std::uint32_t>(plan.points.size() + points.size());
    name(plan, point);
    points.push_back(point);
  }
  return points;
}

RunOptions run_of(const Grid& grid, const SweepPoint& point) {
  RunOptions run;
  run.source = grid.scenes[point.scene];
  run.config_files = grid.config_files;
  run.assignments = grid.assignments;
  for (std::size_t a = 0; a < grid.axes.size(); ++a) {
    run.assignments.push_back(grid.axes[a].parameter.path + "=" + point.values[a]);
  }
  run.simulation = grid.simulation;
  run.simulation.fidelity = point.fidelity;
  run.sample = grid.sample;
  run.pictures = grid.pictures;
  run.quiet = true;

  std::vector<std::string>& words = run.command;
  words = {"artu", "run", run.source.path};
  const auto append = [&words](const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
  };
  append(source_words(run.source));
  for (const std::string& file : run.config_files) append({"-c", file});
  for (const std::string& assignment : run.assignments) append({"--set", assignment});
  append({"--fidelity", fidelity_name(point.fidelity)});
  if (point.fidelity == Fidelity::sampled) append(grid.sample_words);
  if (!grid.fault_words.empty()) append({"--inject-fault", grid.fault_words});
  if (grid.pictures) append({"--pictures", grid.picture_words});
  return run;
}

}  // namespace artu::sim
