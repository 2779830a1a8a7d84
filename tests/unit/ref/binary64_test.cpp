// Pictures in binary64: watertight, right where the answer is known, and near the golden model.
#include "ref/binary64.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "ref/color.h"
#include "ref/embree_scene.h"
#include "ref/hit_point.h"
#include "traces/trace.h"
#include "unit/ref/traversal.h"

namespace artu::ref {
namespace {

using testing::Random;
using testing::vertex;
using Vector64 = Vector<double>;
using Hit64 = HitIn<double>;

Vector64 point64(Random& random, float half) { return Vector64(random.point(half)); }

Hit64 closest_of_all(const EmbreeSceneOf<Binary64Tests>& scene, const Binary64Ray& ray) {
  Hit64 best;
  TriangleHitIn<double> hit;
  for (std::size_t i = 0; i < scene.triangles().size(); ++i) {
    if (scene.tests().intersect(ray, scene.triangles()[i], hit)) improve(best, static_cast<std::int64_t>(i), hit);
  }
  return best;
}

/// A mesh in Embree, for rays from within `distance` of `center`.
struct Meshed {
  Meshed(const traces::Mesh& mesh, const Vec3& center, float distance) : scene(device) {
    scene.set(mesh, 0);
    Extent origins;
    for (const double side : {-1.0, 1.0}) {
      const double d = side * distance;
      origins.add({center.x + d, center.y + d, center.z + d});
    }
    scene.build(scene.tests().padding(scene.extent(), origins));
  }
  const EmbreeDevice device;
  EmbreeSceneOf<Binary64Tests> scene;
};

TEST(Binary64, EdgesHaveTheirSignWhereProductsCancel) {
  // The ray passes the edge from (0, 0) to (1 + 2^-20, 1 + 2^-21) by about 2^-51: the products agree in 52 bits.
  const Binary64Tests tests;
  const float x = 1 + 0x1p-20f, y = 1 + 0x1p-21f;
  const Triangle left{{0, 0, -1, x, y, -1, 0, 1, -1}}, right{{0, 0, -1, 1, 0, -1, x, y, -1}};
  for (const double off : {-0x1p-51, 0x1p-51}) {
    const Binary64Ray ray = tests.ray({0.5 * x, 0.5 * y + off, 0}, {0, 0, -1}, no_tmax);
    TriangleHitIn<double> hit;
    EXPECT_EQ(tests.intersect(ray, left, hit), off > 0);
    EXPECT_EQ(tests.intersect(ray, right, hit), off < 0);
  }
}

TEST(Binary64, ClosedMeshesLeakNoRay) {
  for (const Vec3& center : {Vec3{0, 0, 0}, Vec3{1e3f, -2e3f, 3e3f}, Vec3{1e5f, 1e5f, 1e5f}}) {
    const Meshed mesh(testing::icosphere(3, 1, center), center, 1);
    Random random(5);
    for (const Triangle& t : mesh.scene.triangles()) {
      const Vector64 origin = Vector64(center) + point64(random, 0.4f);
      const Vector64 a = vertex(t, 0), b = vertex(t, 1);
      for (const Vector64& goal : {a, (a + b) * 0.5, a + (b - a) * double(random.uniform(0, 1))}) {
        const Binary64Ray ray = mesh.scene.tests().ray(origin, unit(goal - origin), no_tmax);
        Hit64 hit;
        mesh.scene.closest(ray, hit);
        ASSERT_GE(hit.id, 0);
        ASSERT_TRUE(mesh.scene.occluded(ray));
      }
    }
  }
}

TEST(Binary64, EmbreeFindsWhatALoopFinds) {
  for (const Vec3& center : {Vec3{0, 0, 0}, Vec3{3e4f, -1e5f, 2e5f}}) {
    const Meshed mesh(testing::moved(testing::soup(3, 1), center), center, 3);
    Random random(7);
    int hits = 0;
    for (int i = 0; i < 3000; ++i) {
      const Vector64 goal = testing::target(mesh.scene.triangles(), random);
      const Vector64 origin = Vector64(center) + point64(random, 3);
      const bool shadow = i % 3 == 0;
      const Binary64Ray ray =
          mesh.scene.tests().ray(origin, shadow ? goal - origin : unit(goal - origin), shadow ? 1.0 : no_tmax);
      const Hit64 expected = closest_of_all(mesh.scene, ray);
      Hit64 found;
      mesh.scene.closest(ray, found);
      ASSERT_EQ(found.id, expected.id) << i;
      ASSERT_EQ(found.at.t, expected.at.t);
      ASSERT_EQ(mesh.scene.occluded(ray), expected.id >= 0);
      hits += expected.id >= 0;
    }
    EXPECT_GT(hits, 1000);
  }
}

// Section 11 with the rounding of binary64, for triangles that are no slivers.
TEST(Binary64, RaysLeaveTheirTriangle) {
  const Binary64Tests tests;
  Random random(9);
  int checked = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 center = random.point(testing::power_of_two(random, 0, 10));
    traces::Mesh mesh;
    const Vec3 a = center + random.point(1), b = center + random.point(1), c = center + random.point(1);
    testing::add_triangle(mesh, a, b, c);
    const Triangle t{{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z}};
    const Vector64 ab = b - a, ac = c - a;
    const Vector64 n{ab.y * ac.z - ab.z * ac.y, ab.z * ac.x - ab.x * ac.z, ab.x * ac.y - ab.y * ac.x};
    if (dot(n, n) < 0.01) continue;
    const Vector64 origin = Vector64(center) + point64(random, 4), goal = testing::target({t}, random);
    const Vector64 d = unit(goal - origin);
    TriangleHitIn<double> hit;
    if (!tests.intersect(tests.ray(origin, d, no_tmax), t, hit)) continue;
    const auto p = hit_point(mesh, 0, d, hit, tests.triangle_bits());
    const Vector64 along = unit(Vector64(testing::target({t}, random)) - p.outside + point64(random, 0x1p-6f));
    for (const double lift : {0.0, 0x1p-51, 0x1p-40, 0x1p-12, 0.1}) {
      for (const bool out : {true, false}) {
        const Vector64 normal = out ? p.ng : -p.ng;
        const Vector64 flat = unit((along - normal * dot(along, normal)) + normal * lift);
        if (!(dot(flat, normal) > 0)) continue;
        ASSERT_FALSE(tests.intersect(tests.ray(out ? p.outside : p.inside, flat, no_tmax), t, hit)) << i;
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 5000);
}

TEST(Binary64, TheTablesOfTheCurveAreNestedInThoseOfBinary32) {
  for (int code = 0; code < 256; ++code) {
    EXPECT_EQ(static_cast<float>(srgb<double>().linear[code]), srgb().linear[code]);
    EXPECT_LE(srgb<double>().threshold[code], srgb().threshold[code]);
    EXPECT_EQ(srgb<double>().encode(srgb<double>().linear[code]), code);
  }
}

/// One pixel, looking down from (0.25, 5, 0.125) on a floor at y = 1.
struct Looking {
  traces::Scene scene;
  traces::Frame frame;

  Looking() {
    scene.width = scene.height = 1;
    scene.materials.resize(1);
    scene.materials[0].diffuse = {};
    testing::add_floor(scene.static_geometry, 1, 10);
    frame.camera.origin = {0.25f, 5, 0.125f};
    frame.camera.corner = {0, -2, 0};
  }
  Pixel pixel() const { return Binary64(scene).render(frame).pixels[0]; }
};

TEST(Binary64, RecordsTheHit) {
  Looking l;
  l.scene.materials[0].emission = {0.5f, 1, 2};
  const Pixel p = l.pixel();
  EXPECT_EQ(p.hit_class, HitClass::static_geometry);
  EXPECT_EQ(p.primitive, 1);
  EXPECT_EQ(p.t_bits, 0x40800000u);  // 4
  EXPECT_EQ(p.r, 188);
  EXPECT_EQ(p.g, 255);
  EXPECT_EQ(p.b, 255);
}

TEST(Binary64, ALampLightsByItsDistanceAndAngle) {
  Looking l;
  l.scene.materials[0].diffuse = {0.9f, 0.5f, 0.1f};
  traces::Light lamp;
  lamp.position = {3.25f, 5, 0.125f};  // 4 above, 3 beside: cosine 0.8 at distance 5
  lamp.color = {20, 20, 20};
  l.frame.lights = {lamp};
  const Pixel p = l.pixel();
  const double arriving = 20 * 0.8 / 25;
  EXPECT_EQ(p.r, srgb<double>().encode(double(0.9f) * arriving));
  EXPECT_EQ(p.g, srgb<double>().encode(double(0.5f) * arriving));
  EXPECT_EQ(p.b, srgb<double>().encode(double(0.1f) * arriving));
  testing::add_triangle(l.frame.dynamic, {1.5f, 3, 0}, {2, 3, 0}, {1.75f, 3, 1});  // in the lamp's way
  EXPECT_EQ(l.pixel().r, 0);
  for (auto& v : l.frame.dynamic.positions) v.x += 0.5f;
  EXPECT_EQ(l.pixel().r, p.r);
}

TEST(Binary64, AMirrorSeesTheSkyAndGlassTheFloor) {
  Looking l;
  l.scene.materials[0].mirror = {0.5f, 0.5f, 0.5f};
  l.frame.sky_zenith = {0.36f, 0.36f, 0.36f};
  EXPECT_EQ(l.pixel().r, srgb<double>().encode(0.5 * double(0.36f)));
  l.scene.materials.resize(2);
  l.scene.materials[1].diffuse = {};
  l.scene.materials[1].transmission = {1, 1, 1};
  l.scene.materials[1].ior = 1.5f;
  l.scene.materials[0].mirror = {};
  l.scene.materials[0].emission = {0.5f, 0.5f, 0.5f};
  testing::add_floor(l.frame.dynamic, 2, 10, 1);
  const double r0 = 0.04;  // at right angles
  EXPECT_EQ(l.pixel().r, srgb<double>().encode((1 - r0) * 0.5 + r0 * double(0.36f)));
}

// Differences at edges apart, what binary32 rounds shows in no code or in the last.
TEST(Binary64, IsNearTheGoldenModel) {
  const std::filesystem::path samples = std::filesystem::path(ARTU_SOURCE_DIR) / "traces/samples";
  int compared = 0;
  for (const auto& entry : std::filesystem::directory_iterator(samples)) {
    const traces::Reader reader(entry.path().string());
    const traces::Frame frame = reader.frame(0);
    Settings settings;
    settings.selective = false;
    const Result a = Golden(reader.scene(), settings).render(frame), b = Binary64(reader.scene()).render(frame);
    ASSERT_EQ(a.pixels.size(), b.pixels.size());
    std::size_t equal = 0, near = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
      const Pixel &p = a.pixels[i], &q = b.pixels[i];
      const int d = std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
      equal += d == 0;
      near += d <= 1;
    }
    const auto all = static_cast<double>(a.pixels.size());
    EXPECT_GT(static_cast<double>(equal), 0.999 * all) << entry.path();
    EXPECT_EQ(near, a.pixels.size()) << entry.path();
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

}  // namespace
}  // namespace artu::ref
