// Reflection and refraction: weights and directions (docs/arithmetic.md section 7, "Next rays").
#pragma once

#include "ref/hit_point.h"

namespace artu::ref {

struct Scatter {
  Vec3 reflection;  // R, the weight of the reflection ray
  Vec3 refraction;  // Q, of the refraction ray; 0 on total internal reflection
  Vec3 refracted;   // dt, unit length or (0, 0, 0); meaningful where Q is not 0
};

/// Splits by Schlick's Fresnel term.  `kr` and `kt` are the surface's weights, `direction` the ray's.
Scatter scatter(const HitPoint& point, const Vec3& direction, const Vec3& kr, const Vec3& kt, float ior);

/// dr, the mirrored direction, on the ray's own side of the surface; unit length or (0, 0, 0).
Vec3 reflected(const HitPoint& point, const Vec3& direction);

}  // namespace artu::ref
