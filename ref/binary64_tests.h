// The triangle test of docs/arithmetic.md section 3 in binary64, for pictures without the unit's rounding (binary64.h).
#pragma once

#include "ref/padding.h"
#include "ref/triangle.h"
#include "ref/triple.h"

namespace artu::ref {

/// A ray with the shear that the test derives from its direction.  tmin is 0.
struct Binary64Ray {
  Vector<double> origin;
  Vector<double> direction;  // of any length; `t` is in units of it
  double tmax;
  int kx, ky, kz;     // axes: kz is the largest of |direction|
  double sx, sy, sz;  // Woop, Benthin, Wald, "Watertight ray/triangle intersection", JCGT 2013
};

/// Watertight: each edge function has its exact sign or is 0, which counts as either, so that what two triangles share
/// is never between them.  No box has a say in t: there is no tree of the unit's to agree with.
class Binary64Tests {
 public:
  using Number = double;
  using Ray = Binary64Ray;

  /// The direction must not be (0, 0, 0).
  Ray ray(const Vector<double>& origin, const Vector<double>& direction, double tmax) const;
  /// Whether the ray hits the triangle within [0, ray.tmax]; both sides count.
  bool intersect(const Ray& ray, const Triangle& triangle, TriangleHitIn<double>& hit) const;
  bool surely_misses(const Ray&, const Triangle&) const { return false; }

  int triangle_bits() const { return 52; }
  /// Of HitTests, and what Embree's binary32 makes of a ray: its origin moves by up to 2^-24 of its coordinates.
  double padding(const Extent& geometry, const Extent& camera) const;
  float tfar(double t) const { return static_cast<float>(t) * (1.0f + 0x1p-17f) + 0x1p-100f; }
};

}  // namespace artu::ref
