#include "ref/lights.h"

#include <cmath>

namespace artu::ref {

bool sample_light(const traces::Light& light, const Vec3& point, LightSample& sample) {
  if (light.kind == traces::LightKind::directional) {
    const Vec3 towards = -light.direction;
    sample = {towards, light.color, towards, no_tmax};
    return true;
  }
  const Vec3 d = light.position - point;
  const float r2 = dot(d, d);
  if (!(0x1p-100f <= r2 && r2 <= 0x1p100f)) return false;
  if (r2 > light.range * light.range) return false;
  const Vec3 towards = d * (1.0f / std::sqrt(r2));
  float attenuation = 1.0f / r2;
  if (light.kind == traces::LightKind::spot) {
    float s =
        (-dot(towards, light.direction) - light.cos_outer) * (1.0f / max(light.cos_inner - light.cos_outer, 0x1p-10f));
    s = min(max(s, 0.0f), 1.0f);
    attenuation = attenuation * (s * s);
  }
  sample = {towards, light.color * attenuation, d, 1.0f};
  return true;
}

Surface surface_of(const traces::Material& material, const Vec3& tex) {
  Surface s{material.diffuse * tex, material.transmission * tex, material.specular, material.mirror};
  if (material.tint) {
    s.ks = s.ks * tex;
    s.kr = s.kr * tex;
  }
  return s;
}

bool contribution(const LightSample& light, const HitPoint& point, const Vec3& direction, const Surface& surface,
                  unsigned specular_log2, const Vec3& weight, Vec3& result) {
  const float nl = dot(point.ns, light.towards);
  if (!(nl > 0) || !(dot(point.ng, light.towards) > 0)) return false;
  float p = 0;
  if (any_positive(surface.ks)) {
    const Vec3 h = unit(light.towards - direction);
    p = max(dot(point.ns, h), 0.0f);
    for (unsigned i = 0; i < specular_log2; ++i) p = p * p;
  }
  result = weight * (light.intensity * (surface.kd * nl + surface.ks * p));
  return any_positive(result);
}

}  // namespace artu::ref
