// Small procedural scenes for the comparison of the unit with the golden model.
#pragma once

#include <string>
#include <vector>

#include "traces/frame.h"

namespace artu::golden_tests {

struct TestScene {
  traces::Scene scene;
  std::vector<traces::Frame> frames;
};

/// What a scene is made of; everything else is the same for all.
struct Recipe {
  std::uint32_t width = 48, height = 32;
  bool ground = true;  // static, textured
  bool static_sphere = true;
  bool moving_sphere = true;  // dynamic
  bool mirror = false, glass = false;
  unsigned point_lights = 1, directional_lights = 1, spot_lights = 0;
  unsigned frames = 1;
  unsigned subdivisions = 2;  // of the spheres
  float offset = 0;           // added to every coordinate
};

TestScene make_scene(const Recipe& recipe);

}  // namespace artu::golden_tests
