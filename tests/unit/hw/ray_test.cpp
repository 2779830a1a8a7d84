// A ray's set-up and the box test, against numbers worked out by hand (docs/arithmetic.md sections 1 to 3).
#include "hw/datapath/ray.h"

#include <gtest/gtest.h>

#include <limits>

#include "hw/datapath/box.h"

namespace artu::hw::test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
const float nan = std::numeric_limits<float>::quiet_NaN();

Ray ray_from(Vector origin, Vector direction) {
  Ray ray;
  ray.origin = origin;
  ray.direction = direction;
  set_up(ray);
  return ray;
}

TEST(Vector, MinimumAndMaximumGiveTheSecondOperandOnATieOrWithANaN) {
  EXPECT_TRUE(std::signbit(minimum(0.0f, -0.0f)));
  EXPECT_FALSE(std::signbit(minimum(-0.0f, 0.0f)));
  EXPECT_TRUE(std::signbit(maximum(0.0f, -0.0f)));
  EXPECT_EQ(minimum(nan, 1.0f), 1.0f);
  EXPECT_EQ(maximum(nan, 1.0f), 1.0f);
  EXPECT_TRUE(std::isnan(minimum(1.0f, nan)));
  EXPECT_TRUE(std::isnan(maximum(1.0f, nan)));
}

TEST(Vector, DotSumsFromLeftToRight) {
  // (2^24 + 1) + 1 loses both ones; 2^24 + (1 + 1) would not.
  EXPECT_EQ(dot(Vector{0x1p24f, 1, 1}, Vector{1, 1, 1}), 0x1p24f);
  EXPECT_EQ(dot(Vector{1, 1, 0x1p24f}, Vector{1, 1, 1}), 0x1p24f + 2);
}

TEST(Vector, UnitIsZeroOutsideItsRange) {
  EXPECT_EQ(unit(Vector{3, 0, 4}).x, 3 * (1.0f / 5.0f));
  EXPECT_EQ(unit(Vector{0, 0x1p-50f, 0}).y, 1.0f);  // squared 2^-100: just inside
  EXPECT_TRUE(is_zero(unit(Vector{0, 0x1p-51f, 0})));
  EXPECT_EQ(unit(Vector{0x1p50f, 0, 0}).x, 1.0f);
  EXPECT_TRUE(is_zero(unit(Vector{0x1p51f, 0, 0})));
  EXPECT_TRUE(is_zero(unit(Vector{nan, 0, 0})));
  EXPECT_TRUE(is_zero(unit(Vector{})));
}

TEST(Ray, ZeroComponentsHaveALimitedInverseOfTheirSign) {
  const Ray ray = ray_from({}, {0.0f, -0.0f, 2.0f});
  EXPECT_EQ(ray.inverse.x, two_pow_100);
  EXPECT_EQ(ray.inverse.y, -two_pow_100);
  EXPECT_EQ(ray.inverse.z, 0.5f);
  EXPECT_EQ(ray_from({}, {0x1p-99f, -0x1p-100f, 1}).inverse.x, 0x1p99f);
  EXPECT_EQ(ray_from({}, {0x1p-99f, -0x1p-100f, 1}).inverse.y, -two_pow_100);
}

TEST(Ray, TheLargestComponentIsTheAxisAndTheFirstOneOnATie) {
  struct Case {
    Vector direction;
    int kx, ky, kz;
  };
  for (const Case& c :
       {Case{{1, 0, 0}, 1, 2, 0}, Case{{0, 1, 0}, 2, 0, 1}, Case{{0, 0, 1}, 0, 1, 2}, Case{{-1, 0, 0}, 2, 1, 0},
        Case{{0, -1, 0}, 0, 2, 1}, Case{{0, 0, -1}, 1, 0, 2}, Case{{1, 1, 1}, 1, 2, 0}, Case{{-1, 1, 1}, 2, 1, 0},
        Case{{1, 2, -2}, 2, 0, 1}, Case{{1, -2, 2}, 0, 2, 1}, Case{{1, 2, -3}, 1, 0, 2}}) {
    const Ray ray = ray_from({}, c.direction);
    EXPECT_EQ(ray.kx, c.kx);
    EXPECT_EQ(ray.ky, c.ky);
    EXPECT_EQ(ray.kz, c.kz) << c.direction.x << " " << c.direction.y << " " << c.direction.z;
  }
}

