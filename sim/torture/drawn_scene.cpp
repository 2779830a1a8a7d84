#include "sim/torture/drawn_scene.h"

#include <fmt/format.h>

namespace artu::sim {
namespace {

using traces::Vec3;

Vec3 vec3(const hw::Vector& v) { return {v.x, v.y, v.z}; }
Vec3 color(Random& random, float most) {
  const float r = random.between(0, most), g = random.between(0, most), b = random.between(0, most);
  return {r, g, b};
}
bool one_in(Random& random, std::uint32_t n) { return random.below(n) == 0; }

traces::Material material(Random& random, std::uint32_t textures) {
  traces::Material material;
  material.diffuse = color(random, 1);
  if (one_in(random, 2)) material.specular = color(random, 1);
  material.specular_log2 = random.below(11);
  if (one_in(random, 3)) material.mirror = color(random, 1);
  if (one_in(random, 3)) material.transmission = color(random, 1);
  material.ior = random.between(0.25f, 4);
  if (one_in(random, 4)) material.emission = color(random, 2);
  if (textures != 0 && one_in(random, 2)) material.texture = static_cast<std::int32_t>(random.below(textures));
  material.tint = one_in(random, 2);
  return material;
}

traces::Texture texture(Random& random) {
  traces::Texture texture;
  texture.width = 1 + random.below(9);
  texture.height = 1 + random.below(9);
  texture.wrap_u = static_cast<traces::Wrap>(random.below(3));
  texture.wrap_v = static_cast<traces::Wrap>(random.below(3));
  texture.rgba.resize(std::size_t{4} * texture.width * texture.height);
  for (std::uint8_t& code : texture.rgba) code = static_cast<std::uint8_t>(random.below(256));
  return texture;
}

/// Of all sizes; one in eight has no area, one in eight lies in an axis' plane.
traces::Mesh mesh(Random& random, std::uint32_t triangles, std::uint32_t materials) {
  traces::Mesh mesh;
  for (std::uint32_t i = 0; i < triangles; ++i) {
    const hw::Vector middle = random.within(2);
    const float half = random.between(0.01f, 2);
    const std::uint32_t kind = random.below(8);
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      Vec3 at = vec3(middle + random.within(half));
      if (kind == 0 && corner == 2) at = mesh.positions.back();
      if (kind == 1) at.y = middle.y;
      mesh.positions.push_back(at);
      mesh.normals.push_back(one_in(random, 4) ? Vec3{} : vec3(random.direction()));
      const float u = random.between(-3, 3), v = random.between(-3, 3);
      mesh.uvs.push_back({u, v});
      mesh.colors.push_back(random.below(std::uint64_t{1} << 32 >> 1) * 2u + 1u);
      mesh.indices.push_back(3 * i + corner);
    }
    mesh.materials.push_back(random.below(materials));
  }
  return mesh;
}

traces::Light light(Random& random) {
  traces::Light light;
  light.kind = static_cast<traces::LightKind>(random.below(3));
  light.position = vec3(random.within(6));
  // An axis: a unit vector to the last bit.
  const float sign = random.sign();
  light.direction = std::vector<Vec3>{{sign, 0, 0}, {0, -1, 0}, {0, 0, sign}}[random.below(3)];
  light.color = color(random, 20);
  if (one_in(random, 3)) light.range = random.between(0.5f, 10);
  light.cos_outer = random.between(-1, 0.8f);
  light.cos_inner = random.between(0.85f, 1);
  return light;
}

traces::Camera camera(Random& random, const SceneRecipe& recipe) {
  const auto w = static_cast<float>(recipe.width), h = static_cast<float>(recipe.height);
  const float half = random.between(0.1f, 1);
  traces::Camera camera;
  camera.origin = {random.between(-1, 1), random.between(-1, 1), random.between(0, 6)};
  if (one_in(random, 3)) {  // orthographic
    camera.origin.x -= 2 * half;
    camera.origin.y += 2 * half;
    camera.origin_du = {4 * half / w, 0, 0};
    camera.origin_dv = {0, -4 * half / h, 0};
    camera.corner = {0, 0, -1};
    return camera;
  }
  camera.corner = {-half, half, -1};
  camera.du = {2 * half / w, 0, 0};
  camera.dv = {0, -2 * half / h, 0};
  return camera;
}

}  // namespace

const std::vector<SceneRecipe::Number>& SceneRecipe::numbers() {
  static const std::vector<Number> all = {{"frames", &SceneRecipe::frames, 1},
                                          {"static", &SceneRecipe::static_triangles, 0},
                                          {"dynamic", &SceneRecipe::dynamic_triangles, 0},
                                          {"height", &SceneRecipe::height, 1},
                                          {"width", &SceneRecipe::width, 1},
                                          {"lights", &SceneRecipe::lights, 0},
                                          {"textures", &SceneRecipe::textures, 0},
                                          {"materials", &SceneRecipe::materials, 1}};
  return all;
}

SceneRecipe draw_recipe(Random& random) {
  SceneRecipe recipe;
  recipe.seed = random.next();
  recipe.width = 1 + random.below(20);
  recipe.height = 1 + random.below(20);
  recipe.static_triangles = one_in(random, 6) ? 0 : random.below(80);
  recipe.dynamic_triangles = one_in(random, 4) ? 0 : random.below(60);
  recipe.materials = 1 + random.below(5);
  recipe.textures = random.below(3);
  recipe.lights = random.below(4);
  recipe.frames = 1 + random.below(3);
  return recipe;
}

DrawnScene make_scene(const SceneRecipe& recipe) {
  // A stream for each part: a scene with fewer lights has the triangles it had.
  enum Part : std::uint64_t { materials, textures, statics, first_frame };
  const auto stream = [&](std::uint64_t part) { return Random(recipe.seed, part); };
  DrawnScene drawn;
  traces::Scene& scene = drawn.scene;
  scene.name = "torture";
  scene.generator = "artu torture";
  scene.width = recipe.width;
  scene.height = recipe.height;
  scene.frame_count = recipe.frames;
  Random random = stream(materials);
  for (std::uint32_t i = 0; i < recipe.materials; ++i) scene.materials.push_back(material(random, recipe.textures));
  random = stream(textures);
  for (std::uint32_t i = 0; i < recipe.textures; ++i) scene.textures.push_back(texture(random));
  random = stream(statics);
  scene.static_geometry = mesh(random, recipe.static_triangles, recipe.materials);
  for (std::uint32_t i = 0; i < recipe.frames; ++i) {
    random = stream(first_frame + i);
    traces::Frame frame;
    frame.index = i;
    frame.time = i / scene.fps;
    frame.camera = camera(random, recipe);
    frame.ambient = color(random, 0.3f);
    frame.sky_nadir = color(random, 1);
    frame.sky_zenith = color(random, 1);
    frame.dynamic_moved = i == 0 || !one_in(random, 3);
    for (std::uint32_t k = 0; k < recipe.lights; ++k) frame.lights.push_back(light(random));
    frame.dynamic =
        frame.dynamic_moved ? mesh(random, recipe.dynamic_triangles, recipe.materials) : drawn.frames.back().dynamic;
    drawn.frames.push_back(std::move(frame));
  }
  return drawn;
}

std::string describe(const SceneRecipe& recipe) {
  return fmt::format(
      "{}x{} pixels, {} static and {} dynamic triangles, {} materials, {} textures, {} lights, {} frames", recipe.width,
      recipe.height, recipe.static_triangles, recipe.dynamic_triangles, recipe.materials, recipe.textures,
      recipe.lights, recipe.frames);
}

}  // namespace artu::sim
