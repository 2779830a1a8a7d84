// The surface at a hit (docs/arithmetic.md section 5).
#pragma once

#include "hw/datapath/triangle.h"
#include "hw/memory/layout.h"

namespace artu::hw {

struct Surface {
  Vector geometric_normal, shading_normal;  // both on the ray's side
  Vector outside, inside;                   // origins of the next rays
  Vector color;                             // of the vertices, linear
  float u = 0, v = 0;                       // texture coordinates
  bool front = true;                        // the ray comes from where the normal points
};

/// All of it in binary32.  `triangle_bits` are the stored fraction bits of the triangle test, which decide how far
/// `outside` and `inside` are from the surface.
Surface surface_at(const Ray& ray, const TriangleHit& hit, const TriangleRecord& triangle,
                   const AttributeRecord& attributes, int triangle_bits = most_fraction_bits);

}  // namespace artu::hw
