// Slab test with Ize's padding (docs/arithmetic.md section 3; Ize, JCGT 2013).
#pragma once

#include "hw/datapath/ray.h"

namespace artu::hw {

inline constexpr float box_padding = 1.0f + 0x1p-21f;

struct Interval {
  float enter, exit;
};

/// The interval of a box for a ray with limited axes; see box_interval.
Interval limited_box_interval(const Ray& ray, Vector lo, Vector hi);

/// The interval of the box alone, without tmin and tmax.
inline Interval box_interval(const Ray& ray, Vector lo, Vector hi) {
  if (ray.limited != 0) return limited_box_interval(ray, lo, hi);
  const Vector a = (lo - ray.origin) * ray.inverse;
  const Vector b = (hi - ray.origin) * ray.inverse;
  const float enter = maximum(maximum(minimum(a.x, b.x), minimum(a.y, b.y)), minimum(a.z, b.z));
  const float exit = minimum(minimum(maximum(a.x, b.x), maximum(a.y, b.y)), maximum(a.z, b.z)) * box_padding;
  return {enter, exit};
}

/// Whether a ray limited to [0, limit] meets a box with this interval.
inline bool meets(Interval box, float limit) { return maximum(box.enter, 0.0f) <= minimum(box.exit, limit); }

}  // namespace artu::hw
