#include "sim/compare/color_spaces.h"

#include <algorithm>
#include <cmath>

namespace artu::sim {
namespace {

using Matrix = std::array<Triple, 3>;

// Linear sRGB to XYZ, as ratios of integers from the primaries' chromaticities and D65; and its inverse.
constexpr double d1 = 24577794, d2 = 12288897, d3 = 73733382;
constexpr Matrix to_xyz = {{{10135552 / d1, 8788810 / d1, 4435075 / d1},
                            {2613072 / d2, 8788810 / d2, 887015 / d2},
                            {1425312 / d3, 8788810 / d3, 70074185 / d3}}};
constexpr Matrix from_xyz = {{{3.241003275, -1.537398934, -0.498615861},
                              {-0.969224334, 1.875930071, 0.041554224},
                              {0.055639423, -0.204011202, 1.057148933}}};
constexpr Triple white = {0.950428545, 1.0, 1.088900371};

Triple product(const Matrix& m, const Triple& v) {
  Triple out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return out;
}

/// XYZ over the white's.
Triple relative_xyz(const Triple& linear_rgb) {
  Triple xyz = product(to_xyz, linear_rgb);
  for (std::size_t i = 0; i < 3; ++i) xyz[i] /= white[i];
  return xyz;
}

Triple opponents(const Triple& xyz) { return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])}; }

}  // namespace

double linear_of(std::uint8_t code) {
  const double c = code / 255.0;
  return c > 0.04045 ? std::pow((c + 0.055) / 1.055, 2.4) : c / 12.92;
}

Triple ycxcz_of(const Triple& linear_rgb) { return opponents(relative_xyz(linear_rgb)); }

Triple linear_rgb_of_ycxcz(const Triple& c) {
  const double y = (c[0] + 16) / 116;
  return product(from_xyz, {(y + c[1] / 500) * white[0], y * white[1], (y - c[2] / 200) * white[2]});
}

Triple hunt_lab_of(const Triple& linear_rgb) {
  constexpr double delta = 6.0 / 29;
  Triple xyz = relative_xyz(linear_rgb);
  for (double& v : xyz) v = v > delta * delta * delta ? std::cbrt(v) : v / (3 * delta * delta) + 4.0 / 29;
  const Triple lab = opponents(xyz);
  return {lab[0], 0.01 * lab[0] * lab[1], 0.01 * lab[0] * lab[2]};
}

}  // namespace artu::sim
