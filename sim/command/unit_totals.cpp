#include "sim/command/unit_totals.h"

#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "sim/jobs/processes.h"
#include "sim/jobs/results.h"

namespace artu::sim {

std::vector<Totals> totals_by_unit(const FrameSource& source, const std::vector<hw::UnitConfig>& units,
                                   Fidelity fidelity, std::uint32_t jobs, Progress& progress) {
  StaticTrees trees(source.scene());
  for (const hw::UnitConfig& unit : units) trees.of(unit.accel);
  SimulationOptions options;
  options.fidelity = fidelity;
  options.static_trees = &trees;
  const std::uint32_t frames = source.range().count();
  std::size_t present = units.size();  // the simulator's; the frames of a unit come one after the other
  std::unique_ptr<FrameSimulator> simulator;
  const auto work = [&](std::uint64_t task) {
    if (present != task / frames) {
      present = task / frames;
      simulator.reset();
      simulator = make_simulator(source.scene(), units[present], options,
                                 [&source](std::uint32_t index) { return source.first_from(index); });
    }
    const std::uint32_t index = source.range().first + static_cast<std::uint32_t>(task % frames);
    const FrameOutcome outcome = simulator->run(source.frame(index));
    if (!outcome.violations.empty()) {
      throw std::logic_error(fmt::format("frame {}: accounting law violated: {}", index, outcome.violations[0]));
    }
    return totals_of(outcome);
  };
  std::vector<Totals> sums(units.size());
  in_order<Totals>(std::uint64_t{frames} * units.size(), jobs, work, [&](std::uint64_t task, const Totals& totals) {
    add(sums[task / frames], totals);
    progress.one_done();
  });
  return sums;
}

}  // namespace artu::sim
