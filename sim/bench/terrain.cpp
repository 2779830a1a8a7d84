#include "sim/bench/terrain.h"

#include <cmath>

namespace artu::sim {
namespace {

float hills(float x, float z) {
  return 0.12f * std::sin(5 * x) * std::cos(4 * z) + 0.05f * std::sin(13 * x + 2) * std::sin(11 * z);
}

}  // namespace

traces::Scene terrain(std::uint32_t edge, std::uint32_t width, std::uint32_t height) {
  traces::Scene scene;
  scene.name = "terrain";
  scene.width = width;
  scene.height = height;
  scene.frame_count = 1;
  traces::Material& material = scene.materials.emplace_back();
  material.diffuse = {0.5f, 0.6f, 0.3f};
  traces::Mesh& mesh = scene.static_geometry;
  for (std::uint32_t row = 0; row <= edge; ++row) {
    for (std::uint32_t column = 0; column <= edge; ++column) {
      const float x = 2 * static_cast<float>(column) / static_cast<float>(edge) - 1;
      const float z = 2 * static_cast<float>(row) / static_cast<float>(edge) - 1;
      mesh.positions.push_back({x, hills(x, z), z});
    }
  }
  mesh.normals.resize(mesh.positions.size());  // zero: those of the triangles
  mesh.uvs.resize(mesh.positions.size());
  mesh.colors.resize(mesh.positions.size(), 0xffffffffu);
  for (std::uint32_t row = 0; row < edge; ++row) {
    for (std::uint32_t column = 0; column < edge; ++column) {
      const std::uint32_t a = row * (edge + 1) + column, b = a + edge + 1;
      mesh.indices.insert(mesh.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
    }
  }
  mesh.materials.assign(std::size_t{2} * edge * edge, 0);
  return scene;
}

traces::Frame terrain_frame(std::uint32_t width, std::uint32_t height) {
  traces::Frame frame;
  const float across = 1.0f, down = across * static_cast<float>(height) / static_cast<float>(width);
  // At (0, 1.5, 1.9), looking down by about 42 degrees: right is x, up and forward lie in the plane of y and z.
  const float cosine = 0.743f, sine = 0.669f;
  const traces::Vec3 forward{0, -sine, -cosine}, up{0, cosine, -sine};
  frame.camera.origin = {0, 1.5f, 1.9f};
  frame.camera.corner = {forward.x - across / 2, forward.y + up.y * down / 2, forward.z + up.z * down / 2};
  frame.camera.du = {across / static_cast<float>(width), 0, 0};
  frame.camera.dv = {0, -up.y * down / static_cast<float>(height), -up.z * down / static_cast<float>(height)};
  traces::Light& light = frame.lights.emplace_back();
  light.kind = traces::LightKind::directional;
  light.direction = {0.6f, -0.64f, -0.48f};
  frame.ambient = {0.1f, 0.1f, 0.12f};
  frame.sky_nadir = {0.7f, 0.7f, 0.75f};
  frame.sky_zenith = {0.1f, 0.3f, 0.8f};
  return frame;
}

}  // namespace artu::sim
