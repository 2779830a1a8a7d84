#include "ref/triangle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/ref/meshes.h"

namespace artu::ref {
namespace {

const HitTests native;

bool intersect(const Ray& ray, const Triangle& triangle, TriangleHit& hit) {
  return native.intersect(ray, triangle, hit);
}
Interval box_interval(const Ray& ray, const Box& box) { return native.interval(ray, box); }
bool meets(const Ray& ray, const Box& box) { return meets(native.interval(ray, box), ray.tmax); }

const Triangle floor_triangle{{0, 0, 5, 4, 0, 5, 0, 4, 5}};  // at z = 5

bool hits(const Vec3& origin, const Vec3& direction, float tmax = no_tmax) {
  TriangleHit hit;
  return intersect(make_ray(origin, direction, tmax), floor_triangle, hit);
}

TEST(Triangle, InteriorHitHasExactValues) {
  TriangleHit hit;
  ASSERT_TRUE(intersect(make_ray({1, 1, 1}, {0, 0, 1}), floor_triangle, hit));
  EXPECT_EQ(hit.t, 4.0f);
  // Twice the areas against A, B, C: PBC = 8, PCA = 4, PAB = 4; the sign is that of the winding seen along z.
  EXPECT_EQ(std::fabs(hit.u), 8.0f);
  EXPECT_EQ(std::fabs(hit.v), 4.0f);
  EXPECT_EQ(std::fabs(hit.det), 16.0f);
  EXPECT_EQ(hit.u / hit.det, 0.5f);
}

TEST(Triangle, BothSidesCount) {
  EXPECT_TRUE(hits({1, 1, 1}, {0, 0, 1}));
  EXPECT_TRUE(hits({1, 1, 9}, {0, 0, -1}));
  EXPECT_FALSE(hits({1, 1, 9}, {0, 0, 1}));  // behind
  EXPECT_FALSE(hits({3, 3, 1}, {0, 0, 1}));
}

TEST(Triangle, TmaxIsInclusive) {
  EXPECT_TRUE(hits({1, 1, 1}, {0, 0, 4}, 1.0f));
  EXPECT_FALSE(hits({1, 1, 1}, {0, 0, 3.999f}, 1.0f));
}

TEST(Triangle, AnOriginOnTheTriangleHitsAtZero) {
  TriangleHit hit;
  ASSERT_TRUE(intersect(make_ray({1, 1, 5}, {0, 0, 1}), floor_triangle, hit));
  EXPECT_EQ(hit.t, 0.0f);
}

TEST(Triangle, TheDistanceMayBeMinusZero) {
  // Downwards onto its own plane: enter and exit are 0 * -1, and tmin <= -0 holds.
  TriangleHit hit;
  ASSERT_TRUE(intersect(make_ray({1, 1, 5}, {0, 0, -1}), floor_triangle, hit));
  EXPECT_EQ(hit.t, 0.0f);
  EXPECT_TRUE(std::signbit(hit.t));
  Hit best;
  EXPECT_TRUE(improve(best, 5, {0.0f, 0, 0, 1}));
  EXPECT_FALSE(improve(best, 6, hit));  // a tie: the smaller id wins, whatever the sign
  EXPECT_TRUE(improve(best, 4, hit));
}

TEST(Triangle, EdgeOnIsAMiss) {
  EXPECT_FALSE(hits({-1, 1, 5}, {1, 0, 0}));
  TriangleHit hit;
  const Triangle point{{1, 1, 1, 1, 1, 1, 1, 1, 1}};
  EXPECT_FALSE(intersect(make_ray({1, 1, 0}, {0, 0, 1}), point, hit));
}

TEST(Triangle, ANanRayMisses) { EXPECT_FALSE(hits({std::nanf(""), 1, 1}, {0, 0, 1})); }

TEST(Triangle, DistanceIsClampedToTheBox) {
  // A huge sliver seen at a grazing angle: whatever T / det rounds to, t lies in the triangle's box interval.
  testing::Random random(3);
  int found = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 a = random.point(1), b = a + random.point(1e-3f), c = a + random.point(1e-3f);
    const Triangle sliver{{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z}};
    const Ray ray = make_ray({100, 50, 20}, unit(a * 0.5f + b * 0.25f + c * 0.25f - Vec3{100, 50, 20}));
    TriangleHit hit;
    if (!intersect(ray, sliver, hit)) continue;
    ++found;
    const Interval interval = box_interval(ray, triangle_box(sliver));
    EXPECT_LE(interval.enter, hit.t);
    EXPECT_LE(hit.t, interval.exit);
  }
  EXPECT_GT(found, 1000);
}

TEST(Hit, SmallerDistanceThenSmallerIdWins) {
  Hit best;
  EXPECT_TRUE(improve(best, 7, {2, 0, 0, 1}));
  EXPECT_FALSE(improve(best, 8, {2, 0, 0, 1}));
  EXPECT_TRUE(improve(best, 6, {2, 0, 0, 1}));
  EXPECT_FALSE(improve(best, 1, {3, 0, 0, 1}));
  EXPECT_TRUE(improve(best, 9, {1, 0, 0, 1}));
  EXPECT_EQ(best.id, 9);
}

TEST(Box, IntervalIsPaddedAtItsEnd) {
  const Interval i = box_interval(make_ray({0, 0, 0}, {0, 0, 2}), {{-1, -1, 2}, {1, 1, 4}});
  EXPECT_EQ(i.enter, 1.0f);
  EXPECT_EQ(i.exit, 2.0f + 0x1p-19f);
}

TEST(Box, ZeroDirectionComponents) {
  const Box box{{0, 0, 2}, {1, 1, 4}};
  EXPECT_TRUE(meets(make_ray({0.5f, 0.5f, 0}, {0, 0, 1}), box));
  EXPECT_TRUE(meets(make_ray({0.5f, 0.5f, 0}, {-0.0f, -0.0f, 1}), box));
  EXPECT_FALSE(meets(make_ray({1.5f, 0.5f, 0}, {0, 0, 1}), box));
  EXPECT_FALSE(meets(make_ray({-0x1p-60f, 0.5f, 0}, {0, 0, 1}), box));
  // A box is closed to a ray parallel to its faces, whatever the sign of the zero.
  EXPECT_TRUE(meets(make_ray({0, 0.5f, 0}, {0, 0, 1}), box));
  EXPECT_TRUE(meets(make_ray({1, 0.5f, 0}, {0, 0, 1}), box));
  EXPECT_TRUE(meets(make_ray({0, 0.5f, 0}, {-0.0f, 0, 1}), box));
  EXPECT_FALSE(meets(make_ray({1.0000001f, 0.5f, 0}, {-0.0f, 0, 1}), box));
  EXPECT_TRUE(meets(make_ray({1, 0.5f, 0}, {-0.0f, 0, 1}), box));
}

TEST(Box, BehindAndBeyondAreMisses) {
  const Box box{{-1, -1, 2}, {1, 1, 4}};
  EXPECT_FALSE(meets(make_ray({0, 0, 5}, {0, 0, 1}), box));
  EXPECT_TRUE(meets(make_ray({0, 0, 4}, {0, 0, 1}), box));  // touches at 0
  EXPECT_TRUE(meets(make_ray({0, 0, 3}, {0, 0, 1}), box));
  EXPECT_TRUE(meets(make_ray({0, 0, 1}, {0, 0, 1}, 1.0f), box));
  EXPECT_FALSE(meets(make_ray({0, 0, 0.999f}, {0, 0, 1}, 1.0f), box));
}

TEST(Box, OfATriangleHoldsItsVertices) {
  const Box box = triangle_box({{1, 5, -3, 2, -4, 0, 3, 0, 9}});
  EXPECT_EQ(box.lo.x, 1);
  EXPECT_EQ(box.lo.y, -4);
  EXPECT_EQ(box.lo.z, -3);
  EXPECT_EQ(box.hi.x, 3);
  EXPECT_EQ(box.hi.y, 5);
  EXPECT_EQ(box.hi.z, 9);
}

}  // namespace
}  // namespace artu::ref
