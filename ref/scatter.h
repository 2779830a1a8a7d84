// Reflection and refraction: weights and directions (docs/arithmetic.md section 7, "Next rays").
//
// N is the shading format, of the weights; directions are in F: float in any of the unit's formats, and double where
// all is.
#pragma once

#include "ref/hit_point.h"
#include "ref/triple.h"

namespace artu::ref {

template <class N, class F = float>
struct Scatter {
  Triple<N> reflection;  // R, the weight of the reflection ray
  Triple<N> refraction;  // Q, of the refraction ray; 0 on total internal reflection
  Vector<F> refracted;   // dt, unit length or (0, 0, 0); meaningful where Q is not 0
};

/// Splits by Schlick's Fresnel term.  `kr` and `kt` are the surface's weights, `direction` the ray's,
/// `index` the refractive one.
template <class N, class F>
Scatter<N, F> scatter(const HitPointIn<F>& point, const Vector<F>& direction, const Triple<N>& kr, const Triple<N>& kt,
                      float index) {
  const F ior = index;
  Scatter<N, F> result{kr, {}, {}};
  if (!any_positive(kt)) return result;
  const F c = max(-dot(direction, point.ns), F(0));
  const F eta = point.front ? F(1) / ior : ior;
  const F k = F(1) - (eta * eta) * (F(1) - c * c);
  const N one(1), zero(0);
  N f = one;  // total internal reflection
  if (!(k < 0)) {
    const F ct = std::sqrt(k);
    N r0 = (one - N(ior)) / (one + N(ior));
    r0 = r0 * r0;
    const N m = one - N(point.front ? c : ct);  // Schlick takes the angle on the thinner side
    const N m2 = m * m;
    f = r0 == zero ? zero : r0 + (one - r0) * ((m2 * m2) * m);
    result.refraction = kt * (one - f);
    Vector<F> dt = direction * eta + point.ns * (eta * c - ct);
    if (!(dot(dt, point.ng) < 0)) dt = direction;  // a shading normal must not bend the ray back out
    result.refracted = unit(dt);
  }
  result.reflection = kr + kt * f;
  return result;
}

/// dr, the mirrored direction, on the ray's own side of the surface; unit length or (0, 0, 0).
template <class F>
Vector<F> reflected(const HitPointIn<F>& point, const Vector<F>& direction) {
  Vector<F> dr = direction + point.ns * (F(2) * -dot(direction, point.ns));
  if (!(dot(dr, point.ng) > 0)) dr = direction + point.ng * (F(2) * -dot(direction, point.ng));
  return unit(dr);
}

}  // namespace artu::ref
