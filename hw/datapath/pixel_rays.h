// Which rays a pixel takes, and in which order (docs/arithmetic.md section 7): the rules, without time and memory.
#pragma once

#include <array>
#include <vector>

#include "hw/datapath/shading.h"
#include "hw/memory/image.h"

namespace artu::hw {

enum class RayKind : std::uint8_t { primary, shadow, reflection, refraction };
inline constexpr std::size_t ray_kinds = 4;

inline constexpr std::size_t maximum_depth = 16;

struct PendingRay {
  Vector origin, direction, weight;
  RayKind kind = RayKind::reflection;
  std::uint8_t depth = 0;
};

/// Last in, first out: a reflection ray is followed to its end before the refraction ray of the same hit.
class PendingRays {
 public:
  void clear() { count_ = 0; }
  bool empty() const { return count_ == 0; }
  /// The rays that follow from a hit of a ray of this depth.
  void add(const NextRays& next, const ShadedPoint& point, std::uint8_t depth) {
    const auto below = static_cast<std::uint8_t>(depth + 1);
    if (next.refraction) {
      rays_[count_++] = {point.inside, next.refraction_direction, next.refraction_weight, RayKind::refraction, below};
    }
    if (next.reflection) {
      rays_[count_++] = {point.outside, next.reflection_direction, next.reflection_weight, RayKind::reflection, below};
    }
  }
  /// Its reference holds until the next add().
  const PendingRay& take() { return rays_[--count_]; }

 private:
  std::array<PendingRay, maximum_depth + 2> rays_;
  std::uint32_t count_ = 0;
};

/// Looks at the lights from `light` on, which ends behind the last one looked at; true if that one asks for a shadow
/// ray.  Without `skip` one that can add nothing does as well, if there is a ray towards it.
inline bool next_shadow_ray(const ShadingSteps& steps, const std::vector<LightRecord>& lights, const ShadedPoint& point,
                            std::uint32_t& light, ShadowRay& shadow, bool skip = true) {
  while (light < lights.size()) {
    const LightRecord& record = lights[light++];
    if (steps.light_contribution(point, record, shadow)) return true;
    if (!skip && aim(point, record, shadow)) {
      shadow.contribution = {};
      return true;
    }
  }
  return false;
}

/// The texture at a footprint; white without one.
inline Vector texture_at(const ShadingSteps& steps, const MemoryImage& image, const MaterialRecord& material,
                         const TextureFootprint& footprint) {
  if (material.texels == 0) return {1, 1, 1};
  std::array<std::uint32_t, 4> texels{};
  for (std::size_t i = 0; i < 4; ++i) {
    texels[i] = image.at<std::uint32_t>(
        texel_address(material.texels, material.width, footprint.x[i & 1], footprint.y[i >> 1]));
  }
  return steps.filter(footprint, texels);
}

}  // namespace artu::hw
