// Embree must find the very hit that a loop over all triangles finds, on rays chosen to make it fail.
#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "ref/embree_scene.h"
#include "ref/geometry.h"
#include "unit/ref/meshes.h"

namespace artu::ref {
namespace {

using testing::add_triangle;
using testing::brute_force;
using testing::icosphere;
using testing::Mesh;
using testing::Random;
using testing::vertex;

std::uint32_t bits(float x) {
  std::uint32_t b;
  std::memcpy(&b, &x, sizeof b);
  return b;
}

// On a vertex, an edge or inside of a random triangle.
Vec3 target(const std::vector<Triangle>& triangles, Random& random) {
  const Triangle& t = triangles[random.below(triangles.size())];
  const Vec3 a = vertex(t, 0), b = vertex(t, 1), c = vertex(t, 2);
  switch (random.below(4)) {
    case 0:
      return a;
    case 1:
      return (a + b) * 0.5f;
    case 2:
      return a + (c - a) * random.uniform(0, 1);
    default:
      return a * 0.5f + (b * 0.25f + c * 0.25f);
  }
}

Vec3 random_direction(Random& random) {
  const float tiny[] = {0, -0.0f, 1e-20f, -1e-30f, 1e-35f, -1e-19f, 1e-6f};
  Vec3 d = random.point(1);
  switch (random.below(4)) {
    case 0:
      d = Vec3{};
      (random.below(3) == 0 ? d.x : random.below(2) == 0 ? d.y : d.z) = random.below(2) == 0 ? 1.0f : -1.0f;
      if (d.x == 0) d.x = tiny[random.below(7)];
      if (d.y == 0) d.y = tiny[random.below(7)];
      return d;
    case 1:
      d.x = tiny[random.below(7)];
      break;
    case 2:
      d.y = tiny[random.below(7)];
      break;
    default:
      break;
  }
  return unit(d);
}

// Rays of a group share the distance that the padding is computed from.
std::vector<Ray> adversarial_rays(const std::vector<Triangle>& triangles, const Vec3& center, float distance, int count,
                                  unsigned seed) {
  Random random(seed);
  std::vector<Ray> rays;
  while (static_cast<int>(rays.size()) < count) {
    const Vec3 goal = target(triangles, random);
    Vec3 origin = center + random.point(distance);
    switch (random.below(5)) {
      case 0: {  // parallel to the axes, through the goal
        const Vec3 d = random_direction(random);
        rays.push_back(make_ray(goal - d * random.uniform(0, distance), d));
        break;
      }
      case 1:  // from the surface itself
        rays.push_back(make_ray(goal, random_direction(random)));
        break;
      case 2:  // a shadow ray, not unit length, that ends on the surface
        if (!is_dead(goal - origin)) rays.push_back(make_ray(origin, goal - origin, 1.0f));
        break;
      case 3:  // along a line of vertices
        origin = target(triangles, random);
        if (!is_dead(unit(goal - origin))) rays.push_back(make_ray(origin, unit(goal - origin)));
        break;
      default:
        if (!is_dead(unit(goal - origin))) rays.push_back(make_ray(origin, unit(goal - origin)));
    }
  }
  return rays;
}

double padding_of(const EmbreeScene& scene, const std::vector<Ray>& rays) {
  Extent origins;
  for (const Ray& ray : rays) origins.add({ray.origin.x, ray.origin.y, ray.origin.z});
  return required_padding(scene.extent(), origins);
}

void expect_equal(const Mesh& mesh, const Vec3& center, float distance, int count, unsigned seed) {
  const EmbreeDevice device;
  EmbreeScene scene(device);
  scene.set(mesh, 0);
  const std::vector<Ray> rays = adversarial_rays(scene.triangles(), center, distance, count, seed);
  scene.build(padding_of(scene, rays));
  int hits = 0;
  for (const Ray& ray : rays) {
    const Hit expected = brute_force(scene.triangles(), ray);
    Hit found;
    scene.closest(ray, found);
    SCOPED_TRACE("origin " + std::to_string(ray.origin.x) + " direction " + std::to_string(ray.direction.x) + " " +
                 std::to_string(ray.direction.y) + " " + std::to_string(ray.direction.z));
    ASSERT_EQ(found.id, expected.id) << found.at.t << " " << expected.at.t << " tmax " << ray.tmax;
    ASSERT_EQ(bits(found.at.t), bits(expected.at.t));
    ASSERT_EQ(bits(found.at.u), bits(expected.at.u));
    ASSERT_EQ(scene.occluded(ray), expected.id >= 0);
    hits += expected.id >= 0;
  }
  EXPECT_GT(hits, count / 4);  // the rays do test something
}

Mesh soup(unsigned seed, float scale) {
  Random random(seed);
  Mesh mesh;
  for (int i = 0; i < 700; ++i) {
    const Vec3 a = random.point(scale), b = a + random.point(0.2f * scale), c = a + random.point(0.2f * scale);
    add_triangle(mesh, a, b, c);
    if (i % 3 == 0) add_triangle(mesh, b, c, a);                              // coincident: a tie, or nearly
    if (i % 3 == 1) add_triangle(mesh, a, b, c);                              // the very same: always a tie
    if (i % 5 == 0) add_triangle(mesh, a, b, a + (b - a) * 0.5f);             // degenerate or a sliver
    if (i % 7 == 0) add_triangle(mesh, a, {b.x, a.y, b.z}, {c.x, a.y, c.z});  // flat box
  }
  return mesh;
}

Mesh moved(Mesh mesh, const Vec3& offset) {
  for (Vec3& p : mesh.positions) p = p + offset;
  return mesh;
}

TEST(Traversal, SphereNear) { expect_equal(icosphere(3, 1, {}), {}, 2, 4000, 1); }
TEST(Traversal, SphereFromInside) { expect_equal(icosphere(3, 1, {}), {}, 0.4f, 4000, 2); }
TEST(Traversal, SphereFarAway) { expect_equal(icosphere(3, 1, {}), {}, 1000, 4000, 3); }
TEST(Traversal, SphereAtAThousand) {
  expect_equal(icosphere(3, 1, {1000, -1000, 1000}), {1000, -1000, 1000}, 2, 4000, 4);
}
TEST(Traversal, SphereAtAHundredThousand) {
  expect_equal(icosphere(3, 1, {1e5f, 1e5f, -1e5f}), {1e5f, 1e5f, -1e5f}, 2, 4000, 5);
}
TEST(Traversal, Soup) { expect_equal(soup(11, 1), {}, 1, 6000, 6); }
TEST(Traversal, SoupMoved) { expect_equal(moved(soup(12, 1), {1000, 1000, 1000}), {1000, 1000, 1000}, 1, 6000, 7); }
TEST(Traversal, SoupTiny) { expect_equal(soup(13, 1e-6f), {}, 1e-6f, 4000, 8); }
TEST(Traversal, SoupHuge) { expect_equal(soup(14, 1e12f), {}, 1e12f, 4000, 9); }

// Over 1.844e18 Embree drops primitives without a word.
TEST(Traversal, BeyondEmbreesCoordinates) {
  Mesh mesh;
  const float far = 0x1.8p61f;  // 3.5e18
  add_triangle(mesh, {-far, -far, far}, {far, -far, far}, {0, far, far});
  add_triangle(mesh, {-1, -1, 2}, {1, -1, 2}, {0, 1, 2});
  const EmbreeDevice device;
  EmbreeScene scene(device);
  scene.set(mesh, 10);
  scene.build(1e14);
  Hit hit;
  scene.closest(make_ray({0, 0, 0}, {0, 0, 1}), hit);
  EXPECT_EQ(hit.id, 11);
  hit = {};
  scene.closest(make_ray({0, 0, 3}, {0, 0, 1}), hit);
  EXPECT_EQ(hit.id, 10);
  EXPECT_TRUE(scene.occluded(make_ray({0, 0, 3}, {0, 0, 1})));
  EXPECT_FALSE(scene.occluded(make_ray({0, 0, 3}, {0, 0, -1}, 0.5f)));
}

TEST(Traversal, TreeBuildLeavesSubnormalsOn) {
  const EmbreeDevice device;
  EmbreeScene scene(device);
  scene.set(icosphere(2, 1, {}), 0);
  scene.build(1e-5);
  Hit hit;
  scene.closest(make_ray({0, 0, 0}, {0, 0, 1}), hit);
  volatile float tiny = 0x1p-126f;
  tiny = tiny * 0.25f;
  EXPECT_EQ(tiny, 0x1p-128f);
}

TEST(Traversal, ClosestOverBothClassesPrefersTheStaticOnATie) {
  Mesh mesh;
  add_triangle(mesh, {-1, -1, 2}, {1, -1, 2}, {0, 1, 2});
  const EmbreeDevice device;
  EmbreeScene fixed(device), dynamic(device), none(device), nearer(device);
  fixed.set(mesh, 0);
  dynamic.set(mesh, 1);
  nearer.set(moved(mesh, {0, 0, -0x1p-20f}), 1);
  none.set(Mesh{}, 0);
  for (EmbreeScene* scene : {&fixed, &dynamic, &none, &nearer}) scene->build(1e-4);
  const Ray ray = make_ray({0, 0, 0}, {0, 0, 1});
  EXPECT_EQ((Geometry{fixed, dynamic}.closest(ray).id), 0);
  EXPECT_EQ((Geometry{fixed, nearer}.closest(ray).id), 1);
  EXPECT_EQ((Geometry{none, dynamic}.closest(ray).id), 1);
  EXPECT_EQ((Geometry{none, none}.closest(ray).id), -1);
  EXPECT_FALSE((Geometry{none, none}.occluded(ray)));
  EXPECT_TRUE((Geometry{none, dynamic}.occluded(ray)));
}

// No ray may leave a closed mesh, however it is aimed at the edges and vertices that triangles share.
void expect_watertight(const Vec3& center) {
  const EmbreeDevice device;
  EmbreeScene scene(device);
  scene.set(icosphere(4, 1, center), 0);
  Random random(21);
  std::vector<Ray> rays;
  for (const Triangle& t : scene.triangles()) {
    const Vec3 origin = center + random.point(0.5f);
    const Vec3 a = vertex(t, 0), b = vertex(t, 1);
    for (const Vec3& goal : {a, (a + b) * 0.5f, a + (b - a) * random.uniform(0, 1)}) {
      rays.push_back(make_ray(origin, unit(goal - origin)));
    }
    // Parallel to an axis and exactly through a vertex or an edge.
    rays.push_back(make_ray({a.x, a.y, center.z}, {0, 0, a.z < center.z ? -1.0f : 1.0f}));
    rays.push_back(make_ray({a.x, center.y, a.z}, {-0.0f, a.y < center.y ? -1.0f : 1.0f, -0.0f}));
  }
  scene.build(padding_of(scene, rays));
  for (const Ray& ray : rays) {
    // Rays on the silhouette graze the sphere and may miss; all others begin inside.
    const Vec3 r = ray.origin - center;
    if (dot(r, r) > 0.98f) continue;
    Hit hit;
    scene.closest(ray, hit);
    ASSERT_GE(hit.id, 0);
    ASSERT_TRUE(scene.occluded(ray));
  }
}

TEST(Watertight, Sphere) { expect_watertight({0, 0, 0}); }
TEST(Watertight, SphereAtAThousand) { expect_watertight({1000, 1000, 1000}); }

TEST(Watertight, GridThroughItsVertices) {
  Mesh mesh;
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      const float fx = static_cast<float>(x) * 0.1f, fy = static_cast<float>(y) * 0.3f;
      const float gx = static_cast<float>(x + 1) * 0.1f, gy = static_cast<float>(y + 1) * 0.3f;
      add_triangle(mesh, {fx, fy, 1}, {gx, fy, 1}, {gx, gy, 1});
      add_triangle(mesh, {fx, fy, 1}, {gx, gy, 1}, {fx, gy, 1});
    }
  }
  const EmbreeDevice device;
  EmbreeScene scene(device);
  scene.set(mesh, 0);
  scene.build(1e-4);
  for (int y = 1; y < 16; ++y) {
    for (int x = 1; x < 16; ++x) {
      for (const float zero : {0.0f, -0.0f}) {
        Hit hit;
        scene.closest(make_ray({static_cast<float>(x) * 0.1f, static_cast<float>(y) * 0.3f, 0}, {zero, zero, 1}), hit);
        ASSERT_GE(hit.id, 0) << x << " " << y;
        ASSERT_EQ(hit.at.t, 1.0f);
      }
    }
  }
}

TEST(Padding, IsTheDistanceOfTheFarthestOriginFromTheFarthestCorner) {
  Extent geometry, camera;
  geometry.add({0, 0, 0});
  geometry.add({1, 0, 0});
  camera.add({-1023, 0, 0});
  const double padding = required_padding(geometry, camera);
  EXPECT_GE(padding, 1024 * 0x1p-17);
  EXPECT_LE(padding, 1024 * 0x1.01p-17);
  EXPECT_EQ(required_padding(Extent{}, camera), 0);
  Extent point;
  point.add({0, 0, 0});
  EXPECT_EQ(required_padding(point, point), 0x1p-58);
}

TEST(Padding, SeesEveryPixelOfAnOrthographicCamera) {
  traces::Camera camera;
  camera.origin = {1, 0, 0};
  camera.origin_du = {2, 0, 0};
  camera.origin_dv = {0, -3, 0};
  const Extent extent = camera_extent(camera, 10, 20);
  EXPECT_EQ(extent.lo[0], 2);
  EXPECT_EQ(extent.hi[0], 20);
  EXPECT_EQ(extent.lo[1], -58.5);
  EXPECT_EQ(extent.hi[1], -1.5);
}

}  // namespace
}  // namespace artu::ref
