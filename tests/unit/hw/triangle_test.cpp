// The triangle test: hits, edges, what lies behind, what is degenerate (docs/arithmetic.md section 3).
#include "hw/datapath/hit_tests.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace artu::hw::test {
namespace {

Ray ray_from(Vector origin, Vector direction, float tmax = two_pow_100) {
  Ray ray;
  ray.origin = origin;
  ray.direction = direction;
  ray.tmax = tmax;
  set_up(ray);
  return ray;
}

bool intersect(const Ray& ray, Vector p, Vector q, Vector r, TriangleHit& hit) {
  static const HitTests tests;
  return tests.triangle(ray, p, q, r, hit);
}

// A right triangle in the plane z = 0, seen from z > 0 counter-clockwise.
const Vector a{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0};

bool hit_at(float x, float y, TriangleHit& hit) { return intersect(ray_from({x, y, 3}, {0, 0, -1}), a, b, c, hit); }

TEST(Triangle, AHitHasItsDistanceAndBarycentrics) {
  TriangleHit hit;
  ASSERT_TRUE(hit_at(1, 2, hit));
  EXPECT_EQ(hit.t, 3.0f);
  // (1, 2) = 1/4 a + 1/4 b + 1/2 c.
  EXPECT_EQ(hit.U / hit.det, 0.25f);
  EXPECT_EQ(hit.V / hit.det, 0.25f);
  EXPECT_EQ(std::fabs(hit.det), 16.0f) << "twice the area";
}

TEST(Triangle, IsHitFromBothSidesAndAlongEveryAxis) {
  for (int axis = 0; axis < 3; ++axis) {
    for (float side : {-1.0f, 1.0f}) {
      const auto turned = [axis](float x, float y, float z) {
        return axis == 0 ? Vector{z, x, y} : axis == 1 ? Vector{y, z, x} : Vector{x, y, z};
      };
      TriangleHit hit;
      const Ray ray = ray_from(turned(1, 1, 2 * side), turned(0, 0, -side));
      ASSERT_TRUE(intersect(ray, turned(0, 0, 0), turned(4, 0, 0), turned(0, 4, 0), hit)) << axis << side;
      EXPECT_EQ(hit.t, 2.0f);
      EXPECT_EQ(hit.U / hit.det, 0.5f);
    }
  }
}

TEST(Triangle, ARayInAFaceOfItsBoxGetsItsOwnT) {
  // 0 * inv = 0 must not become an end of the box's interval, to which the clamp would pull t.
  const Vector p{0, 0, -5}, q{0, 1, 1}, r{1, 0, -5};
  TriangleHit hit;
  EXPECT_FALSE(intersect(ray_from({0, 0.25f, 0}, {0, 0, 1}), p, q, r, hit)) << "behind the origin, by 3.5";
  for (float zero : {0.0f, -0.0f}) {
    ASSERT_TRUE(intersect(ray_from({0, 0.25f, -4}, {zero, 0, 1}), p, q, r, hit));
    EXPECT_EQ(hit.t, 0.5f);
    // A component so small that its inverse is limited counts as none where the slab holds the origin.
    ASSERT_TRUE(intersect(ray_from({0, 0.25f, -4}, {0x1p-120f, 0, 1}), p, q, r, hit));
    EXPECT_EQ(hit.t, 0.5f);
  }
}

TEST(Triangle, EdgesAndCornersBelongToIt) {
  TriangleHit hit;
  EXPECT_TRUE(hit_at(2, 0, hit));
  EXPECT_TRUE(hit_at(2, 2, hit));
  EXPECT_TRUE(hit_at(0, 0, hit));
  // In a face of its bounding box too, for a ray exactly parallel to that face.
  EXPECT_TRUE(hit_at(0, 4, hit));
  EXPECT_EQ(hit.t, 3.0f);
  EXPECT_TRUE(intersect(ray_from({0, 4, 4}, {0, -0x1p-60f, -1}), a, b, c, hit));
  EXPECT_FALSE(hit_at(2, -0x1p-20f, hit));
  EXPECT_FALSE(hit_at(2, 2.000001f, hit));
  EXPECT_FALSE(hit_at(-0x1p-20f, 2, hit));
}

TEST(Triangle, NoRayPassesBetweenTwoThatShareAnEdge) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> between(-1, 1);
  const Vector p{-0.9f, -0.95f, 0.13f}, q{0.97f, 0.88f, -0.21f}, left{-1, 1, 0.3f}, right{1, -1, -0.4f};
  for (int i = 0; i < 20000; ++i) {
    const float s = 0.5f + 0.49f * between(random);
    const Vector target = p * (1.0f - s) + q * s;  // on the edge, as well as it can be said
    const Vector origin{between(random), between(random), 5};
    const Ray ray = ray_from(origin, unit(target - origin));
    TriangleHit hit;
    ASSERT_TRUE(intersect(ray, p, q, left, hit) || intersect(ray, q, p, right, hit)) << i;
  }
}

