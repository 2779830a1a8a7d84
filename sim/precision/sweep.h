// Frames simulated with every tree and format asked for, and how far their pictures are from those of 23 bits and from
// a rendering in binary64.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "hw/unit_config.h"
#include "sim/precision/image_error.h"
#include "traces/frame.h"

namespace artu::sim {

struct SweepPlan {
  hw::UnitConfig unit;  // its formats and trees are replaced by these:
  std::vector<hw::TreeKind> trees;
  std::vector<hw::PrecisionConfig> formats;
  std::uint32_t first_frame = 0, last_frame = 1;  // half-open
  std::uint32_t jobs = 1;                         // processes that the frames are shared out to
};

/// Each tree and format once, in the order given; 23 bits, what the others are compared with, is added if it is not
/// among them.
SweepPlan completed(SweepPlan plan);

inline bool is_binary32(const hw::PrecisionConfig& f) { return f.box == 23 && f.triangle == 23 && f.shading == 23; }

/// "12", or "12/15/10" (box, triangle, shading) where the three differ.
std::string format_name(const hw::PrecisionConfig& format);

/// Of one tree and format; counts are sums over the frames.
struct SweepRow {
  hw::TreeKind tree = hw::TreeKind::bvh2;
  hw::PrecisionConfig format;
  std::uint64_t cycles = 0, rays = 0, node_visits = 0, box_tests = 0, triangle_tests = 0, dram_bytes = 0;
  double traced_share = 0;  // of the pixels
  double run_time = 0;      // of the simulation, against that of 23 bits with the first tree in the same run
  ImageError from_binary32, from_binary64;
};

struct SweepHooks {
  std::function<traces::Frame(std::uint32_t index)> frame;
  /// The frame of the index, or the first one after it; for tree_builder.refit alone.
  std::function<traces::Frame(std::uint32_t index)> frame_from;
  /// Takes a picture of a frame: the name is "binary64", or "M" and the format's name; trees do not change it.  Those
  /// of binary64 and of 23 bits come first and in this process, the others in the process that simulated them.
  std::function<void(const std::string& name, std::uint32_t index, const Image&)> picture;
  /// After each of `sweep_steps`, in this process.
  std::function<void()> progress;
};

std::uint64_t sweep_steps(const SweepPlan& plan);

/// Rows of the first tree come first, each tree's in the order of the formats.  `plan` is a completed one.  Throws
/// std::logic_error where two trees show different pictures or an accounting law is violated.
std::vector<SweepRow> run_sweep(const traces::Scene& scene, const SweepPlan& plan, const SweepHooks& hooks);

}  // namespace artu::sim
