#include "sim/command/sampled_run.h"

#include "sim/command/progress.h"
#include "sim/jobs/processes.h"

namespace artu::sim {

Looks look_at_frames(const FrameSource& source, const hw::UnitConfig& unit, const SimulationOptions& simulation,
                     std::uint32_t jobs, bool quiet) {
  FrameCosts map(source.scene(), unit, simulation, [&](std::uint32_t index) { return source.first_from(index); });
  const FrameRange range = source.range();
  Looks looks;
  Progress progress(range.count(), "frames looked at", quiet);
  in_order<FrameCosts::Look>(
      range.count(), jobs,
      [&](std::uint64_t task) { return map.at(source.frame(range.first + static_cast<std::uint32_t>(task))); },
      [&](std::uint64_t, const FrameCosts::Look& look) {
        looks.costs.push_back(look.cost);
        looks.seconds += look.seconds;
        progress.one_done();
      });
  return looks;
}

}  // namespace artu::sim
