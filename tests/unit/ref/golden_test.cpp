// Whole frames, small enough to work out by hand.
#include "ref/golden.h"

#include <gtest/gtest.h>

#include <cstring>

#include "ref/color.h"
#include "unit/ref/meshes.h"

namespace artu::ref {
namespace {

using testing::add_floor;
using traces::Frame;
using traces::Material;
using traces::Scene;

float as_float(std::uint32_t bits) {
  float x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

Material black() {
  Material m;
  m.diffuse = {};
  return m;
}

Material emitter(float r, float g = 0, float b = 0) {
  Material m = black();
  m.emission = {r, g, b};
  return m;
}

/// One pixel, orthographic, looking down from (x, y, z).
struct Looking {
  Scene scene;
  Frame frame;
  Settings settings;

  explicit Looking(const Vec3& from = {0.25f, 5, 0.125f}) {
    scene.width = scene.height = 1;
    frame.camera.origin = from;
    frame.camera.corner = {0, -2, 0};
  }
  Result render() const { return Golden(scene, settings).render(frame); }
};

TEST(Golden, EmptySceneIsSky) {
  Looking l;
  l.frame.sky_nadir = {0.5f, 0, 0};
  l.frame.sky_zenith = {0, 1, 0};
  const Result r = l.render();
  ASSERT_EQ(r.pixels.size(), 1u);
  EXPECT_EQ(r.pixels[0].r, 188);  // straight down: the nadir
  EXPECT_EQ(r.pixels[0].g, 0);
  EXPECT_EQ(r.pixels[0].hit_class, HitClass::miss);
  EXPECT_EQ(r.pixels[0].primitive, -1);
  EXPECT_EQ(r.pixels[0].t_bits, 0u);
  EXPECT_EQ(r.rays.primary, 1u);
}

TEST(Golden, DeadRayIsCountedAndSeesTheHorizon) {
  Looking l;
  l.scene.materials = {emitter(1)};
  add_floor(l.scene.static_geometry, 0, 10);
  l.frame.camera.corner = {};
  l.frame.sky_nadir = {1, 0, 0};
  const Result r = l.render();
  EXPECT_EQ(r.pixels[0].hit_class, HitClass::miss);
  EXPECT_EQ(r.pixels[0].r, 188);  // (1 + 0) / 2
  EXPECT_EQ(r.rays.primary, 1u);
}

TEST(Golden, RecordsTheHit) {
  Looking l;
  l.scene.materials = {emitter(0.5f, 1, 2)};
  add_floor(l.scene.static_geometry, 1, 10);
  const Pixel p = l.render().pixels[0];
  EXPECT_EQ(p.hit_class, HitClass::static_geometry);
  EXPECT_EQ(as_float(p.t_bits), 4.0f);
  EXPECT_EQ(p.primitive, 1);  // x > z: the second of the square's triangles
  EXPECT_EQ(p.r, 188);
  EXPECT_EQ(p.g, 255);
  EXPECT_EQ(p.b, 255);
}

TEST(Golden, DynamicGeometryHasTheIdsAfterTheStatic) {
  Looking l;
  l.scene.materials = {emitter(0), emitter(1)};
  add_floor(l.scene.static_geometry, 1, 10);
  add_floor(l.frame.dynamic, 2, 10, 1);
  Pixel p = l.render().pixels[0];
  EXPECT_EQ(p.hit_class, HitClass::dynamic_geometry);
  EXPECT_EQ(p.primitive, 3);
  EXPECT_EQ(p.r, 255);
  l.frame.dynamic = {};
  add_floor(l.frame.dynamic, 1, 10, 1);  // coincident
  p = l.render().pixels[0];
  EXPECT_EQ(p.hit_class, HitClass::static_geometry);
  EXPECT_EQ(p.r, 0);
  l.scene.static_geometry = {};
  EXPECT_EQ(l.render().pixels[0].primitive, 1);
}

TEST(Golden, AmbientDiffuseTextureAndVertexColour) {
  Looking l;
  Material m;
  m.diffuse = {0.5f, 1, 1};
  m.texture = 0;
  l.scene.materials = {m};
  traces::Texture texture;
  texture.width = texture.height = 1;
  texture.rgba = {255, 255, 0, 0};
  l.scene.textures = {texture};
  add_floor(l.scene.static_geometry, 0, 10);
  for (auto& c : l.scene.static_geometry.colors) c = 0xffff00ffu;
  l.frame.ambient = {1, 1, 1};
  const Pixel p = l.render().pixels[0];
  EXPECT_EQ(p.r, 188);
  EXPECT_EQ(p.g, 0);  // the vertex colour has no green
  EXPECT_EQ(p.b, 0);  // the texture no blue
}

TEST(Golden, LightIsAddedUnlessInShadow) {
  Looking l;
  Material white;
  white.diffuse = {1, 1, 1};
  l.scene.materials = {white};
  add_floor(l.scene.static_geometry, 0, 10);
  traces::Light sun;
  sun.kind = traces::LightKind::directional;
  sun.color = {0.25f, 0.25f, 0.25f};
  traces::Light lamp;
  lamp.position = {0.25f, 4, 0.125f};
  lamp.color = {4, 0, 0};  // 4 / 16
  l.frame.lights = {sun, lamp};
  Result r = l.render();
  EXPECT_EQ(r.pixels[0].r, srgb().encode(0.5f));
  EXPECT_EQ(r.pixels[0].g, srgb().encode(0.25f));
  EXPECT_EQ(r.rays.shadow, 2u);
  // A roof between the lamp and the camera: out of the camera's sight if that is below, in the sun's way only.
  l.frame.camera.origin.y = 3;
  add_floor(l.frame.dynamic, 4.5f, 1);
  r = l.render();
  EXPECT_EQ(r.pixels[0].r, srgb().encode(0.25f));
  EXPECT_EQ(r.pixels[0].g, 0);
  EXPECT_EQ(r.rays.shadow, 2u);
  // And in the lamp's way too.
  l.frame.dynamic = {};
  add_floor(l.frame.dynamic, 3.5f, 1);
  r = l.render();
  EXPECT_EQ(r.pixels[0].r, 0);
  // From below no light reaches it: no shadow ray.
  l.frame.lights[0].direction = {0, 1, 0};
  l.frame.lights[1].position.y = -4;
  r = l.render();
  EXPECT_EQ(r.rays.shadow, 0u);
}

TEST(Golden, MirrorsStopAtTheDepth) {
  Looking l;
  Material mirror = black();
  mirror.mirror = {1, 1, 1};
  l.scene.materials = {mirror};
  add_floor(l.scene.static_geometry, 0, 10);
  add_floor(l.scene.static_geometry, 8, 10);
  for (const unsigned depth : {0u, 1u, 2u, 7u, 40u}) {
    l.settings.max_depth = depth;
    const Result r = l.render();
    EXPECT_EQ(r.rays.reflection, depth);
    EXPECT_EQ(r.rays.refraction, 0u);
  }
}

TEST(Golden, MirrorsStopAtTheWeight) {
  Looking l;
  Material mirror = black();
  mirror.mirror = {0.5f, 0.25f, 0};
  l.scene.materials = {mirror};
  add_floor(l.scene.static_geometry, 0, 10);
  add_floor(l.scene.static_geometry, 8, 10);
  l.settings.max_depth = 40;
  l.settings.min_weight = 0.125f;
  EXPECT_EQ(l.render().rays.reflection, 3u);  // 1/2, 1/4, 1/8
  l.settings.min_weight = 0;
  mirror.mirror = {};
  l.scene.materials = {mirror};
  EXPECT_EQ(l.render().rays.reflection, 0u);  // 0 >= 0, but not above 0
}

// Unphysical values that cancel make the order of the sum visible.  The glass bends nothing and reflects all: its
// reflection sees `up`, its refraction `down`; each may be transparent, with the sky behind it.
Pixel order(const Material& up, const Material& down, const Vec3& zenith, const Vec3& nadir) {
  Looking l;
  Material glass = black();
  glass.mirror = glass.transmission = {1, 1, 1};
  glass.ior = 1;
  l.scene.materials = {glass, up, down};
  add_floor(l.scene.static_geometry, 0, 10);
  add_floor(l.scene.static_geometry, 10, 10, 1);
  add_floor(l.scene.static_geometry, -10, 10, 2);
  l.frame.sky_zenith = zenith;
  l.frame.sky_nadir = nadir;
  const Result r = l.render();
  EXPECT_EQ(r.rays.reflection, 1u);
  EXPECT_EQ(r.rays.refraction, 2u);
  return r.pixels[0];
}

TEST(Golden, SumIsDepthFirstReflectionBeforeRefraction) {
  Material plus = emitter(1e8f), minus = emitter(-1e8f);
  Material clear_plus = plus, clear_minus = minus;
  clear_plus.transmission = clear_minus.transmission = {1, 1, 1};
  clear_plus.ior = clear_minus.ior = 1;
  const Vec3 half{0.5f, 0, 0};
  // ((0 + 1e8) + 0.5) - 1e8 = 0; breadth first it would be 0.5.
  EXPECT_EQ(order(clear_plus, minus, half, {}).r, 0);
  // ((0 + 1e8) - 1e8) + 0.5; the refraction first would give 0.
  EXPECT_EQ(order(plus, clear_minus, {}, half).r, 188);
}

TEST(Golden, GlassSphereIsCrossedOnce) {
  Looking l({0.01f, 5, 0.02f});
  Material glass = black();
  glass.transmission = {1, 1, 1};
  l.scene.materials = {glass};
  l.scene.static_geometry = testing::icosphere(3, 1, {0, 0, 0}, true);
  l.settings.max_depth = 2;
  l.settings.min_weight = 0.5f;  // the refraction only
  l.frame.sky_nadir = {1, 1, 1};
  l.frame.sky_zenith = {1, 1, 1};
  const Result r = l.render();
  EXPECT_EQ(r.rays.refraction, 2u);
  EXPECT_EQ(r.rays.reflection, 0u);
  EXPECT_EQ(r.pixels[0].r, srgb().encode(0.96f * 0.96f));
}

}  // namespace
}  // namespace artu::ref
