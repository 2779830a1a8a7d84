// Small scenes drawn from a recipe: triangles of both classes, every kind of material, light and camera.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/stress/random.h"
#include "traces/frame.h"

namespace artu::sim {

/// Everything that makes a scene; smaller numbers are simpler ones.
struct SceneRecipe {
  std::uint64_t seed = 0;
  std::uint32_t width = 1, height = 1;  // pixels
  std::uint32_t static_triangles = 0, dynamic_triangles = 0;
  std::uint32_t materials = 1, textures = 0, lights = 0;
  std::uint32_t frames = 1;

  /// All that a shrinker may make smaller, each with its least value.
  struct Number {
    const char* name;
    std::uint32_t SceneRecipe::*value;
    std::uint32_t least;
  };
  static const std::vector<Number>& numbers();
};

struct DrawnScene {
  traces::Scene scene;
  std::vector<traces::Frame> frames;
};

SceneRecipe draw_recipe(Random& random);
/// Valid as traces::validate has it.
DrawnScene make_scene(const SceneRecipe& recipe);
/// "7x5, 12 static and 3 dynamic triangles, ...".
std::string describe(const SceneRecipe& recipe);

}  // namespace artu::sim
