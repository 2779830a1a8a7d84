// Embree against a loop over all triangles, and closed meshes, with tests of fewer bits.
#include <gtest/gtest.h>

#include "ref/tracer.h"
#include "unit/ref/traversal.h"

namespace artu::ref {
namespace {

using testing::icosphere;

class Narrow : public ::testing::TestWithParam<std::pair<int, int>> {
 protected:
  Precision precision() const { return {GetParam().first, GetParam().second, 23}; }
  const HitTests tests{precision()};
};

TEST_P(Narrow, EmbreeFindsTheClosest) {
  testing::expect_equal(icosphere(2, 1, {}), {}, 2, 1500, 101, tests);
  testing::expect_equal(icosphere(2, 1, {}), {}, 0.4f, 1500, 102, tests);
  testing::expect_equal(icosphere(2, 1, {}), {}, 1000, 1000, 103, tests);
  testing::expect_equal(icosphere(2, 1, {1000, -1000, 1000}), {1000, -1000, 1000}, 2, 1500, 104, tests);
  testing::expect_equal(testing::soup(105, 1), {}, 1, 1500, 105, tests);
  testing::expect_equal(testing::soup(106, 1e-6f), {}, 1e-6f, 1000, 106, tests);
  testing::expect_equal(testing::soup(107, 1e12f), {}, 1e12f, 1000, 107, tests);
}

TEST_P(Narrow, AClosedMeshIsWatertight) {
  testing::expect_watertight({0, 0, 0}, 3, tests);
  testing::expect_watertight({1000, 1000, 1000}, 2, tests);
}

TEST_P(Narrow, TracerTestsInTheFormats) {
  const traces::Mesh sphere = icosphere(2, 1, {}), other = icosphere(1, 0.5f, {0.75f, 0, 0});
  Extent origins;
  origins.add({-3, -3, -3});
  origins.add({3, 3, 3});
  const Tracer tracer(sphere, other, origins, precision());
  const EmbreeDevice device;
  EmbreeScene scene(device, tests);
  scene.set(sphere, 0);
  testing::Random random(7);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 origin = random.point(3), direction = unit(random.point(1) - origin);
    const TracedHit a = tracer.closest(origin, direction, no_tmax),
                    b = tracer.closest_of_all(origin, direction, no_tmax);
    ASSERT_EQ(a.primitive, b.primitive);
    ASSERT_EQ(a.t_bits, b.t_bits);
    ASSERT_EQ(tracer.occluded(origin, direction, 1.5f), tracer.occluded_by_any(origin, direction, 1.5f));
    if (a.primitive < 0 || a.primitive >= static_cast<std::int64_t>(sphere.triangle_count())) continue;
    ASSERT_EQ(testing::bits(testing::brute_force(scene.triangles(), tests.ray(origin, direction), tests).at.t),
              a.t_bits);
  }
}

// Box, triangle.
INSTANTIATE_TEST_SUITE_P(Widths, Narrow,
                         ::testing::Values(std::pair{7, 7}, std::pair{7, 23}, std::pair{23, 7}, std::pair{8, 12},
                                           std::pair{12, 8}, std::pair{10, 10}, std::pair{15, 16}, std::pair{22, 22},
                                           std::pair{23, 15}),
                         [](const auto& info) {
                           return std::to_string(info.param.first) + "_" + std::to_string(info.param.second);
                         });

TEST(NarrowTracer, RefusesOtherWidths) {
  const traces::Mesh mesh = icosphere(0, 1, {});
  EXPECT_THROW(Tracer(mesh, mesh, Extent{}, {23, 5, 23}), std::invalid_argument);
}

TEST(Padding, GrowsAsTheTestsNarrow) {
  Extent geometry, camera;
  geometry.add({0, 0, 0});
  geometry.add({1, 0, 0});
  camera.add({-1023, 0, 0});
  const double wide = required_padding(geometry, camera, {7, 23, 23});
  EXPECT_GE(wide, 1024 * (0x1p-5 + 0x1p-17));
  EXPECT_LE(wide, 1024.01 * (0x1p-5 + 0x1p-17));
  // Off the geometry by an eighth of its longest edge.
  EXPECT_GE(required_padding(geometry, camera, {23, 7, 23}), 1024.125 * (0x1p-5 + 0x1p-17));
}

}  // namespace
}  // namespace artu::ref
