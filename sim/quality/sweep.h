// The same frames with every policy and reference threshold: what each costs, and how far it is from the full render.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hw/unit_config.h"
#include "sim/compare/attribution.h"
#include "sim/compare/regions.h"
#include "traces/frame.h"

namespace artu::sim {

struct QualityPoint {
  std::string policy;
  std::uint32_t reference = 0;  // the threshold that the policy moves
  hw::UnitConfig unit;
  bool shown = false;  // its pictures are asked for
};

struct QualityPlan {
  hw::UnitConfig full;  // traces every pixel
  std::vector<QualityPoint> points;
  std::uint32_t first_frame = 0, last_frame = 1;  // half-open
  std::size_t worst = 20;                         // pixels that are kept of each point
  std::uint32_t jobs = 1;                         // processes that the frames are shared out to

  std::uint32_t frames() const { return last_frame - first_frame; }
  /// Frames to simulate.
  std::uint64_t steps() const { return std::uint64_t{frames()} * (1 + points.size()); }
};

/// Sums over the frames.
struct QualityRow {
  std::string policy;
  std::optional<std::uint32_t> reference;  // of a point
  bool shown = false;
  std::uint64_t pixels = 0, traced = 0;  // traced with the sampled ones
  std::uint64_t rays = 0;                // of all kinds
  // Without a value where the picture was computed and not simulated.
  std::optional<std::uint64_t> cycles, dram_bytes;
  std::optional<double> picojoules;
  Errors errors;
  std::optional<Attribution> attribution;  // of a point

  double traced_share() const { return static_cast<double>(traced) / static_cast<double>(pixels); }
  /// "attention-16"
  std::string name() const;
};

struct QualityHooks {
  std::function<traces::Frame(std::uint32_t index)> frame;
  /// The frame of the index, or the first one after it; for tree_builder.refit alone.
  std::function<traces::Frame(std::uint32_t index)> frame_from;
  /// Takes each frame of a row that is shown, in the process that simulated it; what it returns goes to `part`.
  std::function<std::string(const QualityRow& row, const FrameOutcome& outcome, const FullRender& full)> picture;
  /// In the order of the frames, in this process.
  std::function<void(const QualityRow& row, const std::string& part)> part;
  /// After each of the plan's steps, in this process.
  std::function<void()> progress;
};

/// Rows: full, low-resolution, checkerboard, then the points in their order.  Throws std::logic_error where an
/// accounting law is violated.
std::vector<QualityRow> run_quality(const traces::Scene& scene, const QualityPlan& plan, const QualityHooks& hooks);

}  // namespace artu::sim
