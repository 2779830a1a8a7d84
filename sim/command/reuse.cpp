#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "hw/watch/request_watch.h"
#include "sim/command/commands.h"
#include "sim/command/frame_source.h"
#include "sim/command/progress.h"
#include "sim/command/run_report.h"
#include "sim/config/configuration.h"
#include "sim/config/dump.h"
#include "sim/jobs/processes.h"
#include "sim/jobs/results.h"
#include "sim/report/file.h"
#include "sim/report/gnuplot.h"
#include "sim/report/run_folder.h"
#include "sim/reuse/reuse_report.h"

namespace artu::sim {

/// Of a frame, or of all.
struct Reuse {
  std::vector<CacheReuse> kinds;
  Totals totals;
};

template <class A>
void transfer(A& archive, CacheReuse& reuse) {
  pass_all(archive, reuse.name, reuse.caches, reuse.lines, reuse.requests, reuse.first_uses, reuse.distances,
           reuse.windows);
}

template <class A>
void transfer(A& archive, Reuse& reuse) {
  pass_all(archive, reuse.kinds, reuse.totals);
}

namespace {

/// The profile and the model have counted the same requests, or one of them is wrong.
void check(const std::vector<CacheReuse>& kinds, const std::vector<ModelMisses>& model, std::uint32_t frame) {
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i].requests == model[i].requests) continue;
    throw std::logic_error(fmt::format("frame {}: {} requests of {} were seen, {} served", frame, kinds[i].requests,
                                       kinds[i].name, model[i].requests));
  }
}

Reuse reuse_of(const FrameSource& source, const hw::UnitConfig& unit, const ReuseOptions& options) {
  StaticTrees trees(source.scene());
  trees.of(unit.accel);
  ReuseProfile profile(unit, options.window);
  SimulationOptions simulation;
  simulation.static_trees = &trees;
  simulation.request_sink = &profile;
  const auto simulator = make_simulator(source.scene(), unit, simulation,
                                        [&source](std::uint32_t index) { return source.first_from(index); });
  const auto work = [&](std::uint64_t task) {
    const std::uint32_t index = source.range().first + static_cast<std::uint32_t>(task);
    const FrameOutcome outcome = simulator->run(source.frame(index));
    if (!outcome.violations.empty()) {
      throw std::logic_error(fmt::format("frame {}: accounting law violated: {}", index, outcome.violations[0]));
    }
    Reuse frame{profile.end_frame(index, outcome.cycles), totals_of(outcome)};
    check(frame.kinds, misses_of_model(frame.kinds, frame.totals.statistics), index);
    return frame;
  };
  Progress progress(source.range().count(), "frames", options.quiet);
  Reuse sum;
  in_order<Reuse>(source.range().count(), options.jobs, work, [&](std::uint64_t, const Reuse& frame) {
    add(sum.kinds, frame.kinds);
    add(sum.totals, frame.totals);
    progress.one_done();
  });
  return sum;
}

}  // namespace

int reuse_command(const ReuseOptions& options) {
  std::vector<std::string> log;
  require_file(options.source.path);
  const hw::UnitConfig unit = Configuration::of(options.config_files, options.assignments).unit();
  RunFolder folder =
      options.output.empty() ? RunFolder::next_free(options.source.path) : RunFolder(options.output, options.force);
  const FrameSource source(options.source, log);
  const Reuse reuse = reuse_of(source, unit, options);
  const std::vector<ModelMisses> model = misses_of_model(reuse.kinds, reuse.totals.statistics);

  const std::string title = heading(options.source.path, source);
  write_file(folder.file("reuse.csv"), curves_csv(reuse.kinds));
  write_file(folder.file("working_set.csv"), working_set_csv(reuse.kinds));
  write_file(folder.file("config.toml"), dump_config(unit));
  write_file(folder.file("manifest.json"), to_json(manifest_of(options.command, options.source.path, source)));
  const std::string no_plot = draw_plot(
      folder.partial(), {reuse_plot, reuse_data(reuse.kinds, model), reuse_script(reuse.kinds, title, options.window)});
  folder.commit();

  if (!no_plot.empty()) log.push_back("no plot: " + no_plot);
  print_notes(log, options.quiet);
  if (!options.quiet) {
    fmt::print("{}\n\n{}\n{:<12}{}\n", title, format_reuse(reuse.kinds, model, options.window), "report",
               folder.name());
  }
  return exit_fine;
}

}  // namespace artu::sim
