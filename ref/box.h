// The box test (docs/arithmetic.md section 3); in a header because it is the inner loop.
#pragma once

#include <cmath>

#include "ref/number.h"
#include "ref/ray.h"

namespace artu::ref {

struct Box {
  Vec3 lo, hi;
};

/// Numbers of the box test's format; the comparisons of section 3 are of float values.
struct Interval {
  float enter, exit;
};

/// P of section 3, as wide as the narrower of the two tests needs; a number of either's format.
inline constexpr float interval_padding(int narrower_bits) {
  return 1.0f + 8.0f / static_cast<float>(1 << narrower_bits);
}

/// One axis of the slab test where the ray runs along it so little that its inverse was limited: all or, for a
/// direction of zero, nothing, by whether the slab holds the origin; else as on any axis.
template <class N>
void limited_slab(float lo, float hi, float origin, float direction, N& near, N& far) {
  if (lo <= origin && origin <= hi) {
    near = -HUGE_VALF;
    far = HUGE_VALF;
  } else if (direction == 0) {
    near = HUGE_VALF;
    far = -HUGE_VALF;
  }
}

/// The ray's interval in a box, without tmin and tmax, in numbers of type N; empty where enter > exit.
template <class N>
inline Interval box_interval(const Ray& ray, const Box& box, float padding) {
  const Vec3 &o = ray.origin, &d = ray.direction, &inv = ray.inv;
  const N ax = N(box.lo.x - o.x) * inv.x, ay = N(box.lo.y - o.y) * inv.y, az = N(box.lo.z - o.z) * inv.z;
  const N bx = N(box.hi.x - o.x) * inv.x, by = N(box.hi.y - o.y) * inv.y, bz = N(box.hi.z - o.z) * inv.z;
  N near_x = min(ax, bx), near_y = min(ay, by), near_z = min(az, bz);
  N far_x = max(ax, bx), far_y = max(ay, by), far_z = max(az, bz);
  if (ray.any_limited) {
    if (ray.limited[0]) limited_slab(box.lo.x, box.hi.x, o.x, d.x, near_x, far_x);
    if (ray.limited[1]) limited_slab(box.lo.y, box.hi.y, o.y, d.y, near_y, far_y);
    if (ray.limited[2]) limited_slab(box.lo.z, box.hi.z, o.z, d.z, near_z, far_z);
  }
  return {static_cast<float>(max(max(near_x, near_y), near_z)),
          static_cast<float>(min(min(far_x, far_y), far_z) * N(padding))};
}

/// Whether a ray with this interval in a box meets it.
inline bool meets(const Interval& i, float tmax = no_tmax) { return max(i.enter, 0.0f) <= min(i.exit, tmax); }

}  // namespace artu::ref
