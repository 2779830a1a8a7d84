// The box and triangle tests (docs/arithmetic.md section 3); in a header because they are the inner loop.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "ref/ray.h"

namespace artu::ref {

/// Positions A, B, C one after the other, x y z each, in the order of the mesh's indices.
struct Triangle {
  std::array<float, 9> v;
};

struct Box {
  Vec3 lo, hi;
};

/// The smallest and largest of the three vertices, folded in the order A, B, C with the contract's min and max.
/// The order matters to the sign of a zero only.
inline Box triangle_box(const Triangle& triangle) {
  const auto& v = triangle.v;
  return {{min(min(v[0], v[3]), v[6]), min(min(v[1], v[4]), v[7]), min(min(v[2], v[5]), v[8])},
          {max(max(v[0], v[3]), v[6]), max(max(v[1], v[4]), v[7]), max(max(v[2], v[5]), v[8])}};
}

struct Interval {
  float enter, exit;
};

/// One axis of the slab test where the ray runs along it so little that its inverse was limited: all or, for a
/// direction of zero, nothing, by whether the slab holds the origin; else as on any axis.
inline void limited_slab(float lo, float hi, float origin, float direction, float& near, float& far) {
  if (lo <= origin && origin <= hi) {
    near = -HUGE_VALF;
    far = HUGE_VALF;
  } else if (direction == 0) {
    near = HUGE_VALF;
    far = -HUGE_VALF;
  }
}

/// The ray's interval in a box, without tmin and tmax; empty where enter > exit.
inline Interval box_interval(const Ray& ray, const Box& box) {
  const Vec3 a = (box.lo - ray.origin) * ray.inv, b = (box.hi - ray.origin) * ray.inv;
  constexpr float padding = 1.0f + 0x1p-21f;
  Vec3 near{min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)}, far{max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)};
  if (ray.any_limited) {
    const Vec3 &o = ray.origin, &d = ray.direction;
    if (ray.limited[0]) limited_slab(box.lo.x, box.hi.x, o.x, d.x, near.x, far.x);
    if (ray.limited[1]) limited_slab(box.lo.y, box.hi.y, o.y, d.y, near.y, far.y);
    if (ray.limited[2]) limited_slab(box.lo.z, box.hi.z, o.z, d.z, near.z, far.z);
  }
  return {max(max(near.x, near.y), near.z), min(min(far.x, far.y), far.z) * padding};
}

inline bool meets(const Ray& ray, const Box& box) {
  const Interval i = box_interval(ray, box);
  return max(i.enter, 0.0f) <= min(i.exit, ray.tmax);
}

/// What section 5 needs of a hit: `t` in units of the ray's direction, U and V against det.
struct TriangleHit {
  float t, u, v, det;
};

/// Whether the ray hits the triangle within [0, ray.tmax]; both sides count.
inline bool intersect(const Ray& ray, const Triangle& triangle, TriangleHit& hit) {
  const auto& p = triangle.v;
  const float origin[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
  const float ox = origin[ray.kx], oy = origin[ray.ky], oz = origin[ray.kz];
  const float akz = p[ray.kz] - oz, bkz = p[3 + ray.kz] - oz, ckz = p[6 + ray.kz] - oz;
  const float ax = (p[ray.kx] - ox) - ray.sx * akz, ay = (p[ray.ky] - oy) - ray.sy * akz;
  const float bx = (p[3 + ray.kx] - ox) - ray.sx * bkz, by = (p[3 + ray.ky] - oy) - ray.sy * bkz;
  const float cx = (p[6 + ray.kx] - ox) - ray.sx * ckz, cy = (p[6 + ray.ky] - oy) - ray.sy * ckz;

  // The products are exact in binary64: the signs are right and a shared edge is seen alike from both sides.
  const double dax = ax, day = ay, dbx = bx, dby = by, dcx = cx, dcy = cy;
  const float u = static_cast<float>(dcx * dby - dcy * dbx);
  const float v = static_cast<float>(dax * dcy - day * dcx);
  const float w = static_cast<float>(dbx * day - dby * dax);
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return false;
  const float det = (u + v) + w;
  if (det == 0) return false;

  const float az = ray.sz * akz, bz = ray.sz * bkz, cz = ray.sz * ckz;
  float t = ((u * az + v * bz) + w * cz) / det;
  if (t != t) return false;

  // Into the triangle's own box interval: no tree of boxes can then cull the winner (section 4).
  const Interval i = box_interval(ray, triangle_box(triangle));
  if (i.enter > i.exit) return false;
  t = min(max(t, i.enter), i.exit);
  if (!(0.0f <= t && t <= ray.tmax)) return false;
  hit = {t, u, v, det};
  return true;
}

/// The winner so far.
struct Hit {
  std::int64_t id = -1;  // global primitive id, -1: none
  TriangleHit at{};
};

/// Takes a hit into `best`: smaller t, then smaller id.
inline bool improve(Hit& best, std::int64_t id, const TriangleHit& hit) {
  if (best.id >= 0 && !(hit.t < best.at.t || (hit.t == best.at.t && id < best.id))) return false;
  best = {id, hit};
  return true;
}

}  // namespace artu::ref
