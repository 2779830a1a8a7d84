// What a frame is: geometry by class, camera, lights, materials, textures.
//
// Plain data, world space, binary32, linear light.  The hardware's driver and the golden model read
// this and nothing else.  Every struct states its units; `validate.h` states what is refused.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace artu::traces {

struct Vec2 {
  float x = 0, y = 0;
};

struct Vec3 {
  float x = 0, y = 0, z = 0;
};

enum class Wrap : std::uint8_t { repeat, clamp, mirror };

/// 8-bit sRGB texels, row 0 first, 4 bytes a texel (R, G, B, A); A is carried and not used by the unit.
/// (u, v) = (0, 0) is the corner of texel (0, 0), as in glTF.
struct Texture {
  std::string name;
  std::uint32_t width = 0, height = 0;  // 1 ... 16384
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  std::vector<std::uint8_t> rgba;  // width * height * 4
};

/// The unit's diffuse / specular / mirror / refraction model; weights are linear and not negative.
/// The texture multiplies `diffuse` and `transmission`, and with `tint` also `specular` and `mirror`.
struct Material {
  std::string name;
  Vec3 diffuse{0.8f, 0.8f, 0.8f};
  Vec3 specular;                    // Blinn-Phong weight
  std::uint32_t specular_log2 = 5;  // its exponent is 2^specular_log2; 0 ... 10
  Vec3 mirror;                      // weight of the reflection ray
  Vec3 transmission;                // weight of the refraction ray
  float ior = 1.5f;                 // of the inside against the outside; 0.25 ... 4
  Vec3 emission;
  std::int32_t texture = -1;  // index into Scene::textures, or -1
  bool tint = false;
};

/// Triangles of one class.  The vertex arrays have one length; `colors` is R, G, B, A linear codes
/// (255 = 1.0) packed little-endian, R in the low byte.
struct Mesh {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;  // not necessarily unit length; zero = use the triangle's own
  std::vector<Vec2> uvs;
  std::vector<std::uint32_t> colors;
  std::vector<std::uint32_t> indices;    // three a triangle
  std::vector<std::uint32_t> materials;  // one a triangle: index into Scene::materials

  std::size_t triangle_count() const { return materials.size(); }
};

/// A pixel's ray, with fx = x + 0.5 and fy = y + 0.5, x to the right and y down:
/// origin  (origin + origin_du * fx) + origin_dv * fy     (du and dv are zero in a perspective camera)
/// towards (corner + du * fx) + dv * fy                    (a direction, not a point; any length)
struct Camera {
  Vec3 origin, origin_du, origin_dv;
  Vec3 corner, du, dv;
};

enum class LightKind : std::uint8_t { point, directional, spot };

struct Light {
  LightKind kind = LightKind::point;
  Vec3 position;             // point, spot
  Vec3 direction{0, -1, 0};  // directional, spot: unit vector, from the light
  Vec3 color{1, 1, 1};       // point, spot: falls with 1/distance^2; directional: as it arrives
  float range = 1.0e15f;     // point, spot: no light beyond; > 0
  float cos_inner = 1.0f;    // spot: full inside, none outside; -1 <= outer < inner <= 1
  float cos_outer = 0.70710678f;
};

/// Frames are independent of each other: each carries all of its dynamic geometry.
struct Frame {
  std::uint32_t index = 0;  // in the animation, at Scene::fps
  double time = 0;          // seconds
  Camera camera;
  std::vector<Light> lights;   // 0 ... 64
  Vec3 ambient;                // multiplies the diffuse colour
  Vec3 sky_nadir, sky_zenith;  // a ray that misses gets a blend of these by its direction's y
  bool dynamic_moved = true;   // false: dynamic geometry equals the preceding frame's, its tree is kept
  Mesh dynamic;
};

/// What all frames of a trace share.  A primitive's global id is its index in `static_geometry`, or
/// static triangle count + its index in Frame::dynamic.
struct Scene {
  std::string name;
  std::string generator;                // program and source, for the reader
  std::uint32_t width = 0, height = 0;  // pixels, 1 ... 16384
  double fps = 30;
  std::uint32_t frame_count = 0;    // at least 1 in a trace
  std::vector<Material> materials;  // at least one if there is a triangle
  std::vector<Texture> textures;
  Mesh static_geometry;
};

}  // namespace artu::traces
