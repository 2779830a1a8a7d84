// How run time and memory grow with what is asked for: exponents of power laws.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/bench/measure.h"

namespace artu::sim {

/// y = factor * x ^ exponent, by least squares of the logarithms.
struct PowerLaw {
  double factor = 0, exponent = 0;
};

/// At least two different x; all values above 0.
PowerLaw fit_power_law(const std::vector<double>& x, const std::vector<double>& y);

struct GrowthPoint {
  std::uint64_t value = 0;  // pixels, triangles, cores
  std::vector<ModeResult> results;
};

/// One thing that grows while all else stays.
struct Growth {
  std::string what;  // "pixels", "triangles", "cores", "idle cores"
  std::string of;    // the scene, and what stays
  std::vector<GrowthPoint> points;

  /// Of a mode's median time, and of its memory; an exponent of NaN where there are fewer than two points, or one
  /// without a figure.
  PowerLaw time(const std::string& mode) const;
  PowerLaw memory(const std::string& mode) const;
};

/// What growth is measured of.
struct GrowthPlan {
  BenchPlan bench;
  hw::UnitConfig unit;
  std::uint32_t width = 320, height = 180;  // of all points but those of the pixels
  /// The frame of a scene at a size, for pixels and cores.
  struct Loaded {
    traces::Scene scene;
    traces::Frame frame;
  };
  std::function<Loaded(std::uint32_t width, std::uint32_t height)> load;
  std::string scene;  // its name
};

/// A quarter of the plan's picture, half, all, twice and four times as many pixels.
Growth grow_pixels(const GrowthPlan& plan, std::vector<std::string>& notes);
/// A terrain (terrain.h) of 2^9 triangles and more, up to 2^17.
Growth grow_triangles(const GrowthPlan& plan, std::vector<std::string>& notes);
/// 1, 2, 4, 8 and 16 cores that share the work.
Growth grow_cores(const GrowthPlan& plan, std::vector<std::string>& notes);
/// As many, of which one has all the work: the picture is one tile, and a tile goes to one core.
Growth grow_idle_cores(const GrowthPlan& plan, std::vector<std::string>& notes);

}  // namespace artu::sim
