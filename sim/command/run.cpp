#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>

#include "sim/analytic/constants.h"
#include "sim/command/commands.h"
#include "sim/command/example_scene.h"
#include "sim/command/frame_source.h"
#include "sim/command/progress.h"
#include "sim/command/run_frames.h"
#include "sim/command/run_report.h"
#include "sim/command/sampled_run.h"
#include "sim/compare/golden_settings.h"
#include "sim/config/configuration.h"
#include "sim/config/dump.h"
#include "sim/config/parameter_list.h"
#include "sim/jobs/processes.h"
#include "sim/report/stats_text.h"
#include "sim/report/summary.h"
#include "sim/scaling/demand.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

/// Every name that a report has, from a run of one triangle.
std::string stats_list(const hw::UnitConfig& unit, SimulationOptions simulation) {
  if (simulation.fidelity == Fidelity::sampled) simulation.fidelity = Fidelity::event;  // the same names
  const traces::Scene scene = example_scene();
  const Totals totals = totals_of(make_simulator(scene, unit, simulation)->run(example_frame()));
  const auto energy = energy_if_known(totals, unit);
  return format_stats_list(totals, unit.clock_mhz, energy ? &*energy : nullptr);
}

/// Prints what was asked for instead of a run; false if nothing was.
bool print_lists(const RunOptions& options, const hw::UnitConfig& unit) {
  if (options.dump_config) fmt::print("{}", dump_config(unit));
  if (options.list_params) fmt::print("{}", format_parameter_list());
  if (options.list_stats) fmt::print("{}", stats_list(unit, options.simulation));
  return options.dump_config || options.list_params || options.list_stats;
}

void report_violations(const FrameReport& frame) {
  for (const std::string& violation : frame.violations) {
    fmt::print(stderr, "error: frame {}: accounting law violated: {}\n", frame.index, violation);
  }
}

/// What every frame of a run goes through.
class FrameRun {
 public:
  FrameRun(const FrameSource& source, FrameSimulator& simulator, const hw::UnitConfig& unit, const ref::Golden* golden,
           const RunOptions& options, const MemoryMeter& memory, RunReport& report)
      : source_(source),
        simulator_(simulator),
        unit_(unit),
        golden_(golden),
        options_(options),
        memory_(memory),
        report_(report) {
    report.begin_pictures(source.range().count(), source.scene().fps);
    if (!report.needs_full()) return;
    ref::Settings settings = golden_settings(unit);
    settings.selective = false;
    every_pixel_ = std::make_unique<ref::Golden>(source.scene(), settings);
  }

  /// One frame at a time in each process: memory does not grow with their number.  In the order of `frames`.
  void simulate(const std::vector<std::uint32_t>& frames, const std::function<void(const FrameReport&)>& take) const {
    const auto work = [&](std::uint64_t task) {
      const traces::Frame frame = source_.frame(frames[task]);
      const FrameOutcome outcome = simulator_.run(frame);
      std::optional<FullRender> full;
      if (every_pixel_) full = full_render_of(every_pixel_->render(frame));
      FrameReport written = report_.write(outcome, unit_, full ? &*full : nullptr);
      if (golden_) compare_frame(golden_->render(frame), outcome, written.check);
      written.totals.memory = memory_.use();
      return written;
    };
    in_order<FrameReport>(frames.size(), options_.jobs, work,
                          [&](std::uint64_t, const FrameReport& frame) { take(frame); });
  }

  /// In the order of the frames.
  void add(const FrameReport& frame, RunResult& result) const {
    report_.add(frame, unit_);
    sim::add(result.check, frame.check);
    report_violations(frame);
    result.lawful = result.lawful && frame.violations.empty();
  }

 private:
  const FrameSource& source_;
  FrameSimulator& simulator_;
  const hw::UnitConfig& unit_;
  const ref::Golden* const golden_;
  const RunOptions& options_;
  const MemoryMeter& memory_;
  RunReport& report_;
  std::unique_ptr<ref::Golden> every_pixel_;  // the same pixels as the unit's full render, without its cycles
};

RunResult run_all(const FrameRun& run, const FrameRange& range, bool quiet) {
  RunResult result;
  std::vector<std::uint32_t> frames(range.count());
  std::iota(frames.begin(), frames.end(), range.first);
  Progress progress(range.count(), "frames", quiet);
  run.simulate(frames, [&](const FrameReport& frame) {
    run.add(frame, result);
    add(result.sum, frame.totals);
    progress.one_done();
  });
  return result;
}

