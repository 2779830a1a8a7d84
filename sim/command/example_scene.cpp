#include "sim/command/example_scene.h"

namespace artu::sim {

traces::Scene example_scene() {
  traces::Scene scene;
  scene.name = "example";
  scene.width = scene.height = 8;
  scene.frame_count = 1;
  scene.materials.emplace_back();
  traces::Mesh& mesh = scene.static_geometry;
  mesh.positions = {{-1, -1, -2}, {1, -1, -2}, {0, 1, -2}};
  mesh.normals.resize(3, {0, 0, 1});
  mesh.uvs.resize(3);
  mesh.colors.resize(3, 0xffffffffu);
  mesh.indices = {0, 1, 2};
  mesh.materials = {0};
  return scene;
}

traces::Frame example_frame() {
  traces::Frame frame;
  frame.camera.corner = {-1, 1, -1};
  frame.camera.du = {0.25f, 0, 0};
  frame.camera.dv = {0, -0.25f, 0};
  frame.ambient = {0.1f, 0.1f, 0.1f};
  frame.lights.emplace_back();
  return frame;
}

}  // namespace artu::sim
