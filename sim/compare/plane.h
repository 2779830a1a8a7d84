// One number a pixel, and separable filters over it.
#pragma once

#include <cstdint>
#include <vector>

namespace artu::sim {

struct Plane {
  std::uint32_t width = 0, height = 0;
  std::vector<double> values;  // row 0 first
};

/// 2 r + 1 weights; the middle one is the pixel's own.
using Kernel = std::vector<double>;

/// The sum over the neighbours, each weighted by `along_x` of its column and `along_y` of its row (a correlation: the
/// kernels are not mirrored).  A pixel beyond the border has the value of the nearest one within.
Plane filtered(const Plane& plane, const Kernel& along_x, const Kernel& along_y);

}  // namespace artu::sim