/// Draws frames until their number is what was asked for, or the error.
RunResult run_sample(const FrameRun& run, const FrameSource& source, const hw::UnitConfig& unit,
                     const SimulationOptions& simulation, const RunOptions& options) {
  const FrameRange range = source.range();
  const Looks looks = look_at_frames(source, unit, simulation, options.jobs, options.quiet);
  FrameSample sample(looks.costs, options.simulation.seed);
  std::vector<FrameReport> frames;
  std::vector<Totals> totals;
  const std::uint32_t most = sample.different_frames();
  std::uint32_t wanted = options.sample.first(most);
  do {
    std::vector<std::uint32_t> next = sample.draw(wanted);
    for (std::uint32_t& frame : next) frame += range.first;
    Progress progress(next.size(), "frames simulated", options.quiet);
    run.simulate(next, [&](const FrameReport& frame) {
      frames.push_back(frame);
      totals.push_back(frame.totals);
      progress.one_done();
    });
    wanted = options.sample.needed(most, sample.drawn(), estimate_cycles(sample, totals).relative_error());
  } while (wanted > sample.drawn());
  RunResult result;
  result.different_frames = most;
  result.sum = estimate_totals(sample, totals, unit);
  result.sum.simulation_seconds += looks.seconds;
  std::sort(frames.begin(), frames.end(), [](const FrameReport& a, const FrameReport& b) { return a.index < b.index; });
  for (const FrameReport& frame : frames) {
    run.add(frame, result);
    result.simulated.push_back(frame.index);
  }
  return result;
}

/// Options that only a sample has, and those that it cannot honour.
void check_sample(const RunOptions& options) {
  if (options.simulation.fidelity != Fidelity::sampled) {
    if (options.sample_given.empty()) return;
    throw InputError(options.sample_given, "is of --fidelity sampled; that as well would be right");
  }
  SimulationOptions asked = options.simulation;
  if (!options.memory_trace.empty()) asked.memory_observer = [](hw::Cycle, const hw::MemoryRequest&) {};
  if (!options.trace.requests.empty()) asked.watchers.push_back(nullptr);
  check_options(asked);
  if (options.pictures && options.pictures->has(Picture::animation)) {
    throw InputError("--pictures",
                     "with --fidelity sampled most frames of an animation are not there; others, or event, "
                     "would be right");
  }
}

void check_seed(const RunOptions& options) {
  const SimulationOptions& asked = options.simulation;
  if (!options.seed_given || asked.random_stall || asked.shuffle_ticks || asked.fidelity == Fidelity::sampled) return;
  throw InputError("--seed", "nothing is drawn; with --random-stall, --shuffle or --fidelity sampled would be right");
}

/// A trace is of one frame, and of a cycle at least.
void check_trace(const TraceOptions& trace, const FrameRange& range) {
  if (trace.requests.empty()) return;
  if (range.count() != 1) {
    throw InputError("--trace", fmt::format("is of one frame, and there are {}; --frames {} would be right",
                                            range.count(), range.first));
  }
  if (trace.window.from >= trace.window.to) {
    throw InputError("--trace-to", fmt::format("{} is not behind --trace-from {}; a later cycle would be right",
                                               trace.window.to, trace.window.from));
  }
}

void print_traces(const TraceSet& traces) {
  for (const std::string& line : traces.summary()) fmt::print("{:<12}{}\n", "trace", line);
}

void print_dry_run(const RunOptions& options, const FrameSource& source) {
  const traces::Scene& scene = source.scene();
  fmt::print("{}: {}x{}, frames {}:{}, {} static triangles; fine, nothing was run\n", options.source.path, scene.width,
             scene.height, source.range().first, source.range().last, scene.static_geometry.triangle_count());
}

}  // namespace

