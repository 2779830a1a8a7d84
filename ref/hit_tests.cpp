#include "ref/hit_tests.h"

namespace artu::ref {
namespace {

template <class N>
float rounded(float x) {
  return static_cast<float>(N(x));
}

/// Calls `f` with the number type of a width.
template <class F>
void select(int bits, bool emulate, const F& f) {
  if (emulate) {
    with_number(bits, f);
  } else {
    with_format(bits, f);
  }
}

}  // namespace

template <class N>
bool HitTests::narrow(const HitTests& tests, const Ray& ray, const Triangle& triangle, TriangleHit& hit) {
  const auto box = [&tests](const Ray& r, const Box& b) { return tests.interval(r, b); };
  return intersect_in<N>(ray, triangle, box, hit);
}

HitTests::HitTests(const Precision& precision, bool emulate)
    : native_(!emulate && precision.box == widest && precision.triangle == widest), precision_(precision) {
  select(precision.box, emulate, [this](auto format) {
    using N = typename decltype(format)::Type;
    interval_ = box_interval<N>;
    to_box_ = rounded<N>;
  });
  select(precision.triangle, emulate, [this](auto format) {
    using N = typename decltype(format)::Type;
    narrow_ = narrow<N>;
    to_triangle_ = rounded<N>;
  });
  padding_ = interval_padding(precision.narrower_test());
  margin_ = padding_ - 1.0f;
  tfar_factor_ = 1.0f + 32.0f / static_cast<float>(1 << precision.narrower_test()) + 0x1p-18f;
}

// What the box test computes of a box lies, on an axis and at the exit, within 4 e of what it is in binary32 (e of
// section 10); the margin is 16 e, and what underflow adds, at most 2^-134 in a difference, is at most 2^-34 in t.  An
// overflow is beyond any tmax.  With a NaN nothing is certain, and all comparisons are false.
bool HitTests::far_off(const Ray& ray, const Triangle& triangle) const {
  constexpr float slack = 0x1p-30f;
  const Interval i = box_interval<float>(ray, triangle_box(triangle), padding_);
  const float less = 1.0f - margin_, more = 1.0f + margin_;
  const float enter = min(i.enter * less, i.enter * more) - slack, exit = max(i.exit * less, i.exit * more) + slack;
  return enter > exit || exit < 0 || enter > ray.tmax;
}

Ray HitTests::ray(const Vec3& origin, const Vec3& direction, float tmax) const {
  Ray ray = make_ray(origin, direction, tmax);
  if (native_) return ray;
  ray.inv = {to_box_(ray.inv.x), to_box_(ray.inv.y), to_box_(ray.inv.z)};
  ray.sx = to_triangle_(ray.sx);
  ray.sy = to_triangle_(ray.sy);
  ray.sz = to_triangle_(ray.sz);
  return ray;
}

}  // namespace artu::ref
