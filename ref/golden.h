// The golden model: the frame that the unit must produce, from Embree and code of its own.
//
// Written from docs/arithmetic.md and docs/selective-rendering.md alone; never includes hw/.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ref/precision.h"
#include "traces/frame.h"

namespace artu::ref {

enum class Passes : std::uint8_t { horizontal_vertical, average };
enum class Count : std::uint8_t { per_class, merged };
enum class Compare : std::uint8_t { dynamic_vs_static, reference_count };
enum class Magnitude : std::uint8_t { fixed, proportional, progressive };
enum class Metric : std::uint8_t { max_channel, sum, luma };
enum class HitClass : std::uint8_t { none, miss, static_geometry, dynamic_geometry };
enum class Decision : std::uint8_t { sampled, interpolated, traced };

/// The settings that change pixels (docs/selective-rendering.md, docs/arithmetic.md section 7).
struct Settings {
  bool selective = true;
  int stride = 2;  // 2, 4 or 8
  Passes passes = Passes::horizontal_vertical;
  std::string policy = "attention";
  std::array<int, 4> policy_registers{};  // 0 ... 255
  bool adaptive = true;
  Count count = Count::per_class;
  Compare compare = Compare::dynamic_vs_static;
  int reference_count = 2;  // 0 ... 8
  Metric metric = Metric::max_channel;
  Magnitude magnitude = Magnitude::proportional;
  int reference = 16, minimum = 0, maximum = 255;  // thresholds, 8-bit codes
  int step = 2;
  std::array<int, 8> table{1, 2, 4, 7, 11, 16, 22, 29};
  unsigned max_depth = 3;          // of reflection and refraction rays; 0 = none
  float min_weight = 0.00390625f;  // of a reflection or refraction ray, to be traced
  bool every_light = false;        // counts a shadow ray for lights that add nothing as well, where there is a ray
  Precision precision;             // docs/arithmetic.md section 1
};

/// One pixel's record; the columns of docs/selective-rendering.md.
struct Pixel {
  std::uint8_t pass = 0;
  HitClass hit_class = HitClass::none;
  std::uint8_t n_static = 0, n_dynamic = 0;
  std::int16_t threshold = -1, difference = -1;
  Decision decision = Decision::sampled;
  std::uint8_t r = 0, g = 0, b = 0;
  std::int64_t primitive = -1;
  std::uint32_t t_bits = 0;
};

struct RayCounts {
  std::uint64_t primary = 0, shadow = 0, reflection = 0, refraction = 0;
};

struct Result {
  std::uint32_t width = 0, height = 0;
  std::vector<Pixel> pixels;  // row by row
  RayCounts rays;
  double trace_seconds = 0;  // the rendering alone: no Embree tree builds
};

/// Holds what the frames of a scene share (Embree's static tree).
class Golden {
 public:
  /// `scene` must outlive the model; it and the frames are taken as `traces::validate` leaves them.
  /// Throws std::invalid_argument where a width of `settings.precision` is outside of 7 ... 23, and where `check`
  /// (ref/selective.h) does.
  Golden(const traces::Scene& scene, const Settings& settings);
  ~Golden();
  /// Frames may come in any order; the result depends on scene, settings and frame alone.  Not for two threads at a
  /// time: the static tree is built on the first frame and again where a frame's camera needs wider boxes.
  Result render(const traces::Frame& frame) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace artu::ref
