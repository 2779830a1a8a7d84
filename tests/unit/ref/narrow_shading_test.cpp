// Shading in numbers of fewer bits, and of 23 bits by way of binary64 against binary32.
#include <gtest/gtest.h>

#include <cstdlib>

#include "ref/lights.h"
#include "ref/renderer.h"
#include "ref/scatter.h"
#include "ref/texture.h"
#include "unit/ref/traversal.h"

namespace artu::ref {
namespace {

using testing::bits;
using testing::Random;
using Wide = Number<23>;

Vec3 color(Random& random) {
  if (random.below(8) == 0) return {};
  return random.point(random.below(4) == 0 ? 1e-3f : 0.5f) + Vec3{0.5f, 0.5f, 0.5f};
}

bool equal(float a, float b) { return a != a ? b != b : bits(a) == bits(b); }
bool equal(const Vec3& a, const Vec3& b) { return equal(a.x, b.x) && equal(a.y, b.y) && equal(a.z, b.z); }
template <class N>
bool equal(const Triple<float>& a, const Triple<N>& b) {
  return equal(static_cast<Vec3>(a), static_cast<Vec3>(b));
}

traces::Texture noise(Random& random) {
  traces::Texture texture;
  texture.width = 5;
  texture.height = 3;
  texture.wrap_v = traces::Wrap::mirror;
  texture.rgba.resize(60);
  for (auto& code : texture.rgba) code = static_cast<std::uint8_t>(random.below(256));
  return texture;
}

TEST(Formats, TexturesAt23BitsAreBinary32) {
  Random random(71);
  const traces::Texture texture = noise(random);
  for (int i = 0; i < 100000; ++i) {
    const Vec2 uv{random.uniform(-3, 3), random.uniform(-3, 3)};
    ASSERT_TRUE(equal(sample<float>(texture, uv), sample<Wide>(texture, uv)));
  }
}

traces::Light random_light(Random& random) {
  traces::Light light;
  light.kind = static_cast<traces::LightKind>(random.below(3));
  light.position = random.point(random.below(3) == 0 ? 1e4f : 4);
  light.direction = unit(random.point(1));
  light.color = color(random) * random.uniform(0, 20);
  light.cos_outer = random.uniform(-0.5f, 0.5f);
  light.cos_inner = light.cos_outer + random.uniform(0, 0.5f);
  return light;
}

template <class N>
void expect_same_light(const traces::Light& light, const HitPoint& point, const Vec3& direction,
                       const traces::Material& material, const Vec3& tex, const Vec3& weight) {
  LightSample<float> a;
  LightSample<N> b;
  const bool arrives = sample_light(light, point.outside, a);
  ASSERT_EQ(sample_light(light, point.outside, b), arrives);
  if (!arrives) return;
  ASSERT_TRUE(equal(a.towards, b.towards) && equal(a.intensity, b.intensity) && equal(a.shadow, b.shadow));
  const Surface<float> s = surface_of<float>(material, tex);
  const Surface<N> t = surface_of<N>(material, tex);
  ASSERT_TRUE(equal(s.kd, t.kd) && equal(s.kt, t.kt) && equal(s.ks, t.ks) && equal(s.kr, t.kr));
  Triple<float> c;
  Triple<N> e;
  ASSERT_EQ(contribution<float>(a, point, direction, s, material.specular_log2, weight, c),
            contribution<N>(b, point, direction, t, material.specular_log2, weight, e));
  ASSERT_TRUE(equal(c, e));
  const Scatter<float> x = scatter(point, direction, s.kr, s.kt, material.ior);
  const Scatter<N> y = scatter(point, direction, t.kr, t.kt, material.ior);
  ASSERT_TRUE(equal(x.reflection, y.reflection) && equal(x.refraction, y.refraction) &&
              equal(x.refracted, y.refracted));
}

TEST(Formats, LightsAndScatteringAt23BitsAreBinary32) {
  Random random(72);
  for (int i = 0; i < 100000; ++i) {
    HitPoint point{};
    point.ng = unit(random.point(1));
    point.ns = unit(point.ng + random.point(0.3f));
    point.front = random.below(2) == 0;
    point.outside = random.point(2);
    traces::Material material;
    material.diffuse = color(random);
    material.specular = color(random);
    material.mirror = color(random);
    material.transmission = color(random);
    material.specular_log2 = static_cast<std::uint32_t>(random.below(11));  // up to the 1024th power: it underflows
    material.ior = random.uniform(0.25f, 4);
    material.tint = random.below(2) == 0;
    Vec3 direction = unit(random.point(1));
    if (dot(direction, point.ng) > 0) direction = -direction;
    expect_same_light<Wide>(random_light(random), point, direction, material, color(random), color(random));
    ASSERT_FALSE(::testing::Test::HasFatalFailure());
  }
}

/// A textured floor, glass and mirror spheres, all kinds of lights.
struct Room {
  traces::Scene scene;
  traces::Frame frame;
  Settings settings;

