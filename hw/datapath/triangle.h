// Watertight triangle test with exact products and the box clamp (docs/arithmetic.md section 3), in its format R.
#pragma once

#include "hw/datapath/box.h"

namespace artu::hw {

/// A candidate hit.  u, v are computed from U, V, det of the winner only.
struct TriangleHit {
  float t = 0, U = 0, V = 0, det = 1;
};

/// Of two hits the smaller t wins, on equal t the smaller primitive id.
inline bool nearer(const TriangleHit& hit, std::uint32_t primitive, const TriangleHit& best,
                   std::uint32_t best_primitive) {
  return hit.t < best.t || (hit.t == best.t && primitive < best_primitive);
}

/// Tests triangle a, b, c; true and `hit` filled if it is hit with 0 <= t <= ray.tmax.  `box` is the box test of the
/// unit, in a format of its own: (ray, lo, hi) -> Interval.
template <class R, class BoxTest>
bool intersect(const Ray& ray, Vector a, Vector b, Vector c, const BoxTest& box, TriangleHit& hit) {
  const VectorOf<R> ta = to<R>(a - ray.origin), tb = to<R>(b - ray.origin), tc = to<R>(c - ray.origin);
  const R sx = R(ray.sx), sy = R(ray.sy), sz = R(ray.sz);
  const R ax = ta[ray.kx] - sx * ta[ray.kz], ay = ta[ray.ky] - sy * ta[ray.kz];
  const R bx = tb[ray.kx] - sx * tb[ray.kz], by = tb[ray.ky] - sy * tb[ray.kz];
  const R cx = tc[ray.kx] - sx * tc[ray.kz], cy = tc[ray.ky] - sy * tc[ray.kz];
  // Both products are exact in binary64: the sign of the difference is right, and one rounding follows.
  const auto difference_of_products = [](R p, R q, R r, R s) {
    return R(static_cast<double>(p) * static_cast<double>(q) - static_cast<double>(r) * static_cast<double>(s));
  };
  const R U = difference_of_products(cx, by, cy, bx);
  const R V = difference_of_products(ax, cy, ay, cx);
  const R W = difference_of_products(bx, ay, by, ax);
  const R zero = R(0.0f);
  if ((U < zero || V < zero || W < zero) && (U > zero || V > zero || W > zero)) return false;
  const R det = (U + V) + W;
  if (det == zero) return false;
  const R az = sz * ta[ray.kz], bz = sz * tb[ray.kz], cz = sz * tc[ray.kz];
  float t = float(((U * az + V * bz) + W * cz) / det);
  if (t != t) return false;
  const Vector lo{minimum(minimum(a.x, b.x), c.x), minimum(minimum(a.y, b.y), c.y), minimum(minimum(a.z, b.z), c.z)};
  const Vector hi{maximum(maximum(a.x, b.x), c.x), maximum(maximum(a.y, b.y), c.y), maximum(maximum(a.z, b.z), c.z)};
  const Interval own = box(ray, lo, hi);
  if (own.enter > own.exit) return false;
  t = minimum(maximum(t, own.enter), own.exit);
  if (!(0.0f <= t && t <= ray.tmax)) return false;
  hit = {t, float(U), float(V), float(det)};
  return true;
}

}  // namespace artu::hw
