// What the frames of a sequence cost, for a sample of them.
#pragma once

#include <vector>

#include "sim/command/frame_source.h"
#include "sim/sampled/frame_costs.h"

namespace artu::sim {

struct Looks {
  std::vector<FrameCost> costs;  // of all frames
  double seconds = 0;            // wall time
};

Looks look_at_frames(const FrameSource& source, const hw::UnitConfig& unit, const SimulationOptions& simulation,
                     std::uint32_t jobs, bool quiet);

}  // namespace artu::sim
