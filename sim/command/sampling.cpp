#include <fmt/format.h>

#include <numeric>

#include "sim/command/commands.h"
#include "sim/command/frame_source.h"
#include "sim/command/progress.h"
#include "sim/command/run_report.h"
#include "sim/command/sampled_run.h"
#include "sim/config/configuration.h"
#include "sim/jobs/processes.h"
#include "sim/sampled/trials.h"

namespace artu::sim {

int sampling_command(const SamplingOptions& options) {
  std::vector<std::string> log;
  require_file(options.source.path);
  const hw::UnitConfig unit = Configuration::of(options.config_files, options.assignments).unit();
  const FrameSource source(options.source, log);
  const FrameRange range = source.range();
  StaticTrees trees(source.scene());
  SimulationOptions simulation;
  simulation.static_trees = &trees;
  const Looks looks = look_at_frames(source, unit, simulation, options.jobs, options.quiet);
  const auto simulator = make_simulator(source.scene(), unit, simulation,
                                        [&source](std::uint32_t index) { return source.first_from(index); });
  std::vector<Totals> frames;
  Progress progress(range.count(), "frames simulated", options.quiet);
  in_order<Totals>(
      range.count(), options.jobs,
      [&](std::uint64_t task) {
        return totals_of(simulator->run(source.frame(range.first + static_cast<std::uint32_t>(task))));
      },
      [&](std::uint64_t, const Totals& totals) {
        frames.push_back(totals);
        progress.one_done();
      });
  const Trials trials =
      run_trials(looks.costs, frames, looks.seconds, options.sample, options.seed, options.trials, unit);
  print_notes(log, options.quiet);
  fmt::print("{}\n{} trials; a sample has {:.1f} of {} frames; event takes {:.1f}x its time\n\n",
             heading(options.source.path, source), options.trials, trials.frames_drawn, range.count(),
             trials.time_ratio);
  fmt::print("{:<16}{:>12}{:>13}{:>15}{:>12}\n", "", "mean error", "worst error", "half interval", "covered");
  for (const FigureTrials& f : trials.figures) {
    fmt::print("{:<16}{:>10.3f} %{:>11.3f} %{:>13.3f} %{:>10.1f} %\n", f.name, 100 * f.mean_error, 100 * f.worst_error,
               100 * f.half_interval, 100 * f.covered);
  }
  return exit_fine;
}

}  // namespace artu::sim
