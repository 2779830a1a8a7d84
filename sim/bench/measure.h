// How long the modes take for one frame, and how much memory: each in a process of its own, in turns.
//
// The golden model is one of the modes.  A process loads nothing (it is forked when the scene is there), builds its
// trees and renders the frame once without being timed; then all modes take turns, one at a time and in an order that
// changes from round to round, so that what else the machine does falls on all of them.  Times are those of the models
// alone: no loading, no tree builds.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hw/unit_config.h"
#include "sim/driver/fidelity.h"
#include "traces/frame.h"

namespace artu::sim {

/// "golden", or the name of a fidelity.
inline constexpr const char* golden_mode = "golden";

struct BenchPlan {
  std::vector<std::string> modes;  // in the order of the tables
  std::uint32_t repeats = 5;       // rounds, timed
  std::uint64_t seed = 1;          // of the order in which modes take turns
};

struct Interval {
  double low = 0, high = 0;
};

/// What one mode gives for one frame.
struct ModeResult {
  std::string mode;
  std::vector<double> seconds;  // of the rounds, in their order
  std::optional<double> cycles;
  std::optional<Interval> interval;  // 95 %, of cycles that are an estimate
  std::uint64_t primary_rays = 0, node_visits = 0;
  std::uint64_t peak_bytes = 0;  // memory on top of the loaded scene: its trees, the model, the frame

  double median() const;
  /// The middle half of the rounds, (upper - lower quartile) / median; 0 for one round.
  double spread() const;
};

struct BenchFrame {
  const traces::Scene& scene;
  const traces::Frame& frame;
  hw::UnitConfig unit;
};

/// A mode that cannot simulate the frame is not among the results; why goes to `notes`.
std::vector<ModeResult> measure(const BenchFrame& frame, const BenchPlan& plan, std::vector<std::string>& notes);

/// Of values that need not be sorted; `share` 0.5 is the median, linear between two.  At least one value.
double quantile(std::vector<double> values, double share);

/// Null where the mode was not measured.
const ModeResult* find(const std::vector<ModeResult>& results, const std::string& mode);

}  // namespace artu::sim
