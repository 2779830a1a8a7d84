// Reflection and refraction: weights and directions (docs/arithmetic.md section 7, "Next rays").
//
// N is the shading format, of the weights; directions are float in any format.
#pragma once

#include "ref/hit_point.h"
#include "ref/triple.h"

namespace artu::ref {

template <class N>
struct Scatter {
  Triple<N> reflection;  // R, the weight of the reflection ray
  Triple<N> refraction;  // Q, of the refraction ray; 0 on total internal reflection
  Vec3 refracted;        // dt, unit length or (0, 0, 0); meaningful where Q is not 0
};

/// Splits by Schlick's Fresnel term.  `kr` and `kt` are the surface's weights, `direction` the ray's.
template <class N>
Scatter<N> scatter(const HitPoint& point, const Vec3& direction, const Triple<N>& kr, const Triple<N>& kt, float ior) {
  Scatter<N> result{kr, {}, {}};
  if (!any_positive(kt)) return result;
  const float c = max(-dot(direction, point.ns), 0.0f);
  const float eta = point.front ? 1.0f / ior : ior;
  const float k = 1.0f - (eta * eta) * (1.0f - c * c);
  const N one(1), zero(0);
  N f = one;  // total internal reflection
  if (!(k < 0)) {
    const float ct = std::sqrt(k);
    N r0 = (one - N(ior)) / (one + N(ior));
    r0 = r0 * r0;
    const N m = one - N(point.front ? c : ct);  // Schlick takes the angle on the thinner side
    const N m2 = m * m;
    f = r0 == zero ? zero : r0 + (one - r0) * ((m2 * m2) * m);
    result.refraction = kt * (one - f);
    Vec3 dt = direction * eta + point.ns * (eta * c - ct);
    if (!(dot(dt, point.ng) < 0)) dt = direction;  // a shading normal must not bend the ray back out
    result.refracted = unit(dt);
  }
  result.reflection = kr + kt * f;
  return result;
}

/// dr, the mirrored direction, on the ray's own side of the surface; unit length or (0, 0, 0).
inline Vec3 reflected(const HitPoint& point, const Vec3& direction) {
  Vec3 dr = direction + point.ns * (2.0f * -dot(direction, point.ns));
  if (!(dot(dr, point.ng) > 0)) dr = direction + point.ng * (2.0f * -dot(direction, point.ng));
  return unit(dr);
}

}  // namespace artu::ref
