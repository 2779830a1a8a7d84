#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <system_error>

#include "sim/command/commands.h"
#include "sim/command/progress.h"
#include "sim/command/run_frames.h"
#include "sim/config/dump.h"
#include "sim/report/run_folder.h"
#include "sim/sweep/front.h"
#include "sim/sweep/plan.h"
#include "sim/sweep/runner.h"
#include "sim/sweep/scenes.h"
#include "sim/sweep/slurm.h"
#include "sim/sweep/summary.h"
#include "sim/sweep/sweep_folder.h"
#include "sim/sweep/table.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

struct Part {
  std::uint32_t own = 0, all = 1;
};

Part parse_part(const std::string& text) {
  if (text.empty()) return {};
  unsigned long long own = 0, all = 0;
  char* end = nullptr;
  const bool digits = text.find_first_not_of("0123456789/") == std::string::npos && text.size() < 20;
  if (digits) own = std::strtoull(text.c_str(), &end, 10);
  const bool slash = digits && end != text.c_str() && *end == '/' && end[1] != '\0';
  if (slash) all = std::strtoull(end + 1, &end, 10);
  if (!slash || *end != '\0' || own >= all || all > 1'000'000) {
    throw InputError("--part", fmt::format("\"{}\" is not K/T with K below T; 0/4, for example, would be right", text));
  }
  return {static_cast<std::uint32_t>(own), static_cast<std::uint32_t>(all)};
}

/// Simulates a point, in a process of its own, and publishes what it leaves.
class PointRun {
 public:
  PointRun(const Grid& grid, const SweepFolder& folder) : grid_(grid), folder_(folder) {}

  void simulate(const SweepPoint& point, SweepScene& scene) const {
    const std::string place = folder_.unfinished(point.name);
    try {
      RunOptions run = run_of(grid_, point);
      run.output = place;
      run.force = true;  // what another process with our number may have left
      RunReport report(run);
      run_frames(run, point.unit, scene.source, &scene.trees, scene.memory, &report);
    } catch (const FileError&) {  // neither a full disk nor too little memory is a property of the point
      throw;
    } catch (const std::system_error&) {
      throw;
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const InputError& error) {
      if (std::string(error.what()).compare(0, place.size(), place) == 0) throw;  // nor is who else writes its folder
      fail(point, "refused", error.what());
    } catch (const DeadLock& error) {
      fail(point, "dead-lock", error.what());
    } catch (const std::exception& error) {
      fail(point, "internal", error.what());
    }
    folder_.publish(point.name);
  }

 private:
  void fail(const SweepPoint& point, const char* status, const std::string& message) const {
    RunFolder folder(folder_.unfinished(point.name), true);
    write_file(folder.file("error.json"), error_json(status, message));
    write_file(folder.file("config.toml"), dump_config(point.unit));
    folder.commit();
  }

  const Grid& grid_;
  const SweepFolder& folder_;
};

class Sweep {
 public:
  Sweep(const SweepOptions& options, const SweepPoints& plan, SweepScenes& scenes, const SweepFolder& folder)
      : options_(options), part_(parse_part(options.part)), plan_(plan), scenes_(scenes), folder_(folder) {}

  /// Those of the points that are this process's and not finished.
  void simulate(const std::vector<SweepPoint>& points) {
    std::vector<const SweepPoint*> pending;
    std::vector<std::size_t> uses(plan_.grid.scenes.size(), 0);
    for (const SweepPoint& point : points) {
      const bool wanted = point.refusal.empty() && point.number % part_.all == part_.own;
      if (!wanted || folder_.finished(point.name)) continue;
      pending.push_back(&point);
      ++uses[point.scene];
    }
    if (options_.slurm) {
      submit(pending);
      return;
    }
    // One scene after the other, so that each is loaded once.
    std::stable_sort(pending.begin(), pending.end(),
                     [](const SweepPoint* a, const SweepPoint* b) { return a->scene < b->scene; });
    Progress progress(pending.size(), "points", options_.quiet);
    const PointRun run(plan_.grid, folder_);
    std::size_t scene = 0;
    PointWork work;
    work.prepare = [&](std::size_t i) {
      if (pending[i]->scene != scene) scenes_.release(scene);
      scene = pending[i]->scene;
      build_trees(*pending[i]);
    };
    work.work = [&](std::size_t i) { run.simulate(*pending[i], scenes_.of(pending[i]->scene)); };
    work.done = [&](std::size_t) { progress.one_done(); };
    run_points(pending.size(), options_.jobs.value_or(1), work);
  }

  /// The points of the front, which are to be simulated with the grid's own fidelity.
  std::vector<SweepPoint> screened() const {
    const auto results = results_of(folder_, plan_.points);
    std::vector<std::uint32_t> numbers;
    for (const SweepResult& result : results) {
      if (result.status == "pending") return {};  // the front is not known yet
    }
    const SweepTable table = table_of(plan_.grid, plan_.points, results);
    for (const std::size_t place : front_of(table, plan_.grid.objectives, plan_.grid.screen->margin)) {
      numbers.push_back(plan_.points[place].number);
    }
    return confirmations(plan_, numbers);
  }