TEST(Ray, TheShearIsThatOfTheAxis) {
  const Ray ray = ray_from({}, {1, 3, -4});  // kz = 2, negative: kx = 1, ky = 0
  EXPECT_EQ(ray.sx, -0.75f);
  EXPECT_EQ(ray.sy, -0.25f);
  EXPECT_EQ(ray.sz, -0.25f);
}

TEST(Ray, PrimaryRaysGoThroughPixelCentres) {
  CameraRegisters camera;
  camera.origin = {1, 2, 3};
  camera.origin_du = {0.5f, 0, 0};
  camera.origin_dv = {0, 0.25f, 0};
  camera.corner = {-1, 1, -2};
  camera.du = {0.5f, 0, 0};
  camera.dv = {0, -0.5f, 0};
  const Ray ray = primary_ray(camera, 1, 3);  // at (1.5, 3.5)
  EXPECT_EQ(ray.origin.x, 1.75f);
  EXPECT_EQ(ray.origin.y, 2.875f);
  EXPECT_EQ(ray.origin.z, 3.0f);
  const float length = std::sqrt(0.25f * 0.25f + 0.75f * 0.75f + 4.0f);  // of (-0.25, -0.75, -2)
  EXPECT_FLOAT_EQ(ray.direction.x, -0.25f / length);
  EXPECT_FLOAT_EQ(ray.direction.y, -0.75f / length);
  EXPECT_FLOAT_EQ(ray.direction.z, -2.0f / length);
  EXPECT_EQ(ray.tmax, two_pow_100);
  camera.corner = camera.du = camera.dv = {};
  EXPECT_TRUE(is_zero(primary_ray(camera, 0, 0).direction)) << "a dead ray";
}

Interval box_of(const Ray& ray, Vector lo, Vector hi) { return box_interval(ray, lo, hi, box_padding()); }

TEST(Box, TheIntervalIsFromTheLastEntryToTheFirstExitPadded) {
  const Ray ray = ray_from({0, 0, 0}, {1, 0.5f, 0.25f});
  const Interval box = box_of(ray, {1, 1, 0}, {4, 3, 8});
  EXPECT_EQ(box.enter, 2.0f);                     // y enters at 1 / 0.5
  EXPECT_EQ(box.exit, 4.0f * (1.0f + 0x1p-20f));  // x leaves at 4
  const Ray back = ray_from({5, 2, 1}, {-1, 0, 0});
  EXPECT_EQ(box_of(back, {1, 1, 0}, {4, 3, 8}).enter, 1.0f);
  EXPECT_EQ(box_of(back, {1, 1, 0}, {4, 3, 8}).exit, 4.0f * (1.0f + 0x1p-20f));
}

TEST(Box, IsMetOnlyWhereTheIntervalsOverlap) {
  EXPECT_TRUE(meets({2, 4}, 2.0f)) << "touching counts";
  EXPECT_FALSE(meets({2, 4}, 1.99f));
  EXPECT_TRUE(meets({-3, 0}, 10.0f)) << "at the origin";
  EXPECT_FALSE(meets({-3, -1}, 10.0f)) << "behind";
  EXPECT_FALSE(meets({3, 2}, 10.0f)) << "missed";
  EXPECT_TRUE(meets({-infinity, infinity}, 0.0f));
}

TEST(Box, ARayInThePlaneOfAFaceIsInsideTheBox) {
  // (lo - o) is 0 and the inverse 2^100: 0 * 2^100 is 0, never a NaN.
  const Ray ray = ray_from({-2, 1, 0.5f}, {1, 0, 0});
  const Interval touching = box_of(ray, {0, 1, 0}, {1, 2, 1});
  EXPECT_EQ(touching.enter, 2.0f);
  EXPECT_TRUE(meets(touching, 100.0f));
  EXPECT_FALSE(meets(box_of(ray, {0, 1.001f, 0}, {1, 2, 1}), two_pow_100)) << "just beside it";
}

TEST(Box, AnOuterBoxHoldsAnInnerBoxsInterval) {
  const Ray ray = ray_from({0.3f, -7.7f, 0.1f}, unit(Vector{0.1f, 0.9f, 0.3f}));
  for (int i = 1; i < 200; ++i) {
    const float s = static_cast<float>(i) * 0.013f;
    const Interval inner = box_of(ray, {-s, -s, -s}, {s, s, s});
    const Interval outer = box_of(ray, {-s, -s * 1.0000002f, -s}, {s * 1.0000002f, s, s});
    ASSERT_LE(outer.enter, inner.enter);
    ASSERT_GE(outer.exit, inner.exit);
  }
}

}  // namespace
}  // namespace artu::hw::test
