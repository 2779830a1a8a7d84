// Shading and next-ray set-up (docs/arithmetic.md section 7), as steps between which a shadow ray is traced.
//
// Each step is a template on the shading datapath's number type R, instantiated for every width; ShadingSteps has
// those of one width.  Registers between the steps are binary32 and hold values of the format.
#pragma once

#include "hw/datapath/hit_point.h"
#include "hw/datapath/texture.h"

namespace artu::hw {

/// What every ray of a frame needs to be shaded.
struct ShadingConstants {
  Vector ambient, sky_nadir, sky_zenith;
  std::uint32_t max_depth = 0;
  float min_weight = 0;
};

/// Colour of a ray that misses.
template <class R = float>
Vector sky(const ShadingConstants& constants, Vector direction);

/// A hit's material after its texture, where the light loop and the next rays read it.
struct ShadedPoint {
  Vector direction;                                          // of the ray that hit, binary32
  Vector geometric_normal, shading_normal, outside, inside;  // binary32
  Vector weight;                                             // T
  Vector diffuse, specular, mirror, transmission;
  float ior = 1;
  std::uint32_t specular_log2 = 0;
  bool front = true;
};

/// Fills the point; returns emission and ambient, to be added to the pixel with weight T.
template <class R = float>
Vector begin_shading(const ShadingConstants& constants, const Surface& surface, const MaterialRecord& material,
                     Vector texture, Vector direction, Vector weight, ShadedPoint& point);

/// A shadow ray towards a light and what the light adds (already weighted) if the ray hits nothing.
struct ShadowRay {
  Vector direction;
  float tmax = two_pow_100;
  Vector contribution;
};

/// False if the light cannot add anything: no shadow ray.
template <class R = float>
bool light_contribution(const ShadedPoint& point, const LightRecord& light, ShadowRay& shadow);

/// Direction and length alone; false if there is no ray: the light is too near or too far for binary32.
bool aim(const ShadedPoint& point, const LightRecord& light, ShadowRay& shadow);

/// Rays to follow from a hit; a weight is zero where there is no ray.
struct NextRays {
  bool reflection = false, refraction = false;
  Vector reflection_direction, reflection_weight;
  Vector refraction_direction, refraction_weight;
};

template <class R = float>
NextRays next_rays(const ShadingConstants& constants, const ShadedPoint& point);

/// The pixel's sum: `sum + color`, and `sum + weight * color`.
template <class R = float>
Vector add(Vector sum, Vector color);
template <class R = float>
Vector add_weighted(Vector sum, Vector weight, Vector color);

/// All of the above, and the texture filter, with so many stored fraction bits.
struct ShadingSteps {
  decltype(&hw::filter<float>) filter;
  decltype(&hw::sky<float>) sky;
  decltype(&hw::begin_shading<float>) begin_shading;
  decltype(&hw::light_contribution<float>) light_contribution;
  decltype(&hw::next_rays<float>) next_rays;
  decltype(&hw::add<float>) add;
  decltype(&hw::add_weighted<float>) add_weighted;
};
const ShadingSteps& shading_steps(int fraction_bits);

}  // namespace artu::hw
