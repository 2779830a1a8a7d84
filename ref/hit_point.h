// From the winning triangle to a point with normals, attributes and origins (docs/arithmetic.md section 5).
#pragma once

#include <cstddef>
#include <cstdint>

#include "ref/ray.h"
#include "ref/triangle.h"

namespace artu::ref {

struct HitPoint {
  Vec3 ng, ns;  // geometric and shading normal, both towards the ray's origin; unit length
  bool front;   // the ray came from the side that the winding's normal points to
  Vec2 uv;
  Vec3 color;    // vertex colour, linear, 0 ... 1
  Vec3 outside;  // Pout: origin of shadow and reflection rays
  Vec3 inside;   // Pin: origin of refraction rays
};

/// All in binary32.  `triangle` is the index in `mesh`, `direction` the ray's, `triangle_bits` the width of the
/// triangle test, by which the two origins must be off the surface.
HitPoint hit_point(const traces::Mesh& mesh, std::size_t triangle, const Vec3& direction, const TriangleHit& hit,
                   int triangle_bits = 23);

}  // namespace artu::ref
