#include "ref/ray.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace artu::ref {
namespace {

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();

TEST(Scalars, TieOrNanGivesTheSecondOperand) {
  EXPECT_TRUE(std::signbit(min(0.0f, -0.0f)));
  EXPECT_FALSE(std::signbit(min(-0.0f, 0.0f)));
  EXPECT_FALSE(std::signbit(max(-0.0f, 0.0f)));
  EXPECT_TRUE(std::signbit(max(0.0f, -0.0f)));
  EXPECT_EQ(min(nan_value, 3.0f), 3.0f);
  EXPECT_TRUE(std::isnan(min(3.0f, nan_value)));
  EXPECT_EQ(max(nan_value, 3.0f), 3.0f);
  EXPECT_TRUE(std::isnan(max(3.0f, nan_value)));
}

TEST(Scalars, NothingIsContracted) {
  // (1 + 2^-12)^2 rounds to 1 + 2^-11; a fused multiply-add would keep 2^-24.
  const float a = 1.0f + 0x1p-12f;
  EXPECT_EQ(dot({a, 1, 0}, {a, -(1.0f + 0x1p-11f), 0}), 0.0f);
}

TEST(Unit, IsZeroOutsideOfItsRange) {
  EXPECT_EQ(unit({0, 3, 4}).z, 4.0f * (1.0f / 5.0f));
  EXPECT_EQ(unit({0x1p-50f, 0, 0}).x, 1.0f);  // the border is inside
  EXPECT_TRUE(is_zero(unit({0x1.fp-51f, 0, 0})));
  EXPECT_EQ(unit({0, 0x1p50f, 0}).y, 1.0f);
  EXPECT_TRUE(is_zero(unit({0, 0x1.1p50f, 0})));
  EXPECT_TRUE(is_zero(unit({0, 0, 0})));
  EXPECT_TRUE(is_zero(unit({nan_value, 1, 0})));
  EXPECT_TRUE(is_zero(unit({std::numeric_limits<float>::infinity(), 1, 0})));
}

TEST(SetUp, TakesTheFirstLargestAxis) {
  EXPECT_EQ(make_ray({}, {1, -1, 1}).kz, 0);
  EXPECT_EQ(make_ray({}, {0.5f, -1, 1}).kz, 1);
  EXPECT_EQ(make_ray({}, {0.5f, 1, -1.5f}).kz, 2);
  EXPECT_EQ(make_ray({}, {0.5f, 0.5f, -1}).kz, 2);
  EXPECT_EQ(make_ray({}, {-1, 0, -1}).kz, 0);
}

TEST(SetUp, SwapsAxesWhereTheDirectionIsNegative) {
  const Ray plus = make_ray({}, {0.25f, 0.5f, 2});
  EXPECT_EQ(plus.kx, 0);
  EXPECT_EQ(plus.ky, 1);
  EXPECT_EQ(plus.sx, 0.125f);
  EXPECT_EQ(plus.sy, 0.25f);
  EXPECT_EQ(plus.sz, 0.5f);
  const Ray minus = make_ray({}, {0.25f, 0.5f, -2});
  EXPECT_EQ(minus.kx, 1);
  EXPECT_EQ(minus.ky, 0);
  EXPECT_EQ(minus.sx, -0.25f);
  EXPECT_EQ(minus.sy, -0.125f);
  EXPECT_EQ(minus.sz, -0.5f);
}

TEST(SetUp, InverseIsBoundedAndKeepsTheSign) {
  const Ray zero = make_ray({}, {0.0f, -0.0f, 1});
  EXPECT_EQ(zero.inv.x, 0x1p100f);
  EXPECT_EQ(zero.inv.y, -0x1p100f);
  EXPECT_EQ(zero.inv.z, 1.0f);
  const Ray tiny = make_ray({}, {0x1p-99f, -0x1p-101f, 1});
  EXPECT_EQ(tiny.inv.x, 0x1p99f);
  EXPECT_EQ(tiny.inv.y, -0x1p100f);
  EXPECT_EQ(make_ray({}, {1e-44f, 0, 1}).inv.x, 0x1p100f);  // subnormal: 1 / x overflows
}

TEST(Camera, PixelCentresAreAtHalf) {
  traces::Camera camera;
  camera.origin = {1, 2, 3};
  camera.origin_du = {2, 0, 0};
  camera.origin_dv = {0, 4, 0};
  camera.corner = {0, -1, 0};
  camera.du = {0, 0, 0};
  camera.dv = {0, 0, 0};
  const Vec3 o = camera_origin(camera, 3, 1);
  EXPECT_EQ(o.x, 1 + 2 * 3.5f);
  EXPECT_EQ(o.y, 2 + 4 * 1.5f);
  EXPECT_EQ(o.z, 3.0f);
  EXPECT_EQ(camera_direction(camera, 3, 1).y, -1.0f);
  camera.corner = {-3.5f, 0, 0};
  camera.du = {1, 0, 0};
  EXPECT_TRUE(is_dead(camera_direction(camera, 3, 0)));
  EXPECT_FALSE(is_dead(camera_direction(camera, 2, 0)));
}

}  // namespace
}  // namespace artu::ref
