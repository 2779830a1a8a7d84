#include "hw/datapath/shading.h"

namespace artu::hw {

Vector sky(const ShadingConstants& constants, Vector direction) {
  const float s = 0.5f * direction.y + 0.5f;
  return constants.sky_nadir + (constants.sky_zenith - constants.sky_nadir) * s;
}

Vector begin_shading(const ShadingConstants& constants, const Surface& surface, const MaterialRecord& material,
                     Vector texture, Vector direction, Vector weight, ShadedPoint& point) {
  const Vector tex = texture * surface.color;
  point.direction = direction;
  point.weight = weight;
  point.geometric_normal = surface.geometric_normal;
  point.shading_normal = surface.shading_normal;
  point.outside = surface.outside;
  point.inside = surface.inside;
  point.front = surface.front;
  point.diffuse = material.diffuse * tex;
  point.transmission = material.transmission * tex;
  point.specular = material.tint ? material.specular * tex : material.specular;
  point.mirror = material.tint ? material.mirror * tex : material.mirror;
  point.ior = material.ior;
  point.specular_log2 = material.specular_log2;
  return material.emission + point.diffuse * constants.ambient;
}

namespace {

/// Direction, distance and intensity of a light as seen from the point; false if out of reach.
bool sample_light(const ShadedPoint& point, const LightRecord& light, Vector& to_light, Vector& intensity,
                  ShadowRay& shadow) {
  if (light.type == LightType::directional) {
    to_light = -light.direction;
    shadow.direction = to_light;
    shadow.tmax = two_pow_100;
    intensity = light.color;
    return true;
  }
  const Vector d = light.position - point.outside;
  const float r2 = dot(d, d);
  if (!(r2 >= two_pow_minus_100 && r2 <= two_pow_100)) return false;
  if (r2 > light.range * light.range) return false;
  to_light = d * (1.0f / std::sqrt(r2));
  float attenuation = 1.0f / r2;
  if (light.type == LightType::spot) {
    const float cosine = -dot(to_light, light.direction);
    float s = (cosine - light.cos_outer) * (1.0f / maximum(light.cos_inner - light.cos_outer, 0x1p-10f));
    s = minimum(maximum(s, 0.0f), 1.0f);
    attenuation = attenuation * (s * s);
  }
  shadow.direction = d;
  shadow.tmax = 1.0f;
  intensity = light.color * attenuation;
  return true;
}

}  // namespace

bool light_contribution(const ShadedPoint& point, const LightRecord& light, ShadowRay& shadow) {
  Vector to_light, intensity;
  if (!sample_light(point, light, to_light, intensity, shadow)) return false;
  const float nl = dot(point.shading_normal, to_light);
  if (!(nl > 0) || !(dot(point.geometric_normal, to_light) > 0)) return false;
  float p = 0;
  if (any_positive(point.specular)) {
    const Vector h = unit(to_light - point.direction);
    p = maximum(dot(point.shading_normal, h), 0.0f);
    for (std::uint32_t i = 0; i < point.specular_log2; ++i) p = p * p;
  }
  shadow.contribution = point.weight * (intensity * (point.diffuse * nl + point.specular * p));
  return any_positive(shadow.contribution);
}

namespace {

struct Refraction {
  float fresnel;
  Vector weight, direction;
};

Refraction refract(const ShadedPoint& point, float c) {
  const Vector d = point.direction, ns = point.shading_normal;
  float r0 = (1.0f - point.ior) / (1.0f + point.ior);
  r0 = r0 * r0;
  const float eta = point.front ? 1.0f / point.ior : point.ior;
  const float k = 1.0f - (eta * eta) * (1.0f - c * c);
  if (k < 0) return {1.0f, {}, {}};  // total internal reflection
  const float ct = std::sqrt(k);
  const float m = 1.0f - (point.front ? c : ct);
  const float m2 = m * m;
  const float fresnel = r0 == 0 ? 0.0f : r0 + (1.0f - r0) * ((m2 * m2) * m);
  Vector dt = d * eta + ns * (eta * c - ct);
  if (!(dot(dt, point.geometric_normal) < 0)) dt = d;
  return {fresnel, point.transmission * (1.0f - fresnel), unit(dt)};
}

bool worth_tracing(const ShadingConstants& constants, Vector weight) {
  const float l = largest(weight);
  return l >= constants.min_weight && l > 0;
}

}  // namespace

NextRays next_rays(const ShadingConstants& constants, const ShadedPoint& point) {
  const Vector d = point.direction, ns = point.shading_normal, ng = point.geometric_normal;
  const float c = maximum(-dot(d, ns), 0.0f);
  NextRays next;
  Vector reflected = point.mirror;
  if (any_positive(point.transmission)) {
    const Refraction refraction = refract(point, c);
    reflected = point.mirror + point.transmission * refraction.fresnel;
    next.refraction_weight = point.weight * refraction.weight;
    next.refraction_direction = refraction.direction;
    next.refraction = worth_tracing(constants, next.refraction_weight) && !is_zero(next.refraction_direction);
  }
  next.reflection_weight = point.weight * reflected;
  if (worth_tracing(constants, next.reflection_weight)) {
    Vector dr = d + ns * (2.0f * -dot(d, ns));
    if (!(dot(dr, ng) > 0)) dr = d + ng * (2.0f * -dot(d, ng));
    next.reflection_direction = unit(dr);
    next.reflection = !is_zero(next.reflection_direction);
  }
  return next;
}

}  // namespace artu::hw
