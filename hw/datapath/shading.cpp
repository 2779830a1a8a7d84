#include "hw/datapath/shading.h"

namespace artu::hw {

template <class R>
Vector sky(const ShadingConstants& constants, Vector direction) {
  const R s = R(0.5f) * R(direction.y) + R(0.5f);
  const VectorOf<R> nadir = to<R>(constants.sky_nadir), zenith = to<R>(constants.sky_zenith);
  return from(nadir + (zenith - nadir) * s);
}

template <class R>
Vector begin_shading(const ShadingConstants& constants, const Surface& surface, const MaterialRecord& material,
                     Vector texture, Vector direction, Vector weight, ShadedPoint& point) {
  const VectorOf<R> tex = to<R>(texture) * to<R>(surface.color);
  const VectorOf<R> diffuse = to<R>(material.diffuse) * tex;
  const VectorOf<R> specular = to<R>(material.specular), mirror = to<R>(material.mirror);
  point.direction = direction;
  point.weight = weight;
  point.geometric_normal = surface.geometric_normal;
  point.shading_normal = surface.shading_normal;
  point.outside = surface.outside;
  point.inside = surface.inside;
  point.front = surface.front;
  point.diffuse = from(diffuse);
  point.transmission = from(to<R>(material.transmission) * tex);
  point.specular = from(material.tint ? specular * tex : specular);
  point.mirror = from(material.tint ? mirror * tex : mirror);
  point.ior = material.ior;
  point.specular_log2 = material.specular_log2;
  return from(to<R>(material.emission) + diffuse * to<R>(constants.ambient));
}

namespace {

/// Direction and intensity of a light as seen from the point, and the shadow ray; false if out of reach.
template <class R>
bool sample_light(const ShadedPoint& point, const LightRecord& light, VectorOf<R>& to_light, VectorOf<R>& intensity,
                  ShadowRay& shadow) {
  using std::sqrt;
  if (light.type == LightType::directional) {
    shadow.direction = -light.direction;
    shadow.tmax = two_pow_100;
    to_light = to<R>(shadow.direction);
    intensity = to<R>(light.color);
    return true;
  }
  shadow.direction = light.position - point.outside;
  shadow.tmax = 1.0f;
  const float distance = dot(shadow.direction, shadow.direction);
  if (!(distance >= two_pow_minus_100 && distance <= two_pow_100)) return false;
  if (distance > light.range * light.range) return false;
  const R r2 = R(distance);
  to_light = to<R>(shadow.direction) * (R(1.0f) / sqrt(r2));
  R attenuation = R(1.0f) / r2;
  if (light.type == LightType::spot) {
    const R cosine = -dot(to_light, to<R>(light.direction));
    const R inner = R(light.cos_inner), outer = R(light.cos_outer);
    R s = (cosine - outer) * (R(1.0f) / maximum(inner - outer, R(0x1p-10f)));
    s = minimum(maximum(s, R(0.0f)), R(1.0f));
    attenuation = attenuation * (s * s);
  }
  intensity = to<R>(light.color) * attenuation;
  return true;
}

}  // namespace

bool aim(const ShadedPoint& point, const LightRecord& light, ShadowRay& shadow) {
  if (light.type == LightType::directional) {
    shadow.direction = -light.direction;
    shadow.tmax = two_pow_100;
    return !is_zero(shadow.direction);
  }
  shadow.direction = light.position - point.outside;
  shadow.tmax = 1.0f;
  const float distance = dot(shadow.direction, shadow.direction);
  return distance >= two_pow_minus_100 && distance <= two_pow_100;
}

template <class R>
bool light_contribution(const ShadedPoint& point, const LightRecord& light, ShadowRay& shadow) {
  VectorOf<R> to_light, intensity;
  if (!sample_light(point, light, to_light, intensity, shadow)) return false;
  const VectorOf<R> normal = to<R>(point.shading_normal), specular = to<R>(point.specular);
  const R nl = dot(normal, to_light);
  if (!(nl > R(0.0f)) || !(dot(point.geometric_normal, shadow.direction) > 0)) return false;
  R p{};
  if (any_positive(specular)) {
    const VectorOf<R> h = unit(to_light - to<R>(point.direction));
    p = maximum(dot(normal, h), R(0.0f));
    for (std::uint32_t i = 0; i < point.specular_log2; ++i) p = p * p;
  }
  const VectorOf<R> contribution = to<R>(point.weight) * (intensity * (to<R>(point.diffuse) * nl + specular * p));
  shadow.contribution = from(contribution);
  return any_positive(contribution);
}

namespace {

template <class R>
struct Refraction {
  R fresnel;
  VectorOf<R> weight;
  Vector direction;
};

template <class R>
Refraction<R> refract(const ShadedPoint& point, float c) {
  const Vector d = point.direction, ns = point.shading_normal;
  R r0 = (R(1.0f) - R(point.ior)) / (R(1.0f) + R(point.ior));
  r0 = r0 * r0;
  const float eta = point.front ? 1.0f / point.ior : point.ior;
  const float k = 1.0f - (eta * eta) * (1.0f - c * c);
  if (k < 0) return {R(1.0f), {}, {}};  // total internal reflection
  const float ct = std::sqrt(k);
  const R m = R(1.0f) - R(point.front ? c : ct);
  const R m2 = m * m;
  const R fresnel = r0 == R(0.0f) ? R(0.0f) : r0 + (R(1.0f) - r0) * ((m2 * m2) * m);
  Vector dt = d * eta + ns * (eta * c - ct);
  if (!(dot(dt, point.geometric_normal) < 0)) dt = d;
  return {fresnel, to<R>(point.transmission) * (R(1.0f) - fresnel), unit(dt)};
}

bool worth_tracing(const ShadingConstants& constants, Vector weight) {
  const float l = largest(weight);
  return l >= constants.min_weight && l > 0;
}

}  // namespace

template <class R>
NextRays next_rays(const ShadingConstants& constants, const ShadedPoint& point) {
  const Vector d = point.direction, ns = point.shading_normal, ng = point.geometric_normal;
  const VectorOf<R> weight = to<R>(point.weight);
  const float c = maximum(-dot(d, ns), 0.0f);
  NextRays next;
  VectorOf<R> reflected = to<R>(point.mirror);
  if (any_positive(point.transmission)) {
    const Refraction<R> refraction = refract<R>(point, c);
    reflected = reflected + to<R>(point.transmission) * refraction.fresnel;
    next.refraction_weight = from(weight * refraction.weight);
    next.refraction_direction = refraction.direction;
    next.refraction = worth_tracing(constants, next.refraction_weight) && !is_zero(next.refraction_direction);
  }
  next.reflection_weight = from(weight * reflected);
  if (worth_tracing(constants, next.reflection_weight)) {
    Vector dr = d + ns * (2.0f * -dot(d, ns));
    if (!(dot(dr, ng) > 0)) dr = d + ng * (2.0f * -dot(d, ng));
    next.reflection_direction = unit(dr);
    next.reflection = !is_zero(next.reflection_direction);
  }
  return next;
}

template <class R>
Vector add(Vector sum, Vector color) {
  return from(to<R>(sum) + to<R>(color));
}

template <class R>
Vector add_weighted(Vector sum, Vector weight, Vector color) {
  return from(to<R>(sum) + to<R>(weight) * to<R>(color));
}

#define ARTU_INSTANTIATE(R)                                                                                        \
  template Vector sky<R>(const ShadingConstants&, Vector);                                                         \
  template Vector begin_shading<R>(const ShadingConstants&, const Surface&, const MaterialRecord&, Vector, Vector, \
                                   Vector, ShadedPoint&);                                                          \
  template bool light_contribution<R>(const ShadedPoint&, const LightRecord&, ShadowRay&);                         \
  template NextRays next_rays<R>(const ShadingConstants&, const ShadedPoint&);                                     \
  template Vector add<R>(Vector, Vector);                                                                          \
  template Vector add_weighted<R>(Vector, Vector, Vector);
#include "hw/datapath/every_width.inc"

namespace {
template <class R>
constexpr ShadingSteps steps{&filter<R>,    &sky<R>, &begin_shading<R>, &light_contribution<R>,
                             &next_rays<R>, &add<R>, &add_weighted<R>};

template <int... I>
const ShadingSteps& of_width(int fraction_bits, std::integer_sequence<int, I...>) {
  static constexpr const ShadingSteps* all[] = {&steps<Real<fewest_fraction_bits + I>>...};
  return *all[fraction_bits - fewest_fraction_bits];
}
}  // namespace

const ShadingSteps& shading_steps(int fraction_bits) { return of_width(fraction_bits, EveryWidth()); }

}  // namespace artu::hw
