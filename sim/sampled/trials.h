// How right `sampled` is: a sequence whose every frame was simulated, sampled again and again with other seeds.
#pragma once

#include <string>
#include <vector>

#include "sim/sampled/sequence.h"

namespace artu::sim {

/// A figure's estimates against its exact value, over all trials.
struct FigureTrials {
  std::string name;
  double mean_error = 0, worst_error = 0;  // absolute, as a share of the exact value
  double half_interval = 0;                // mean, the same
  double covered = 0;                      // share of the trials whose interval holds the exact value
};

struct Trials {
  double frames_drawn = 0;  // mean
  double time_ratio = 0;    // wall time of all frames to that of a sample, looking at all of them included; mean
  std::vector<FigureTrials> figures;
};

/// `frames` are the exact totals of all frames, `look_seconds` the time that their costs took.  Seeds seed, seed + 1
/// ...
Trials run_trials(const std::vector<FrameCost>& costs, const std::vector<Totals>& frames, double look_seconds,
                  const SampleSize& size, std::uint64_t seed, std::uint32_t count, const hw::UnitConfig& unit);

}  // namespace artu::sim
