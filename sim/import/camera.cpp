#include <algorithm>
#include <cmath>

#include "sim/import/surface.h"
#include "sim/import/view.h"

namespace artu::sim {
namespace {

glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& otherwise) {
  const double length = glm::length(v);
  return length > 1e-100 && std::isfinite(length) ? v / length : otherwise;
}

/// Right-handed axes with the given back direction, `up` made to be at right angles to it.
CameraPlace place_from(const glm::dvec3& eye, const glm::dvec3& back, const glm::dvec3& up) {
  CameraPlace place;
  place.eye = eye;
  place.z = unit_or(back, {0, 0, 1});
  const glm::dvec3 side = std::abs(place.z.y) < 0.999 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
  place.x = unit_or(glm::cross(up, place.z), unit_or(glm::cross(side, place.z), {1, 0, 0}));
  place.y = glm::cross(place.z, place.x);
  return place;
}

}  // namespace

CameraPlace camera_place(const glm::dmat4& world) {
  return place_from(glm::dvec3(world[3]), glm::dvec3(world[2]), glm::dvec3(world[1]));
}

CameraPlace look_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up) {
  return place_from(eye, eye - target, up);
}

traces::Camera make_camera(const CameraPlace& place, const CameraLens& lens, std::uint32_t width,
                           std::uint32_t height) {
  const double half_y = lens.perspective ? std::tan(lens.fov / 2) : lens.half_height;
  const double half_x = half_y * width / height;
  const glm::dvec3 corner = place.y * half_y - place.x * half_x;
  const glm::dvec3 du = place.x * (2 * half_x / width), dv = place.y * (-2 * half_y / height);
  traces::Camera camera;
  if (lens.perspective) {
    camera.origin = to_vec3(place.eye);
    camera.corner = to_vec3(corner - place.z);
    camera.du = to_vec3(du);
    camera.dv = to_vec3(dv);
  } else {
    camera.origin = to_vec3(place.eye + corner);
    camera.origin_du = to_vec3(du);
    camera.origin_dv = to_vec3(dv);
    camera.corner = to_vec3(-place.z);
  }
  return camera;
}

CameraPlace frame_box(const WorldBox& box, double fov, std::uint32_t width, std::uint32_t height) {
  const glm::dvec3 center = box.center();
  CameraPlace place = look_at(center + glm::dvec3(0.62, 0.42, 1.0), center, {0, 1, 0});
  const double tan_y = std::tan(fov / 2), tan_x = tan_y * width / height;
  double distance = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p = glm::dvec3(corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                                    corner & 4 ? box.high.z : box.low.z) -
                         center;
    const double x = std::abs(glm::dot(p, place.x)), y = std::abs(glm::dot(p, place.y)), z = glm::dot(p, place.z);
    distance = std::max({distance, z + x / tan_x, z + y / tan_y});
  }
  place.eye = center + place.z * std::max(distance * 1.08, 1e-3);
  return place;
}

}  // namespace artu::sim