RunResult run_frames(const RunOptions& options, const hw::UnitConfig& unit, const FrameSource& source,
                     StaticTrees* shared_trees, MemoryMeter& memory, RunReport* report) {
  SimulationOptions simulation = options.simulation;
  // Throws nothing: what is thrown in the simulation kernel comes out of it as another error.
  simulation.log_sink = [](const std::string& line) { std::fputs(("log: " + line + "\n").c_str(), stderr); };
  const bool sampled = simulation.fidelity == Fidelity::sampled;
  StaticTrees trees(source.scene());
  simulation.static_trees = shared_trees;
  if (sampled) {
    simulation.fidelity = Fidelity::event;  // of the frames that are simulated
    if (shared_trees == nullptr) simulation.static_trees = &trees;
  }
  if (report) {
    simulation.memory_observer = report->memory_observer();
    simulation.watchers = report->watchers();
    simulation.window = options.trace.window;
  }
  const auto simulator = make_simulator(source.scene(), unit, simulation,
                                        [&source](std::uint32_t index) { return source.first_from(index); });
  memory.loaded();
  if (report == nullptr) return {};
  std::unique_ptr<ref::Golden> golden;
  if (options.check) golden = std::make_unique<ref::Golden>(source.scene(), golden_settings(unit));

  const FrameRun run(source, *simulator, unit, golden.get(), options, memory, *report);
  RunResult result =
      sampled ? run_sample(run, source, unit, simulation, options) : run_all(run, source.range(), options.quiet);
  Manifest manifest = manifest_of(options.command, options.source.path, source);
  manifest.checked = options.check;
  manifest.simulation = options.simulation;
  manifest.simulated_frames = result.simulated;
  manifest.different_frames = result.different_frames;
  report->finish(result.sum, unit, manifest, golden ? &result.check : nullptr);
  return result;
}

int run_command(const RunOptions& options) {
  const Configuration configuration = Configuration::of(options.config_files, options.assignments);
  const hw::UnitConfig& unit = configuration.unit();
  if (print_lists(options, unit)) return exit_fine;
  if (options.source.path.empty()) {
    throw InputError("command line",
                     "SCENE or TRACE is missing; a .glb, .gltf, .obj, .stage.toml or a trace would be "
                     "right");
  }
  require_file(options.source.path);
  if (options.pictures && options.pictures->has(Picture::cycles) && !is_exact(options.simulation.fidelity) &&
      options.simulation.fidelity != Fidelity::sampled) {
    throw InputError("--pictures", fmt::format("cycles of a pixel are not known with --fidelity {}; others, or event, "
                                               "would be right",
                                               fidelity_name(options.simulation.fidelity)));
  }
  check_sample(options);
  check_seed(options);
  std::unique_ptr<RunReport> report;
  if (!options.dry_run) report = std::make_unique<RunReport>(options);

  std::vector<std::string> log;
  MemoryMeter memory;
  const FrameSource source(options.source, log);
  check_trace(options.trace, source.range());
  const RunResult result = run_frames(options, unit, source, nullptr, memory, report.get());
  if (options.dry_run) {
    print_notes(log, options.quiet);
    print_dry_run(options, source);
    return exit_fine;
  }

  if (report->traces().empty()) {
    log.push_back(fmt::format("--trace-from {} is behind the frame's {} cycles: the trace is empty",
                              options.trace.window.from, result.sum.cycles));
  }
  const std::uint64_t pixels = std::uint64_t{source.scene().width} * source.scene().height;
  if (result.sum.fidelity == Fidelity::analytic && pixels < calibrated_pixels) {
    log.push_back(fmt::format("analytic is calibrated on pictures of 320x180; of {}x{} the intervals may be too narrow",
                              source.scene().width, source.scene().height));
  }
  print_notes(log, options.quiet);
  if (!options.quiet) {
    const traces::Scene& scene = source.scene();
    const auto energy = energy_if_known(result.sum, unit);
    // What screening is for; the whole list is in the report.
    const bool screening = result.sum.fidelity == Fidelity::analytic;
    const auto limits = screening ? demands_if_known(result.sum, unit) : std::vector<Demand>();
    fmt::print("{}", format_summary({options.source.path, scene.width, scene.height, source.range().first,
                                     source.range().last, unit.clock_mhz},
                                    result.sum, energy ? &*energy : nullptr, limits));
    if (!result.simulated.empty()) {
      fmt::print("{:<12}{} frames simulated for all {}, of which {} are different\n", "sample", result.simulated.size(),
                 result.sum.frames, result.different_frames);
    }
    print_traces(report->traces());
    if (!report->folder().empty()) fmt::print("{:<12}{}\n", "report", report->folder());
  }
  if (options.check && !(options.quiet && result.check.passed())) fmt::print("{}", describe(result.check));
  if (!result.lawful) return exit_internal;
  return options.check && !result.check.passed() ? exit_mismatch : exit_fine;
}

}  // namespace artu::sim