  Room() {
    Random random(73);
    scene.width = 48;
    scene.height = 36;
    scene.textures = {noise(random)};
    scene.materials.resize(3);
    scene.materials[0].texture = 0;
    scene.materials[0].mirror = {0.25f, 0.25f, 0.25f};
    scene.materials[1].transmission = {0.75f, 0.875f, 1};
    scene.materials[1].specular = {0.5f, 0.5f, 0.5f};
    scene.materials[2].mirror = {0.5f, 0.75f, 0.5f};
    testing::add_floor(scene.static_geometry, -1, 8);
    for (std::size_t i = 0; i < scene.static_geometry.uvs.size(); ++i) {
      scene.static_geometry.uvs[i] = {scene.static_geometry.positions[i].x, scene.static_geometry.positions[i].z};
    }
    frame.dynamic = testing::icosphere(2, 1, {-0.5f, 0, 0}, true);
    frame.dynamic.materials.assign(frame.dynamic.triangle_count(), 1);
    for (std::size_t i = 0; i < frame.dynamic.triangle_count() / 4; ++i) frame.dynamic.materials[i] = 2;
    frame.camera.origin = {0, 0.5f, 4};
    frame.camera.corner = {-24, 16, -48};
    frame.camera.du = {1, 0, 0};
    frame.camera.dv = {0, -1, 0};
    for (int i = 0; i < 6; ++i) frame.lights.push_back(random_light(random));
    frame.lights[0].position = {2, 5, 3};
    frame.ambient = {0.1f, 0.1f, 0.1f};
    frame.sky_nadir = {0.1f, 0.1f, 0.1f};
    frame.sky_zenith = {0.3f, 0.5f, 0.9f};
    settings.selective = false;
  }
  Result golden(const Precision& precision) const {
    Settings s = settings;
    s.precision = precision;
    return Golden(scene, s).render(frame);
  }
};

TEST(Formats, FramesAt23BitsAreBinary32) {
  const Room room;
  const EmbreeDevice device;
  const HitTests emulated({}, true);
  EmbreeScene fixed(device, emulated), dynamic(device, emulated);
  fixed.set(room.scene.static_geometry, 0);
  dynamic.set(room.frame.dynamic, 2);
  for (EmbreeScene* scene : {&fixed, &dynamic}) scene->build(1e-3);
  const Geometry geometry{fixed, dynamic};
  const auto renderer = Renderer::make(room.scene, room.frame, room.settings, geometry, true);
  const Result expected = room.golden({});
  for (std::uint32_t i = 0; i < expected.pixels.size(); ++i) {
    Pixel pixel;
    renderer->trace(i % room.scene.width, i / room.scene.width, pixel);
    const Pixel& e = expected.pixels[i];
    ASSERT_EQ(pixel.t_bits, e.t_bits);
    ASSERT_EQ(pixel.primitive, e.primitive);
    ASSERT_TRUE(pixel.r == e.r && pixel.g == e.g && pixel.b == e.b) << i;
  }
  EXPECT_EQ(renderer->rays().shadow, expected.rays.shadow);
  EXPECT_EQ(renderer->rays().reflection, expected.rays.reflection);
  EXPECT_EQ(renderer->rays().refraction, expected.rays.refraction);
  EXPECT_GT(expected.rays.refraction, 500u);
}

int largest_difference(const Result& a, const Result& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const Pixel &p = a.pixels[i], &q = b.pixels[i];
    for (const int d : {p.r - q.r, p.g - q.g, p.b - q.b}) largest = std::abs(d) > largest ? std::abs(d) : largest;
  }
  return largest;
}

TEST(Golden, NarrowShadingChangesColoursOnly) {
  const Room room;
  const Result exact = room.golden({});
  for (const int m : {7, 12, 16, 22}) {
    const Result narrow = room.golden({23, 23, m});
    for (std::size_t i = 0; i < exact.pixels.size(); ++i) {
      ASSERT_EQ(narrow.pixels[i].t_bits, exact.pixels[i].t_bits);
      ASSERT_EQ(narrow.pixels[i].primitive, exact.pixels[i].primitive);
    }
    const int difference = largest_difference(exact, narrow);
    EXPECT_TRUE(difference > 0 || m > 12) << m;
    EXPECT_LE(difference, m == 7 ? 16 : 1) << m;
  }
}

TEST(Golden, AllWidthsRenderTheRoom) {
  const Room room;
  const Result exact = room.golden({});
  for (int m = narrowest; m <= widest; ++m) {
    const Result narrow = room.golden({m, m, m});
    int other = 0;
    for (std::size_t i = 0; i < exact.pixels.size(); ++i)
      other += exact.pixels[i].hit_class != narrow.pixels[i].hit_class;
    EXPECT_LT(other, m < 10 ? 40 : 10) << m;  // along outlines
  }
}

TEST(Golden, RefusesOtherWidths) {
  Room room;
  EXPECT_THROW(room.golden({23, 23, 6}), std::invalid_argument);
  EXPECT_THROW(room.golden({24, 23, 23}), std::invalid_argument);
}

}  // namespace
}  // namespace artu::ref
