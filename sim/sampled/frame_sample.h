// Which frames of a sequence are simulated, and what follows from them for all.
//
// Frames whose dynamic tree is built, refitted, or neither have little to do with each other: each kind is a stratum,
// with a regression of its own, and the variances are added (Cochran, chapters 5 and 7; degrees of freedom by
// Satterthwaite 1946).  Frames that are equal, such as those of an animation that repeats, are one member that weighs
// as many; a member that is a quarter of its kind or more is always simulated, and no estimate.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/sampled/regression.h"

namespace artu::sim {

enum class FrameKind : std::uint8_t { nothing_built, built, refitted };
inline constexpr std::size_t frame_kinds = 3;

/// Frames that have the same are simulated with the same result.  Only zeros: equal to no other.
using FrameDigest = std::array<char, 64>;

/// What is known of a frame without its simulation.
struct FrameCost {
  double work = 0;  // goes up and down with its cycles
  FrameKind kind = FrameKind::nothing_built;
  FrameDigest digest{};
};

/// With the ends of its 95 % interval.
struct TotalEstimate {
  double value = 0, low = 0, high = 0;
  /// Half the interval as a share of the value.
  double relative_error() const;
};

class FrameSample {
 public:
  /// Of all frames.
  FrameSample(const std::vector<FrameCost>& costs, std::uint64_t seed);

  std::uint32_t frames() const { return frames_; }
  /// Of equal ones the first; the others are never drawn.
  std::uint32_t different_frames() const { return different_; }
  std::uint32_t drawn() const { return static_cast<std::uint32_t>(sample_.size()); }
  /// Draws about as many different ones in all, spread over kinds and time; returns those that were not in the sample
  /// before.
  std::vector<std::uint32_t> draw(std::uint32_t wanted);
  /// In the order in which they were drawn.
  const std::vector<std::uint32_t>& sample() const { return sample_; }
  /// Of all frames; `figures` of the sample, in its order, and not negative.
  TotalEstimate total(const std::vector<double>& figures) const;

 private:
  struct Stratum {
    std::vector<std::uint32_t> order;  // frames, as they are drawn
    std::uint32_t drawn = 0;
    std::vector<double> costs;        // of all, in that order
    std::vector<double> weights;      // how many frames each stands for
    std::vector<std::size_t> places;  // of its frames in the sample
  };
  /// A frame, and how many are equal to it, itself included.
  struct Member {
    std::uint32_t frame;
    double work, weight;
  };
  void add_stratum(const std::vector<Member>& members, std::uint64_t seed);

  std::uint32_t frames_, different_ = 0;
  std::vector<Stratum> strata_;
  std::vector<std::uint32_t> sample_;
  std::vector<double> weights_;                  // of the sample
  std::vector<RegressionEstimator> estimators_;  // by stratum
};

}  // namespace artu::sim