 private:
  void submit(const std::vector<const SweepPoint*>& pending) {
    Progress progress(pending.size(), "points", options_.quiet);
    std::uint64_t told = 0;
    SlurmJob job;
    job.grid = options_.grid;
    job.parts = std::min<std::uint32_t>(maximum_parts, static_cast<std::uint32_t>(plan_.points.size()));
    job.at_once = options_.jobs.value_or(0);
    for (const SweepPoint* point : pending) job.numbers.push_back(point->number);
    job.finished = [&] {
      return static_cast<std::uint64_t>(std::count_if(
          pending.begin(), pending.end(), [&](const SweepPoint* point) { return folder_.finished(point->name); }));
    };
    job.progress = [&](std::uint64_t finished) {
      for (; told < finished; ++told) progress.one_done();
    };
    run_on_slurm(folder_, job);
    folder_.remove_unfinished();
  }

  /// Where the scene cannot have such a tree, the point's process finds that out again, and says so.
  void build_trees(const SweepPoint& point) {
    SweepScene& scene = scenes_.of(point.scene);
    try {
      scene.trees.of(point.unit.accel);
    } catch (const InputError&) {
    }
  }

  const SweepOptions& options_;
  const Part part_;
  const SweepPoints& plan_;
  SweepScenes& scenes_;
  const SweepFolder& folder_;
};

int code_of(const Grid& grid, const std::vector<SweepResult>& results, const std::vector<SweepPoint>& points) {
  const auto some = [&](const char* status) {
    for (std::size_t i = 0; i < results.size(); ++i) {
      if (results[i].status == status && points[i].refusal.empty()) return true;
    }
    return false;
  };
  if (some("internal") || some("violated")) return exit_internal;
  if (some("dead-lock")) return exit_dead_lock;
  return some("refused") && !grid.skip_invalid ? exit_input : exit_fine;
}

void report_failures(const SweepFolder& folder, const std::vector<SweepPoint>& points,
                     const std::vector<SweepResult>& results) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string& status = results[i].status;
    if (status == "ok" || status == "pending" || !points[i].refusal.empty()) continue;
    const char* file = status == "violated" ? "stats.json" : "error.json";
    fmt::print(stderr, "error: {}: {}; {} says more\n", folder.point(points[i].name), status, file);
  }
}

/// The points of a search are in the folder: scripts/search adds to them.
SweepPoints read_plan(const SweepOptions& options) {
  Grid grid = read_grid(options.grid);
  const std::string searched = options.output + "/search.toml";
  std::error_code error;
  if (grid.design != Design::search || !std::filesystem::exists(searched, error)) return plan_of(std::move(grid));
  const auto rows = read_points(searched, grid);
  return plan_of(std::move(grid), rows);
}

SweepFolder::Begin begin_of(const SweepOptions& options) {
  const int given =
      (options.resume ? 1 : 0) + (options.force ? 1 : 0) + (options.collect ? 1 : 0) + (options.part.empty() ? 0 : 1);
  if (given > 1) {
    throw InputError("command line", "--resume, --force, --collect and --part exclude each other; one would be right");
  }
  if (options.slurm && (options.collect || !options.part.empty())) {
    throw InputError("--backend", "is not for --collect and --part; local would be right");
  }
  if (options.resume) return options.slurm ? SweepFolder::Begin::share : SweepFolder::Begin::resume;
  if (options.force) return SweepFolder::Begin::replace;
  return options.collect || !options.part.empty() ? SweepFolder::Begin::take_part : SweepFolder::Begin::fresh;
}

}  // namespace

int sweep_command(const SweepOptions& options) {
  const SweepFolder::Begin begin = begin_of(options);
  parse_part(options.part);
  const SweepPoints plan = read_plan(options);
  const Grid& grid = plan.grid;
  if (options.dry_run) {
    fmt::print("{}", describe(plan));
    return exit_fine;
  }
  if (options.output.empty()) {
    throw InputError("command line", "the folder of the sweep is missing; -o DIR, or --dry-run, would be right");
  }
  check_sweep_folder(options.output, begin);
  SweepScenes scenes(grid.scenes);
  if (begin == SweepFolder::Begin::fresh || begin == SweepFolder::Begin::replace) {
    for (std::size_t scene = 0; scene < grid.scenes.size(); ++scene) scenes.of(scene);  // a bad one is found now
  }
  const SweepFolder folder(options.output, to_json(plan), begin);
  Sweep sweep(options, plan, scenes, folder);
  std::vector<SweepPoint> points = plan.points;
  if (!options.collect) sweep.simulate(points);
  if (grid.screen) {
    const std::vector<SweepPoint> front = sweep.screened();
    if (!options.collect) sweep.simulate(front);
    points.insert(points.end(), front.begin(), front.end());
  }
  print_notes(scenes.log(), options.quiet);
  if (!options.part.empty()) return exit_fine;

  const std::vector<SweepResult> results = results_of(folder, points);
  const SweepTable table = table_of(grid, points, results);
  write_tables(folder, table, points);
  report_failures(folder, points, results);
  if (!options.quiet) {
    fmt::print("{}{}{:<12}{}\n", describe(plan), summary_of(plan, table, results), "report", folder.name());
  }
  return code_of(grid, results, points);
}

}  // namespace artu::sim
