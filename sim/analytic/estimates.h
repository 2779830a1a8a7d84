// What an analytic run reports: counters under the names of the blocks that it stands for, bounds, and intervals.
#pragma once

#include "sim/analytic/cycle_model.h"
#include "sim/driver/frame_outcome.h"

namespace artu::sim {

/// The functional counts; the memory's as estimated; block "bound": no less cycles than this for the passes.
hw::Statistics statistics_of(const hw::UnitConfig& config, const FrameLoad& load, const MemoryCounts& built,
                             const MemoryCounts& all, const CycleEstimate& estimate);

/// Of the figures that are estimates: 95 % of the errors that docs/fidelity.md shows lie in them.
std::vector<Estimate> intervals_of(const FrameOutcome& outcome);

}  // namespace artu::sim
