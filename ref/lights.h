// Light that arrives at a point, before shadows (docs/arithmetic.md section 7, "Lights", steps 1 to 4).
//
// N is the shading format; what decides on a shadow ray or leads it is in F: float in any of the unit's formats, and
// double where all is.
#pragma once

#include "ref/hit_point.h"
#include "ref/triple.h"

namespace artu::ref {

template <class N, class F = float>
struct LightSample {
  Triple<N> towards;    // L
  Triple<N> intensity;  // I
  Vector<F> shadow;     // D, direction of the shadow ray from Pout
  F tmax;               // of the shadow ray
};

/// False where the light does not reach `point` (out of range, or too close or too far for binary32).
template <class N, class F>
bool sample_light(const traces::Light& light, const Vector<F>& point, LightSample<N, F>& sample) {
  using std::sqrt;
  if (light.kind == traces::LightKind::directional) {
    const Vector<F> towards = -Vector<F>(light.direction);
    sample = {towards, light.color, towards, no_tmax};
    return true;
  }
  const Vector<F> d = light.position - point;
  const F square = dot(d, d);
  if (!(0x1p-100f <= square && square <= 0x1p100f)) return false;
  const F range = light.range;
  if (square > range * range) return false;
  const N r2 = square, one(1), zero(0);
  const Triple<N> towards = Triple<N>(d) * (one / sqrt(r2));
  N attenuation = one / r2;
  if (light.kind == traces::LightKind::spot) {
    const N outer = light.cos_outer;
    N s = (-dot(towards, Triple<N>(light.direction)) - outer) * (one / max(N(light.cos_inner) - outer, N(0x1p-10f)));
    s = min(max(s, zero), one);
    attenuation = attenuation * (s * s);
  }
  sample = {towards, Triple<N>(light.color) * attenuation, d, F(1)};
  return true;
}

/// Whether there is a ray towards the light, reached by it or not.
template <class F>
bool can_aim(const traces::Light& light, const Vector<F>& point) {
  if (light.kind == traces::LightKind::directional) return !is_dead(-Vector<F>(light.direction));
  const Vector<F> d = light.position - point;
  const F square = dot(d, d);
  return 0x1p-100f <= square && square <= 0x1p100f;
}

/// The weights of a material at a hit, with texture and vertex colour applied.
template <class N>
struct Surface {
  Triple<N> kd, kt, ks, kr;
};

/// `tex` is the texture's colour times the vertex colour.
template <class N>
Surface<N> surface_of(const traces::Material& material, const Triple<N>& tex) {
  Surface<N> s{material.diffuse * tex, material.transmission * tex, material.specular, material.mirror};
  if (material.tint) {
    s.ks = s.ks * tex;
    s.kr = s.kr * tex;
  }
  return s;
}

/// What the light adds to the pixel if it is not in shadow (C, with the ray's weight T); false where step 2 or 4 skips.
template <class N, class F>
bool contribution(const LightSample<N, F>& light, const HitPointIn<F>& point, const Vector<F>& direction,
                  const Surface<N>& surface, unsigned specular_log2, const Triple<N>& weight, Triple<N>& result) {
  const N zero(0);
  const Triple<N> ns = point.ns;
  const N nl = dot(ns, light.towards);
  if (!(nl > zero) || !(dot(point.ng, light.shadow) > 0)) return false;
  N p(0);
  if (any_positive(surface.ks)) {
    const Triple<N> h = unit(light.towards - direction);
    p = max(dot(ns, h), zero);
    for (unsigned i = 0; i < specular_log2; ++i) p = p * p;
  }
  result = weight * (light.intensity * (surface.kd * nl + surface.ks * p));
  return any_positive(result);
}

}  // namespace artu::ref
