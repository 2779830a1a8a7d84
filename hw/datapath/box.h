// Slab test with Ize's padding (docs/arithmetic.md section 3; Ize, JCGT 2013), in the box test's format R.
#pragma once

#include "hw/datapath/ray.h"

namespace artu::hw {

/// P: the factor at an interval's end, for the smaller width of box and triangle test.
inline float box_padding(int fraction_bits = most_fraction_bits) { return 1.0f + std::ldexp(1.0f, 3 - fraction_bits); }

struct Interval {
  float enter, exit;
};

/// Ends of a slab on an axis whose inverse is limited: all, or for a direction of zero nothing, by whether it holds o.
void limited_slab(const Ray& ray, int axis, float lo, float hi, float& near, float& far);

/// The interval of the box alone, without tmin and tmax; `padding` is P.
template <class R = float>
Interval box_interval(const Ray& ray, Vector lo, Vector hi, float padding) {
  const VectorOf<R> inverse = to<R>(ray.inverse);
  const VectorOf<R> a = to<R>(lo - ray.origin) * inverse;
  const VectorOf<R> b = to<R>(hi - ray.origin) * inverse;
  Vector near = from(VectorOf<R>{minimum(a.x, b.x), minimum(a.y, b.y), minimum(a.z, b.z)});
  Vector far = from(VectorOf<R>{maximum(a.x, b.x), maximum(a.y, b.y), maximum(a.z, b.z)});
  if (ray.limited != 0) {
    limited_slab(ray, 0, lo.x, hi.x, near.x, far.x);
    limited_slab(ray, 1, lo.y, hi.y, near.y, far.y);
    limited_slab(ray, 2, lo.z, hi.z, near.z, far.z);
  }
  const float exit = minimum(minimum(far.x, far.y), far.z);
  return {maximum(maximum(near.x, near.y), near.z), float(R(exit) * R(padding))};
}

/// Whether a ray limited to [0, limit] meets a box with this interval.
inline bool meets(Interval box, float limit) { return maximum(box.enter, 0.0f) <= minimum(box.exit, limit); }

}  // namespace artu::hw
