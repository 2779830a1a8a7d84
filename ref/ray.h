// Rays: generation from the camera and set-up (docs/arithmetic.md section 2).
#pragma once

#include <cstdint>

#include "ref/triple.h"

namespace artu::ref {

inline constexpr float no_tmax = 0x1p100f;

/// A ray with everything that the tests of section 3 derive from its direction.  tmin is 0 for every ray.
struct Ray {
  Vec3 origin;
  Vec3 direction;  // of any length; `t` is in units of it
  float tmax = no_tmax;

  // In binary32, or rounded to the tests' formats (hit_tests.h):
  Vec3 inv;         // 1 / direction, at most 2^100 in magnitude, never NaN
  bool limited[3];  // axes on which that limit was reached, before any rounding
  bool any_limited;
  int kx, ky, kz;    // axes of the triangle test: kz is the largest of |direction|
  float sx, sy, sz;  // its shear
};

/// Set-up in binary32.  The direction must not be (0, 0, 0).
Ray make_ray(const Vec3& origin, const Vec3& direction, float tmax = no_tmax);

/// A dead ray is not traced and counts as a miss.
template <class V>
bool is_dead(const V& direction) {
  return is_zero(direction);
}

/// Of the primary ray of a pixel, in F: float or double.
template <class F = float>
Vector<F> camera_origin(const traces::Camera& camera, std::uint32_t x, std::uint32_t y);
template <class F = float>
Vector<F> camera_direction(const traces::Camera& camera, std::uint32_t x, std::uint32_t y);

}  // namespace artu::ref
