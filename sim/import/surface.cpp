#include "sim/import/surface.h"

#include <algorithm>
#include <cmath>

namespace artu::sim {
namespace {

// A weight below this is not worth a ray: no code of an 8-bit picture would show most of them.
constexpr double least_mirror = 0.02;

}  // namespace

traces::Vec3 to_vec3(const glm::dvec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

std::uint32_t specular_log2(double roughness) {
  const double alpha = std::max(roughness * roughness, 1e-3);
  const double exponent = std::max(2.0 / (alpha * alpha) - 2.0, 1.0);
  return static_cast<std::uint32_t>(std::clamp(std::round(std::log2(exponent)), 0.0, 10.0));
}

void map_surface(const Surface& s, traces::Material& out) {
  const double metal = s.metallic, rough = s.roughness, dielectric = 1 - metal;
  const double smooth = (1 - rough) * (1 - rough);
  out.specular_log2 = specular_log2(rough);
  // The peak of a highlight grows with its exponent so that its energy stays; cut off at white.
  const double peak = (std::exp2(out.specular_log2) + 8) / 8;
  // A rough metal scatters: without a diffuse part it would be black where no highlight is.
  const glm::dvec3 diffuse = s.base * (dielectric * (1 - s.transmission) + metal * rough);
  const glm::dvec3 specular = dielectric * glm::min(s.f0 * peak, glm::dvec3(1.0)) + s.base * (metal * (1 - rough));
  // Refraction brings its own Fresnel reflection, so that only what bends nothing needs a mirror weight for it.
  const double plain = s.transmission > 0 && s.ior != 1 ? 1 - s.transmission : 1;
  glm::dvec3 mirror = s.base * (metal * smooth) + s.f0 * (dielectric * plain * smooth);
  if (std::max({mirror.x, mirror.y, mirror.z}) < least_mirror) mirror = glm::dvec3(0.0);
  out.diffuse = to_vec3(diffuse);
  out.specular = to_vec3(specular);
  out.mirror = to_vec3(mirror);
  out.transmission = to_vec3(s.base * (dielectric * s.transmission));
  out.ior = static_cast<float>(std::clamp(s.ior, 0.25, 4.0));
  out.tint = metal > 0.5;  // a metal colours what it reflects
}

}  // namespace artu::sim
