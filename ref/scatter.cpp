#include "ref/scatter.h"

#include <cmath>

namespace artu::ref {

Scatter scatter(const HitPoint& point, const Vec3& direction, const Vec3& kr, const Vec3& kt, float ior) {
  Scatter result{kr, {}, {}};
  if (!any_positive(kt)) return result;
  const float c = max(-dot(direction, point.ns), 0.0f);
  float r0 = (1.0f - ior) / (1.0f + ior);
  r0 = r0 * r0;
  const float eta = point.front ? 1.0f / ior : ior;
  const float k = 1.0f - (eta * eta) * (1.0f - c * c);
  float f = 1;  // total internal reflection
  if (!(k < 0)) {
    const float ct = std::sqrt(k);
    const float m = 1.0f - (point.front ? c : ct);  // Schlick takes the angle on the thinner side
    const float m2 = m * m;
    f = r0 == 0 ? 0 : r0 + (1.0f - r0) * ((m2 * m2) * m);
    result.refraction = kt * (1.0f - f);
    Vec3 dt = direction * eta + point.ns * (eta * c - ct);
    if (!(dot(dt, point.ng) < 0)) dt = direction;  // a shading normal must not bend the ray back out
    result.refracted = unit(dt);
  }
  result.reflection = kr + kt * f;
  return result;
}

Vec3 reflected(const HitPoint& point, const Vec3& direction) {
  Vec3 dr = direction + point.ns * (2.0f * -dot(direction, point.ns));
  if (!(dot(dr, point.ng) > 0)) dr = direction + point.ng * (2.0f * -dot(direction, point.ng));
  return unit(dr);
}

}  // namespace artu::ref
