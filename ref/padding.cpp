#include "ref/padding.h"

#include <cmath>

namespace artu::ref {
namespace {

constexpr double infinity = HUGE_VAL;

double largest_coordinate(const Extent& extent) {
  double m = 0;
  for (int i = 0; i < 3; ++i) {
    m = std::fmax(m, std::fabs(extent.lo[i]));
    m = std::fmax(m, std::fabs(extent.hi[i]));
  }
  return m;
}

}  // namespace

Extent::Extent() : lo{infinity, infinity, infinity}, hi{-infinity, -infinity, -infinity} {}

void Extent::add(const std::array<double, 3>& point) {
  for (int i = 0; i < 3; ++i) {
    lo[i] = std::fmin(lo[i], point[i]);
    hi[i] = std::fmax(hi[i], point[i]);
  }
}

void Extent::add(const Extent& other) {
  if (other.empty()) return;
  add(other.lo);
  add(other.hi);
}

Extent extent_of(const std::vector<Triangle>& triangles) {
  Extent extent;
  for (const Triangle& t : triangles) {
    for (int i = 0; i < 9; i += 3) extent.add({t.v[i], t.v[i + 1], t.v[i + 2]});
  }
  return extent;
}

Extent camera_extent(const traces::Camera& camera, std::uint32_t width, std::uint32_t height) {
  // Origins are affine in the pixel, so the corners of the image hold the extremes.
  Extent extent;
  for (const double fx : {0.5, width - 0.5}) {
    for (const double fy : {0.5, height - 0.5}) {
      const Vec3 &o = camera.origin, &du = camera.origin_du, &dv = camera.origin_dv;
      extent.add({o.x + double(du.x) * fx + double(dv.x) * fy, o.y + double(du.y) * fx + double(dv.y) * fy,
                  o.z + double(du.z) * fx + double(dv.z) * fy});
    }
  }
  return extent;
}

double required_padding(const Extent& geometry, const Extent& camera, const Precision& precision) {
  if (geometry.empty()) return 0;
  // Rays begin at the camera or on the geometry (lights only end shadow rays).  Points on the geometry are moved off it
  // by eps of section 5, m * 2^-19 + L * 2^(4 - M), where no edge component L is longer than the whole geometry.  Twice
  // the first term also covers the rounding of such points and of the camera's.
  Extent origins = camera;
  origins.add(geometry);
  double longest = 0;
  for (int i = 0; i < 3; ++i) longest = std::fmax(longest, geometry.hi[i] - geometry.lo[i]);
  const double slack = 0x1p-18 * largest_coordinate(origins) + std::ldexp(longest, 4 - precision.triangle);
  double square = 0;
  for (int i = 0; i < 3; ++i) {
    const double d = std::fmax(geometry.hi[i] - (origins.lo[i] - slack), (origins.hi[i] + slack) - geometry.lo[i]);
    square += d * d;
  }
  // Where |direction| < 1e-18 on an axis, Embree takes +1e-18: within a shadow ray's tmax = 1 that moves the ray by
  // up to 2e-18, the floor's reason; on longer rays the drift is 1e-18 of the distance and the padding covers it.
  return std::fmax((std::ldexp(1.0, 2 - precision.narrower_test()) + 0x1p-17) * std::sqrt(square), 0x1p-58);
}

}  // namespace artu::ref
