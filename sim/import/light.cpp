#include <algorithm>
#include <cmath>

#include "sim/import/surface.h"
#include "sim/import/view.h"

namespace artu::sim {
namespace {

constexpr double no_limit = 1.0e15;  // traces::Light::range where the file has none

std::optional<glm::dvec3> forward(const glm::dmat4& world) {
  const glm::dvec3 back(world[2]);
  const double length = glm::length(back);
  if (!(length > 1e-100) || !std::isfinite(length)) return std::nullopt;
  return -back / length;
}

double brightness(const glm::dvec3& c) { return std::max({c.x, c.y, c.z}); }

}  // namespace

std::optional<traces::Light> make_light(const NodeLight& light, const glm::dmat4& world, double exposure) {
  traces::Light out;
  out.kind = light.kind;
  out.color = to_vec3(light.color * exposure);
  out.position = to_vec3(glm::dvec3(world[3]));
  if (light.kind != traces::LightKind::point) {
    const auto direction = forward(world);
    if (!direction) return std::nullopt;
    out.direction = to_vec3(*direction);
  }
  if (light.kind == traces::LightKind::directional) out.position = {};
  out.range = static_cast<float>(light.range > 0 ? std::min(light.range, no_limit) : no_limit);
  if (light.kind == traces::LightKind::spot) {
    out.cos_inner = static_cast<float>(std::cos(light.inner));
    // The unit wants inner and outer apart.
    out.cos_outer = static_cast<float>(std::max(std::min(std::cos(light.outer), std::cos(light.inner) - 1e-4), -1.0));
  }
  return out;
}

double light_exposure(const Model& model, const Pose& pose, const WorldBox& box) {
  const glm::dvec3 center = box.empty() ? glm::dvec3(0.0) : box.center();
  // A lamp inside the scene lights its surroundings, not the one point at the centre.
  const double least = box.empty() ? 1.0 : std::max(0.25 * box.radius(), 1e-6);
  double brightest = 0;
  for (std::size_t n = 0; n < model.nodes.size(); ++n) {
    const Node& node = model.nodes[n];
    if (node.light < 0 || !node.visible) continue;
    const NodeLight& light = model.lights[node.light];
    double irradiance = brightness(light.color);
    if (light.kind != traces::LightKind::directional) {
      const double distance = std::max(glm::distance(glm::dvec3(pose.world[n][3]), center), least);
      irradiance /= distance * distance;
    }
    brightest = std::max(brightest, irradiance);
  }
  return brightest > 0 && std::isfinite(1 / brightest) ? 1 / brightest : 1;
}

Surroundings default_surroundings(const CameraPlace& camera, bool has_lights) {
  Surroundings out;
  if (has_lights) {
    out.ambient = {0.06f, 0.06f, 0.07f};
    out.sky_nadir = {0.10f, 0.10f, 0.10f};
    out.sky_zenith = {0.20f, 0.24f, 0.32f};
    return out;
  }
  const auto add = [&](double x, double y, double z, const glm::dvec3& color) {
    traces::Light light;
    light.kind = traces::LightKind::directional;
    light.direction = to_vec3(-glm::normalize(camera.x * x + camera.y * y + camera.z * z));
    light.color = to_vec3(color);
    out.lights.push_back(light);
  };
  add(-0.6, 0.9, 0.7, {0.95, 0.92, 0.86});   // key: over the left shoulder
  add(0.9, 0.25, 0.45, {0.16, 0.19, 0.24});  // fill: from the right, cool
  out.ambient = {0.16f, 0.18f, 0.21f};
  out.sky_nadir = {0.42f, 0.40f, 0.38f};
  out.sky_zenith = {0.30f, 0.46f, 0.78f};
  return out;
}

}  // namespace artu::sim
