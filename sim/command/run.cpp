#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <optional>

#include "sim/command/commands.h"
#include "sim/command/example_scene.h"
#include "sim/command/frame_source.h"
#include "sim/command/progress.h"
#include "sim/command/run_report.h"
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
std::string stats_list(const hw::UnitConfig& unit, const SimulationOptions& simulation) {
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

struct RunResult {
  Totals sum;
  CheckResult check;
  bool lawful = true;  // no accounting law is violated
};

void report_violations(const FrameReport& frame) {
  for (const std::string& violation : frame.violations) {
    fmt::print(stderr, "error: frame {}: accounting law violated: {}\n", frame.index, violation);
  }
}

/// One frame at a time in each process: memory does not grow with their number.
RunResult run_frames(const FrameSource& source, FrameSimulator& simulator, const hw::UnitConfig& unit,
                     const ref::Golden* golden, const RunOptions& options, const MemoryMeter& memory,
                     RunReport& report) {
  RunResult result;
  const FrameRange range = source.range();
  report.begin_pictures(range.count(), source.scene().fps);
  std::unique_ptr<ref::Golden> every_pixel;  // the same pixels as the unit's full render, without its cycles
  if (report.needs_full()) {
    ref::Settings settings = golden_settings(unit);
    settings.selective = false;
    every_pixel = std::make_unique<ref::Golden>(source.scene(), settings);
  }
  const auto work = [&](std::uint64_t task) {
    const traces::Frame frame = source.frame(range.first + static_cast<std::uint32_t>(task));
    const FrameOutcome outcome = simulator.run(frame);
    std::optional<FullRender> full;
    if (every_pixel) full = full_render_of(every_pixel->render(frame));
    FrameReport written = report.write(outcome, unit, full ? &*full : nullptr);
    if (golden) compare_frame(golden->render(frame), outcome, written.check);
    written.totals.memory = memory.use();
    return written;
  };
  Progress progress(range.count(), "frames", options.quiet);
  in_order<FrameReport>(range.count(), options.jobs, work, [&](std::uint64_t, const FrameReport& frame) {
    report.add(frame, unit);
    add(result.sum, frame.totals);
    add(result.check, frame.check);
    report_violations(frame);
    result.lawful = result.lawful && frame.violations.empty();
    progress.one_done();
  });
  return result;
}

void print_dry_run(const RunOptions& options, const FrameSource& source) {
  const traces::Scene& scene = source.scene();
  fmt::print("{}: {}x{}, frames {}:{}, {} static triangles; fine, nothing was run\n", options.source.path, scene.width,
             scene.height, source.range().first, source.range().last, scene.static_geometry.triangle_count());
}

}  // namespace

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
  if (options.pictures && options.pictures->has(Picture::cycles) && !is_exact(options.simulation.fidelity)) {
    throw InputError("--pictures", fmt::format("cycles of a pixel are not known with --fidelity {}; others, or event, "
                                               "would be right",
                                               fidelity_name(options.simulation.fidelity)));
  }
  std::unique_ptr<RunReport> report;
  if (!options.dry_run) report = std::make_unique<RunReport>(options);

  std::vector<std::string> log;
  MemoryMeter memory;
  const FrameSource source(options.source, log);
  SimulationOptions simulation = options.simulation;
  simulation.log_sink = [](const std::string& line) { fmt::print(stderr, "log: {}\n", line); };
  if (report) simulation.memory_observer = report->memory_observer();
  const auto simulator = make_simulator(source.scene(), unit, simulation,
                                        [&source](std::uint32_t index) { return source.first_from(index); });
  memory.loaded();
  if (options.dry_run) {
    print_notes(log, options.quiet);
    print_dry_run(options, source);
    return exit_fine;
  }
  std::unique_ptr<ref::Golden> golden;
  if (options.check) golden = std::make_unique<ref::Golden>(source.scene(), golden_settings(unit));

  const RunResult result = run_frames(source, *simulator, unit, golden.get(), options, memory, *report);
  Manifest manifest = manifest_of(options.command, options.source.path, source);
  manifest.checked = options.check;
  manifest.simulation = options.simulation;
  report->finish(result.sum, unit, manifest, golden ? &result.check : nullptr);

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
    if (!report->folder().empty()) fmt::print("{:<12}{}\n", "report", report->folder());
  }
  if (golden && !(options.quiet && result.check.passed())) fmt::print("{}", describe(result.check));
  if (!result.lawful) return exit_internal;
  return golden && !result.check.passed() ? exit_mismatch : exit_fine;
}

}  // namespace artu::sim
