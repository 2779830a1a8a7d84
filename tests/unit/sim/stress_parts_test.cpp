// Parts of the campaign: exact arithmetic, meshes, cases, rays.
#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "sim/stress/exact.h"
#include "sim/stress/rays.h"
#include "sim/stress/stress.h"
#include "sim/stress/subjects.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

hw::Ray ray_of(hw::Vector origin, hw::Vector direction) {
  hw::Ray ray;
  ray.origin = origin;
  ray.direction = direction;
  hw::set_up(ray);
  return ray;
}

TEST(StressExact, KnowsAnEasyHit) {
  const Corners triangle{hw::Vector{0, 0, 2}, hw::Vector{4, 0, 2}, hw::Vector{0, 4, 2}};
  hw::TriangleHit hit{4, 0.5f, 0.25f, 1};
  const Exact exact = exact_test(ray_of({1, 1, 0}, {0, 0, 0.5f}), triangle, &hit);
  EXPECT_FALSE(exact.parallel);
  EXPECT_EQ(exact.a, 0.5);
  EXPECT_EQ(exact.b, 0.25);
  EXPECT_EQ(exact.c, 0.25);
  EXPECT_EQ(exact.t, 4);
  EXPECT_EQ(exact.t_ulps, 0);
  EXPECT_EQ(exact.u_error, 0);
  hit.t = std::nextafter(4.0f, 5.0f);
  hit.U = 0.5f + 0x1p-24f;
  const Exact off = exact_test(ray_of({1, 1, 0}, {0, 0, 0.5f}), triangle, &hit);
  EXPECT_EQ(off.t_ulps, 1);
  EXPECT_EQ(off.u_error, 1);
}

TEST(StressExact, KnowsMissesAndParallels) {
  const Corners triangle{hw::Vector{0, 0, 2}, hw::Vector{4, 0, 2}, hw::Vector{0, 4, 2}};
  EXPECT_EQ(exact_test(ray_of({-1, 1, 0}, {0, 0, 1}), triangle, nullptr).b, -0.25);
  EXPECT_TRUE(exact_test(ray_of({1, 1, 0}, {1, 0, 0}), triangle, nullptr).parallel);
  EXPECT_EQ(exact_test(ray_of({1, 1, 3}, {0, 0, 1}), triangle, nullptr).t, -1);
}

TEST(StressExact, SpansAllExponents) {
  const float tiny = 0x1p-149f, huge = 0x1p61f;
  const Corners triangle{hw::Vector{-huge, -huge, 1}, hw::Vector{huge, -huge, 1}, hw::Vector{0, huge, 1}};
  const Exact exact = exact_test(ray_of({tiny, 0, 0}, {tiny, 0, 1}), triangle, nullptr);
  EXPECT_FALSE(exact.parallel);
  EXPECT_EQ(exact.t, 1);
  EXPECT_EQ(exact.c, 0.5);
}

TEST(StressMeshes, AreWhatTheySay) {
  EXPECT_TRUE(is_closed(make_mesh("sphere", 1, false)));
  EXPECT_TRUE(is_closed(make_mesh("box", 1, false)));
  EXPECT_FALSE(is_closed(make_mesh("height", 1, false)));
  EXPECT_EQ(make_mesh("sphere", 1, false).triangle_count(), 20480u);
  EXPECT_EQ(make_mesh("box", 1, false).triangle_count(), 3072u);
  EXPECT_EQ(make_mesh("height", 1, false).triangle_count(), 8192u);
  EXPECT_EQ(make_mesh("empty", 1, false).triangle_count(), 0u);
  EXPECT_EQ(make_mesh("identical", 1, true).triangle_count(), 1000000u);
  EXPECT_GT(make_mesh("coincident", 1, false).dynamic.triangle_count(), 300u);
  for (const char* closed : {"sphere", "box"}) {
    const auto triangles = corners_of(make_mesh(closed, 1, false));
    EXPECT_NEAR(winding_number(triangles, {0.1f, 0.2f, 0.1f}), 1, 1e-6) << closed;
    EXPECT_NEAR(winding_number(triangles, {3, 0.2f, 0.1f}), 0, 1e-6) << closed;
  }
}

