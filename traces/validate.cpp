#include "traces/validate.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "traces/check.h"
#include "traces/limits.h"

namespace artu::traces {
namespace {

constexpr float uv_limit = 1048576.0f;  // 2^20, inclusive

/// Arrays are checked in two passes: one that only finds the largest bit pattern (no branch, so the
/// compiler makes it wide), and after a failure one that finds whose it is.
std::uint32_t magnitude_bits(float value) {
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits & 0x7FFFFFFFu;  // ordered as |value|, NaN above infinity
}

std::uint32_t largest_magnitude(const float* values, std::size_t count) {
  std::uint32_t largest = 0;
  for (std::size_t i = 0; i < count; ++i) largest = std::max(largest, magnitude_bits(values[i]));
  return largest;
}

template <typename Vector>
void check_vectors(const Check& check, const char* array, const std::vector<Vector>& v, std::uint32_t limit,
                   const char* range) {
  constexpr std::size_t n = sizeof(Vector) / sizeof(float);
  static_assert(sizeof(Vector) == n * sizeof(float));
  const float* values = reinterpret_cast<const float*>(v.data());
  const std::size_t count = v.size() * n;
  if (largest_magnitude(values, count) < limit) return;
  const float* bad = std::find_if(values, values + count, [=](float f) { return magnitude_bits(f) >= limit; });
  const auto at = static_cast<std::size_t>(bad - values);
  check.fail(Check::at(array, at / n) + "." + "xyz"[at % n], *bad, range);
}

void check_indices(const Check& check, const char* array, const std::vector<std::uint32_t>& v, std::size_t limit,
                   const char* of) {
  std::uint32_t largest = 0;
  for (const std::uint32_t i : v) largest = std::max(largest, i);
  if (v.empty() || largest < limit) return;
  const auto bad = std::find_if(v.begin(), v.end(), [=](std::uint32_t i) { return i >= limit; });
  check.fail(Check::at(array, static_cast<std::size_t>(bad - v.begin())), *bad,
             "below " + std::to_string(limit) + ", the number of " + of);
}

void check_mesh(const Check& check, const Mesh& mesh, std::size_t materials) {
  const std::size_t vertices = mesh.positions.size(), triangles = mesh.triangle_count();
  check.at_most("the number of vertices", vertices, max_elements);
  check.at_most("the number of triangles", triangles, max_elements);
  const std::string as_positions = ", as positions";
  check.size("normals", mesh.normals.size(), vertices, as_positions);
  check.size("uvs", mesh.uvs.size(), vertices, as_positions);
  check.size("colors", mesh.colors.size(), vertices, as_positions);
  check.size("indices", mesh.indices.size(), 3 * triangles, ", three a triangle");
  const std::uint32_t limit = magnitude_bits(coordinate_limit);
  check_vectors(check, "positions", mesh.positions, limit, Check::coordinate_range);
  check_vectors(check, "normals", mesh.normals, limit, Check::coordinate_range);
  check_vectors(check, "uvs", mesh.uvs, magnitude_bits(uv_limit) + 1, "finite and at most 2^20 in magnitude");
  check_indices(check, "indices", mesh.indices, vertices, "vertices");
  check_indices(check, "materials", mesh.materials, materials, "the scene's materials");
}

void check_material(const Check& check, const Material& m, std::size_t textures) {
  check.text("name", m.name);
  check.weight("diffuse", m.diffuse);
  check.weight("specular", m.specular);
  check.at_most("specular_log2", m.specular_log2, 10);
  check.weight("mirror", m.mirror);
  check.weight("transmission", m.transmission);
  check.that(m.ior >= 0.25f && m.ior <= 4.0f, "ior", m.ior, "0.25 ... 4");
  check.weight("emission", m.emission);
  if (m.texture < -1 || m.texture >= static_cast<std::int64_t>(textures)) {
    check.fail("texture", m.texture, "-1 or below " + std::to_string(textures) + ", the number of textures");
  }
}

void check_texture(const Check& check, const Texture& t) {
  check.text("name", t.name);
  check.side("width", t.width);
  check.side("height", t.height);
  check.enumeration("wrap_u", static_cast<std::uint8_t>(t.wrap_u), "repeat, clamp or mirror: 0 ... 2");
  check.enumeration("wrap_v", static_cast<std::uint8_t>(t.wrap_v), "repeat, clamp or mirror: 0 ... 2");
  check.size("rgba", t.rgba.size(), std::size_t{t.width} * t.height * 4, ", four a texel");
}

void check_light(const Check& check, const Light& l) {
  check.enumeration("kind", static_cast<std::uint8_t>(l.kind), "point, directional or spot: 0 ... 2");
  check.coordinate("position", l.position);
  check.coordinate("direction", l.direction);
  check.weight("color", l.color);
  check.coordinate("range", l.range);
  check.coordinate("cos_inner", l.cos_inner);
  check.coordinate("cos_outer", l.cos_outer);
  if (l.kind != LightKind::directional) check.that(l.range > 0, "range", l.range, "above 0");
  if (l.kind != LightKind::point) {
    const double x = l.direction.x, y = l.direction.y, z = l.direction.z, length = std::sqrt(x * x + y * y + z * z);
    check.that(std::fabs(length - 1) <= 1e-3, "the length of direction", length, "1, within 0.001");
  }
  if (l.kind == LightKind::spot) {
    check.that(l.cos_inner <= 1, "cos_inner", l.cos_inner, "at most 1");
    check.that(l.cos_outer >= -1, "cos_outer", l.cos_outer, "at least -1");
    check.that(l.cos_outer < l.cos_inner, "cos_outer", l.cos_outer,
               "below cos_inner, which is " + Check::show(l.cos_inner));
  }
}

}  // namespace

void validate(const Scene& scene, const std::string& where) {
  const Check check(where);
  check.text("name", scene.name);
  check.text("generator", scene.generator);
  check.side("width", scene.width);
  check.side("height", scene.height);
  check.that(std::isfinite(scene.fps) && scene.fps > 0, "fps", scene.fps, "finite and above 0");
  check.at_most("the number of materials", scene.materials.size(), max_materials);
  check.at_most("the number of textures", scene.textures.size(), max_textures);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    check_material(check.inside("materials", i), scene.materials[i], scene.textures.size());
  }
  for (std::size_t i = 0; i < scene.textures.size(); ++i) {
    check_texture(check.inside("textures", i), scene.textures[i]);
  }
  check_mesh(check.inside("static geometry"), scene.static_geometry, scene.materials.size());
}

void validate(const Scene& scene, const Frame& frame, const std::string& where) {
  const Check check(where);
  check.that(std::isfinite(frame.time), "time", frame.time, "finite");
  const Check camera = check.inside("camera");
  camera.coordinate("origin", frame.camera.origin);
  camera.coordinate("origin_du", frame.camera.origin_du);
  camera.coordinate("origin_dv", frame.camera.origin_dv);
  camera.coordinate("corner", frame.camera.corner);
  camera.coordinate("du", frame.camera.du);
  camera.coordinate("dv", frame.camera.dv);
  check.at_most("the number of lights", frame.lights.size(), max_lights);
  for (std::size_t i = 0; i < frame.lights.size(); ++i) check_light(check.inside("lights", i), frame.lights[i]);
  check.weight("ambient", frame.ambient);
  check.weight("sky_nadir", frame.sky_nadir);
  check.weight("sky_zenith", frame.sky_zenith);
  check_mesh(check.inside("dynamic geometry"), frame.dynamic, scene.materials.size());
}

}  // namespace artu::traces
