#include "golden/scenes.h"

#include <array>
#include <cmath>
#include <map>

namespace artu::golden_tests {

namespace {

using traces::Vec2;
using traces::Vec3;

Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec3 operator*(Vec3 a, float s) { return {a.x * s, a.y * s, a.z * s}; }
Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
Vec3 normalized(Vec3 a) { return a * (1 / std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z)); }

std::uint32_t add_vertex(traces::Mesh& mesh, Vec3 position, Vec3 normal, Vec2 uv, std::uint32_t color = 0xffffffffu) {
  mesh.positions.push_back(position);
  mesh.normals.push_back(normal);
  mesh.uvs.push_back(uv);
  mesh.colors.push_back(color);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

void add_triangle(traces::Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t material) {
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
  mesh.materials.push_back(material);
}

void add_ground(traces::Mesh& mesh, Vec3 at, float size) {
  std::array<std::uint32_t, 4> corner{};
  for (unsigned i = 0; i < 4; ++i) {
    const float x = (i & 1) != 0 ? size : -size, z = (i & 2) != 0 ? size : -size;
    corner[i] = add_vertex(mesh, at + Vec3{x, 0, z}, {0, 1, 0}, {x, z});
  }
  add_triangle(mesh, corner[0], corner[2], corner[1], 0);
  add_triangle(mesh, corner[1], corner[2], corner[3], 0);
}

/// A subdivided octahedron with shared vertices.
void add_sphere(traces::Mesh& mesh, Vec3 center, float radius, unsigned subdivisions, std::uint32_t material) {
  std::vector<std::array<Vec3, 3>> faces;
  for (int sx : {-1, 1}) {
    for (int sy : {-1, 1}) {
      for (int sz : {-1, 1}) {
        const Vec3 x{static_cast<float>(sx), 0, 0}, y{0, static_cast<float>(sy), 0}, z{0, 0, static_cast<float>(sz)};
        faces.push_back(sx * sy * sz > 0 ? std::array<Vec3, 3>{x, y, z} : std::array<Vec3, 3>{x, z, y});
      }
    }
  }
  for (unsigned i = 0; i < subdivisions; ++i) {
    std::vector<std::array<Vec3, 3>> finer;
    for (const auto& [a, b, c] : faces) {
      const Vec3 ab = normalized(a + b), bc = normalized(b + c), ca = normalized(c + a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    faces = std::move(finer);
  }
  std::map<std::array<float, 3>, std::uint32_t> shared;
  for (const auto& face : faces) {
    std::array<std::uint32_t, 3> index{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 n = face[i];
      const auto [place, added] = shared.try_emplace({n.x, n.y, n.z}, 0);
      if (added) {
        const auto code = [](float v) { return static_cast<std::uint32_t>(155 + 100 * v) & 255u; };
        place->second = add_vertex(mesh, center + n * radius, n, {n.x, n.y},
                                   code(n.x) | code(n.y) << 8 | code(n.z) << 16 | 0xff000000u);
      }
      index[i] = place->second;
    }
    add_triangle(mesh, index[0], index[1], index[2], material);
  }
}

traces::Texture checker() {
  traces::Texture texture;
  texture.name = "checker";
  texture.width = 5;  // not a multiple of the unit's texel tiles
  texture.height = 6;
  texture.wrap_v = traces::Wrap::mirror;
  for (std::uint32_t y = 0; y < texture.height; ++y) {
    for (std::uint32_t x = 0; x < texture.width; ++x) {
      const auto value = static_cast<std::uint8_t>((x + y) % 2 != 0 ? 220 : 40);
      texture.rgba.insert(texture.rgba.end(), {value, static_cast<std::uint8_t>(40 * x), value, 255});
    }
  }
  return texture;
}

std::vector<traces::Material> materials(const Recipe& recipe) {
  traces::Material ground, still, moving;
  ground.texture = 0;
  still.diffuse = {0.2f, 0.5f, 0.3f};
  still.specular = {0.4f, 0.4f, 0.4f};
  if (recipe.mirror) still.mirror = {0.7f, 0.75f, 0.8f};
  moving.diffuse = {0.7f, 0.25f, 0.2f};
  moving.emission = {0.02f, 0.0f, 0.0f};
  if (recipe.glass) {
    moving.transmission = {0.9f, 0.9f, 0.85f};
    moving.ior = 1.5f;
    moving.specular = {0.3f, 0.3f, 0.3f};
    moving.specular_log2 = 8;
    moving.tint = true;
  }
  return {ground, still, moving};
}

std::vector<traces::Light> lights(const Recipe& recipe, Vec3 at) {
  std::vector<traces::Light> lights;
  for (unsigned i = 0; i < recipe.point_lights; ++i) {
    traces::Light light;
    light.position = at + Vec3{2.0f - static_cast<float>(i), 4, 2};
    light.color = {12, 11, 10};
    lights.push_back(light);
  }
  for (unsigned i = 0; i < recipe.directional_lights; ++i) {
    traces::Light light;
    light.kind = traces::LightKind::directional;
    light.direction = normalized({-0.5f, -1, -0.3f - static_cast<float>(i)});
    light.color = {0.5f, 0.5f, 0.6f};
    lights.push_back(light);
  }
  for (unsigned i = 0; i < recipe.spot_lights; ++i) {
    traces::Light light;
    light.kind = traces::LightKind::spot;
    light.position = at + Vec3{-2, 4, 1};
    light.direction = normalized({0.5f, -1, -0.2f});
    light.color = {20, 20, 5};
    light.range = 9;
    light.cos_inner = 0.95f;
    light.cos_outer = 0.85f;
    lights.push_back(light);
  }
  return lights;
}

traces::Camera camera(const Recipe& recipe, Vec3 eye, Vec3 target) {
  const Vec3 forward = normalized(target - eye);
  const Vec3 right = normalized(cross(forward, {0, 1, 0}));
  const Vec3 up = cross(right, forward);
  const float half = 0.45f;
  const float aspect = static_cast<float>(recipe.width) / static_cast<float>(recipe.height);
  traces::Camera camera;
  camera.origin = eye;
  camera.corner = forward - right * (half * aspect) + up * half;
  camera.du = right * (2 * half * aspect / static_cast<float>(recipe.width));
  camera.dv = up * (-2 * half / static_cast<float>(recipe.height));
  return camera;
}

}  // namespace

TestScene make_scene(const Recipe& recipe) {
  TestScene test;
  const Vec3 at{recipe.offset, recipe.offset, recipe.offset};
  traces::Scene& scene = test.scene;
  scene.name = "procedural";
  scene.width = recipe.width;
  scene.height = recipe.height;
  scene.frame_count = recipe.frames;
  scene.materials = materials(recipe);
  scene.textures = {checker()};
  if (recipe.ground) add_ground(scene.static_geometry, at, 6);
  if (recipe.static_sphere) add_sphere(scene.static_geometry, at + Vec3{-1.1f, 1, 0}, 1, recipe.subdivisions, 1);
  for (unsigned i = 0; i < recipe.frames; ++i) {
    traces::Frame frame;
    frame.index = i;
    frame.time = i / 30.0;
    frame.camera = camera(recipe, at + Vec3{0, 2.5f, 6}, at + Vec3{0, 0.8f, 0});
    frame.lights = lights(recipe, at);
    frame.ambient = {0.1f, 0.1f, 0.12f};
    frame.sky_nadir = {0.3f, 0.3f, 0.3f};
    frame.sky_zenith = {0.2f, 0.35f, 0.7f};
    if (recipe.moving_sphere) {
      const float x = 1.1f + 0.2f * static_cast<float>(i);
      add_sphere(frame.dynamic, at + Vec3{x, 0.9f, 0.4f}, 0.8f, recipe.subdivisions, 2);
    }
    test.frames.push_back(std::move(frame));
  }
  return test;
}

}  // namespace artu::golden_tests