TEST(StressCases, AreFoundByName) {
  EXPECT_EQ(stress_cases("").size(), mesh_entries().size() * placements().size());
  EXPECT_EQ(stress_cases("sphere").size(), placements().size());
  ASSERT_EQ(stress_cases("sphere/moved-1e5").size(), 1u);
  EXPECT_EQ(stress_cases("sphere/moved-1e5")[0].placement.offset, 1e5f);
  try {
    stress_cases("spere/moved-1e5");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("did you mean sphere/moved-1e5?"));
  }
  try {
    stress_cases("foo");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "--only: unknown case \"foo\"; one that artu stress --list prints would be right");
  }
}

TEST(StressRays, AreOfAllKindsAndInTheirBox) {
  const StressGeometry geometry = make_mesh("box", 1, false);
  const auto triangles = corners_of(geometry);
  const RaySource source(geometry, triangles, 3);
  std::set<RayKind> kinds;
  int inside = 0, zeros = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const StressRay ray = source.ray(i);
    kinds.insert(ray.kind);
    inside += ray.must_hit ? 1 : 0;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(std::fabs(ray.ray.origin[axis] - source.origins().center[axis]), source.origins().half);
      zeros += ray.ray.direction[axis] == 0 ? 1 : 0;
    }
    EXPECT_FALSE(hw::is_zero(ray.ray.direction));
  }
  EXPECT_EQ(kinds.size(), ray_kinds);
  EXPECT_EQ(inside, 200);
  EXPECT_GT(zeros, 300);
}

TEST(StressRays, DoNotDependOnThoseBefore) {
  const StressGeometry geometry = make_mesh("soup", 1, false);
  const auto triangles = corners_of(geometry);
  const RaySource a(geometry, triangles, 3), b(geometry, triangles, 3), other(geometry, triangles, 4);
  a.ray(0);
  EXPECT_EQ(hw::bits_of(a.ray(77).ray.direction.x), hw::bits_of(b.ray(77).ray.direction.x));
  EXPECT_NE(hw::bits_of(a.ray(77).ray.direction.x), hw::bits_of(other.ray(77).ray.direction.x));
}

/// The golden model's tracer by itself.
TEST(StressTracer, AnswersSingleRays) {
  StressGeometry geometry;
  add_triangle(geometry.fixed, {-1, -1, 2}, {1, -1, 2}, {0, 1, 2});
  add_triangle(geometry.dynamic, {-1, -1, 1}, {1, -1, 1}, {0, 1, 1});
  ref::Extent origins;
  origins.add({0, 0, 0});
  const ref::Tracer tracer(geometry.fixed, geometry.dynamic, origins);
  const ref::TracedHit hit = tracer.closest({0, 0, 0}, {0, 0, 1}, 10);
  EXPECT_TRUE(hit.hit);
  EXPECT_EQ(hit.primitive, 1);
  EXPECT_EQ(hit.t_bits, hw::bits_of(1.0f));
  EXPECT_EQ(tracer.closest_of_all({0, 0, 0}, {0, 0, 1}, 10).primitive, 1);
  EXPECT_TRUE(tracer.occluded({0, 0, 0}, {0, 0, 1}, 1));
  EXPECT_FALSE(tracer.occluded({0, 0, 0}, {0, 0, 1}, 0.5f));
  EXPECT_FALSE(tracer.occluded_by_any({0, 0, 0}, {0, 0, -1}, 10));
  EXPECT_FALSE(tracer.closest({0, 0, 0}, {0, 0, 0}, 10).hit);
}

}  // namespace
}  // namespace artu::sim
