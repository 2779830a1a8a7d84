// Physically based descriptions of a surface, as the unit's diffuse / specular / mirror / refraction model.
#pragma once

#include <glm/glm.hpp>

#include "traces/frame.h"

namespace artu::sim {

/// What both glTF material models, and OBJ's, come down to before the mapping.
struct Surface {
  glm::dvec3 base{1.0};     // linear
  double metallic = 0;      // 0 ... 1
  double roughness = 1;     // 0 ... 1
  double transmission = 0;  // 0 ... 1: share of the light that enters instead of being scattered
  double ior = 1.5;         // of the inside; 1 does not bend
  glm::dvec3 f0{0.04};      // reflectance of the dielectric at normal incidence
};

/// Fills the weights of `out` (not its name, texture or emission); docs/scenes.md has the table.
void map_surface(const Surface& surface, traces::Material& out);

/// The Blinn-Phong exponent 2^n nearest to a roughness, n = 0 ... 10.
std::uint32_t specular_log2(double roughness);

traces::Vec3 to_vec3(const glm::dvec3& v);

}  // namespace artu::sim