TEST(Triangle, WhatLiesBehindTheOriginIsNotHit) {
  TriangleHit hit;
  EXPECT_FALSE(intersect(ray_from({1, 1, 3}, {0, 0, 1}), a, b, c, hit));
  EXPECT_FALSE(intersect(ray_from({1, 1, -0x1p-10f}, {0, 0, -1}), a, b, c, hit));
  EXPECT_TRUE(intersect(ray_from({1, 1, 0}, {0, 0, -1}), a, b, c, hit)) << "tmin is 0, inclusive";
  EXPECT_EQ(hit.t, 0.0f);
}

TEST(Triangle, TheLimitOfARayIsInclusive) {
  TriangleHit hit;
  EXPECT_TRUE(intersect(ray_from({1, 1, 3}, {0, 0, -1}, 3.0f), a, b, c, hit));
  EXPECT_FALSE(intersect(ray_from({1, 1, 3}, {0, 0, -1}, 2.9999998f), a, b, c, hit));
}

TEST(Triangle, AnUnscaledDirectionGivesTheDistanceInItsUnits) {
  TriangleHit hit;
  ASSERT_TRUE(intersect(ray_from({1, 1, 3}, {0, 0, -6}, 1.0f), a, b, c, hit));
  EXPECT_EQ(hit.t, 0.5f);
}

TEST(Triangle, DegenerateOnesAreNotHit) {
  TriangleHit hit;
  EXPECT_FALSE(intersect(ray_from({1, 1, 3}, {0, 0, -1}), a, a, a, hit)) << "a point";
  EXPECT_FALSE(intersect(ray_from({1, 0, 3}, {0, 0, -1}), a, b, {2, 0, 0}, hit)) << "a line";
  EXPECT_FALSE(intersect(ray_from({-1, 1, 0}, {1, 0, 0}), a, b, c, hit)) << "seen edge-on";
}

TEST(Triangle, ANaNIsNoHit) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  TriangleHit hit;
  EXPECT_FALSE(intersect(ray_from({1, 1, 3}, {0, 0, -1}), {nan, 0, 0}, b, c, hit));
  EXPECT_FALSE(intersect(ray_from({1, 1, 3}, {0, 0, -1}), {0, 0, nan}, b, c, hit));
  EXPECT_FALSE(intersect(ray_from({1, 1, 3}, {0, 0, -1}), {0, 0, -infinity}, b, c, hit));
}

TEST(Triangle, AHitLiesInTheIntervalOfItsBoundingBox) {
  // That is the clamp: no tree of boxes can lose a hit.
  std::mt19937 random(11);
  std::uniform_real_distribution<float> between(-1, 1);
  const auto vector = [&](float scale) {
    return Vector{between(random) * scale, between(random) * scale, between(random) * scale};
  };
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vector p = vector(1), q = p + vector(0.01f), r = p + vector(0.01f);
    const Vector origin = vector(1000);
    const Ray ray = ray_from(origin, unit((p + q + r) * (1.0f / 3.0f) - origin));
    TriangleHit hit;
    if (!intersect(ray, p, q, r, hit)) continue;
    ++hits;
    float enter = -two_pow_100, exit = two_pow_100;
    for (int k = 0; k < 3; ++k) {
      const float lo = (std::min({p[k], q[k], r[k]}) - origin[k]) * ray.inverse[k];
      const float hi = (std::max({p[k], q[k], r[k]}) - origin[k]) * ray.inverse[k];
      enter = std::max(enter, std::min(lo, hi));
      exit = std::min(exit, std::max(lo, hi));
    }
    ASSERT_GE(hit.t, enter);
    ASSERT_LE(hit.t, exit * (1.0f + 0x1p-21f));
  }
  EXPECT_GT(hits, 10000);
}

TEST(Triangle, EqualTrianglesGiveEqualBits) {
  // A tie between two leaves is decided by the primitive's number; so the same triangle must give the same t.
  TriangleHit first, second;
  const Ray ray = ray_from({0.7f, 1.1f, 9}, unit(Vector{0.05f, 0.02f, -1}));
  ASSERT_TRUE(intersect(ray, a, b, c, first));
  ASSERT_TRUE(intersect(ray, a, b, c, second));
  EXPECT_EQ(bits_of(first.t), bits_of(second.t));
}

}  // namespace
}  // namespace artu::hw::test
