// From the winning triangle to a point with normals, attributes and origins (docs/arithmetic.md section 5).
#pragma once

#include <cstddef>
#include <cstdint>

#include "ref/ray.h"
#include "ref/triangle.h"

namespace artu::ref {

/// F is float or double.
template <class F>
struct HitPointIn {
  Vector<F> ng, ns;  // geometric and shading normal, both towards the ray's origin; unit length
  bool front;        // the ray came from the side that the winding's normal points to
  Uv<F> uv;
  Vector<F> color;    // vertex colour, linear, 0 ... 1
  Vector<F> outside;  // Pout: origin of shadow and reflection rays
  Vector<F> inside;   // Pin: origin of refraction rays
};
using HitPoint = HitPointIn<float>;

/// All in F.  `triangle` is the index in `mesh`, `direction` the ray's, `triangle_bits` the width of the triangle test,
/// by which (and by the rounding of F itself) the two origins must be off the surface.
template <class F = float>
HitPointIn<F> hit_point(const traces::Mesh& mesh, std::size_t triangle, const Vector<F>& direction,
                        const TriangleHitIn<F>& hit, int triangle_bits = 23);

}  // namespace artu::ref
