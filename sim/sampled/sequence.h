// The figures of a sequence from some of its frames (docs/fidelity.md, "sampled").
#pragma once

#include <vector>

#include "sim/report/numbers.h"
#include "sim/sampled/frame_sample.h"

namespace artu::sim {

/// How many frames are simulated: a share, or as many as the error asks for.
struct SampleSize {
  double share = 0;            // 0: none given
  double target_error = 0.01;  // of the cycles: half the 95 % interval
  /// Frames that are simulated first, of so many different ones.
  std::uint32_t first(std::uint32_t frames) const;
  /// How many of them are needed in all if so many have given this error.
  std::uint32_t needed(std::uint32_t frames, std::uint32_t drawn, double error) const;
};

/// Figures of all frames: sums, rounded, and an estimate with its interval for each that is counted; what is the
/// largest of a frame is that of the sample.  `totals` are those of the sample's frames.  The estimate
/// `energy.frame_uj` is a frame's mean.
Totals estimate_totals(const FrameSample& sample, const std::vector<Totals>& totals, const hw::UnitConfig& unit);

/// Of the cycles alone.
TotalEstimate estimate_cycles(const FrameSample& sample, const std::vector<Totals>& totals);

}  // namespace artu::sim
