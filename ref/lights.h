// Light that arrives at a point, before shadows (docs/arithmetic.md section 7, "Lights", steps 1 to 4).
#pragma once

#include "ref/hit_point.h"

namespace artu::ref {

struct LightSample {
  Vec3 towards;    // L
  Vec3 intensity;  // I
  Vec3 shadow;     // direction of the shadow ray, from Pout
  float tmax;      // of the shadow ray
};

/// False where the light does not reach `point` (out of range, or too close or too far for binary32).
bool sample_light(const traces::Light& light, const Vec3& point, LightSample& sample);

/// The weights of a material at a hit, with texture and vertex colour applied.
struct Surface {
  Vec3 kd, kt, ks, kr;
};

/// `tex` is the texture's colour times the vertex colour.
Surface surface_of(const traces::Material& material, const Vec3& tex);

/// What the light adds to the pixel if it is not in shadow (C, with the ray's weight T); false where step 2 or 4 skips.
bool contribution(const LightSample& light, const HitPoint& point, const Vec3& direction, const Surface& surface,
                  unsigned specular_log2, const Vec3& weight, Vec3& result);

}  // namespace artu::ref
