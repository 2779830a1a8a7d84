// Watertight triangle test with exact products and the box clamp (docs/arithmetic.md section 3).
#pragma once

#include "hw/datapath/ray.h"

namespace artu::hw {

/// A candidate hit.  u, v are computed from U, V, det of the winner only.
struct TriangleHit {
  float t = 0, U = 0, V = 0, det = 1;
};

/// Tests triangle a, b, c; true and `hit` filled if it is hit with 0 <= t <= ray.tmax.
bool intersect(const Ray& ray, Vector a, Vector b, Vector c, TriangleHit& hit);

}  // namespace artu::hw
