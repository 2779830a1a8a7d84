// The triangle test (docs/arithmetic.md section 3); in a header because it is the inner loop.
#pragma once

#include <array>
#include <cstdint>

#include "ref/box.h"

namespace artu::ref {

/// Positions A, B, C one after the other, x y z each, in the order of the mesh's indices.
struct Triangle {
  std::array<float, 9> v;
};

/// The smallest and largest of the three vertices, folded in the order A, B, C with the contract's min and max.
/// The order matters to the sign of a zero only.
inline Box triangle_box(const Triangle& triangle) {
  const auto& v = triangle.v;
  return {{min(min(v[0], v[3]), v[6]), min(min(v[1], v[4]), v[7]), min(min(v[2], v[5]), v[8])},
          {max(max(v[0], v[3]), v[6]), max(max(v[1], v[4]), v[7]), max(max(v[2], v[5]), v[8])}};
}

/// What section 5 needs of a hit: `t` in units of the ray's direction, U and V against det.  F is float or double.
template <class F>
struct TriangleHitIn {
  F t, u, v, det;
};
using TriangleHit = TriangleHitIn<float>;

/// Whether the ray hits the triangle within [0, ray.tmax], in numbers of type N; both sides count.
/// `interval(ray, box)` is the box test of the box format, which may be another one.
template <class N, class BoxTest>
inline bool intersect_in(const Ray& ray, const Triangle& triangle, const BoxTest& interval, TriangleHit& hit) {
  const auto& p = triangle.v;
  const float origin[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
  const float ox = origin[ray.kx], oy = origin[ray.ky], oz = origin[ray.kz];
  const N sx = ray.sx, sy = ray.sy;
  const N akz = p[ray.kz] - oz, bkz = p[3 + ray.kz] - oz, ckz = p[6 + ray.kz] - oz;
  const N ax = N(p[ray.kx] - ox) - sx * akz, ay = N(p[ray.ky] - oy) - sy * akz;
  const N bx = N(p[3 + ray.kx] - ox) - sx * bkz, by = N(p[3 + ray.ky] - oy) - sy * bkz;
  const N cx = N(p[6 + ray.kx] - ox) - sx * ckz, cy = N(p[6 + ray.ky] - oy) - sy * ckz;

  // The products are exact in binary64: the signs are right and a shared edge is seen alike from both sides.
  const double dax(ax), day(ay), dbx(bx), dby(by), dcx(cx), dcy(cy);
  const N u = static_cast<N>(dcx * dby - dcy * dbx);
  const N v = static_cast<N>(dax * dcy - day * dcx);
  const N w = static_cast<N>(dbx * day - dby * dax);
  const N zero(0);
  if ((u < zero || v < zero || w < zero) && (u > zero || v > zero || w > zero)) return false;
  const N det = (u + v) + w;
  if (det == zero) return false;

  const N sz = ray.sz, az = sz * akz, bz = sz * bkz, cz = sz * ckz;
  float t = static_cast<float>(((u * az + v * bz) + w * cz) / det);
  if (t != t) return false;

  // Into the triangle's own box interval: no tree of boxes can then cull the winner (section 4).
  const Interval i = interval(ray, triangle_box(triangle));
  if (i.enter > i.exit) return false;
  t = min(max(t, i.enter), i.exit);
  if (!(0.0f <= t && t <= ray.tmax)) return false;
  hit = {t, static_cast<float>(u), static_cast<float>(v), static_cast<float>(det)};
  return true;
}

/// The winner so far.
template <class F>
struct HitIn {
  std::int64_t id = -1;  // global primitive id, -1: none
  TriangleHitIn<F> at{};
};
using Hit = HitIn<float>;

/// Takes a hit into `best`: smaller t, then smaller id.
template <class F>
bool improve(HitIn<F>& best, std::int64_t id, const TriangleHitIn<F>& hit) {
  if (best.id >= 0 && !(hit.t < best.at.t || (hit.t == best.at.t && id < best.id))) return false;
  best = {id, hit};
  return true;
}

}  // namespace artu::ref
