// The same frames on several units.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/command/frame_source.h"
#include "sim/command/progress.h"
#include "sim/driver/frame_simulator.h"
#include "sim/report/numbers.h"

namespace artu::sim {

/// Sums over the frames, by unit; the scene's static trees are built once for each kind.  An accounting law that does
/// not hold is a std::logic_error.
std::vector<Totals> totals_by_unit(const FrameSource& source, const std::vector<hw::UnitConfig>& units,
                                   Fidelity fidelity, std::uint32_t jobs, Progress& progress);

}  // namespace artu::sim
