// Embree must find the very hit that a loop over all triangles finds, on rays chosen to make it fail.
#include <gtest/gtest.h>

#include "ref/geometry.h"
#include "unit/ref/traversal.h"

namespace artu::ref {
namespace {

using testing::add_triangle;
using testing::expect_equal;
using testing::expect_watertight;
using testing::icosphere;
using testing::Mesh;
using testing::moved;
using testing::soup;

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

TEST(Watertight, Sphere) { expect_watertight({0, 0, 0}, 4); }
TEST(Watertight, SphereAtAThousand) { expect_watertight({1000, 1000, 1000}, 4); }

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
  EXPECT_GE(padding, 1024 * 0x1.1p-17);
  EXPECT_LE(padding, 1024 * 0x1.101p-17);
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
