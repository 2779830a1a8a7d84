// Cameras and lights of a posed scene, in the unit's terms.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/import/emit.h"

namespace artu::sim {

/// A camera as a place and three axes (unit length, at right angles); it looks along -z, y is up.
struct CameraPlace {
  glm::dvec3 eye{0.0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
};

/// Axes from a node's world matrix; scale and shear are removed.
CameraPlace camera_place(const glm::dmat4& world);
CameraPlace look_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up);

/// The rays of a picture: the vertical field of view is kept, the width follows from the pixels.
traces::Camera make_camera(const CameraPlace& place, const CameraLens& lens, std::uint32_t width, std::uint32_t height);

/// A three-quarter view from slightly above that holds the whole box.
CameraPlace frame_box(const WorldBox& box, double fov, std::uint32_t width, std::uint32_t height);

/// A file's light in a pose, `exposure` times as bright.  Nothing where its matrix has no direction.
std::optional<traces::Light> make_light(const NodeLight& light, const glm::dmat4& world, double exposure);

/// The factor that gives the brightest of the file's lights an irradiance of 1 at the box's centre; 1 if all are dark.
double light_exposure(const Model& model, const Pose& pose, const WorldBox& box);

struct Surroundings {
  std::vector<traces::Light> lights;
  traces::Vec3 ambient, sky_nadir, sky_zenith;
};

/// Key and fill light relative to a camera, with a day's sky; or, for a scene with lights of its own, a dim sky alone.
Surroundings default_surroundings(const CameraPlace& camera, bool has_lights);

}  // namespace artu::sim
