// Reflection and refraction rays, worked out by hand (docs/arithmetic.md section 7).
#include <gtest/gtest.h>

#include "unit/hw/shading_math.h"

namespace artu::hw::test {
namespace {

TEST_F(ShadingMath, AMirrorReflects) {
  point.direction = {0.6f, -0.8f, 0};
  point.mirror = {0.5f, 0.25f, 0};
  point.weight = {0.5f, 0.5f, 0.5f};
  ASSERT_TRUE(next().reflection);
  EXPECT_FALSE(next().refraction);
  expect_vector(next().reflection_direction, 0.6f, 0.8f, 0);
  expect_vector(next().reflection_weight, 0.25f, 0.125f, 0);
}

TEST_F(ShadingMath, TheSmallestWeightIsInclusiveAndZeroIsNeverTraced) {
  point.mirror = {0.1f, 0.25f, 0};
  constants.min_weight = 0.25f;
  EXPECT_TRUE(next().reflection);
  constants.min_weight = 0.2500001f;
  EXPECT_FALSE(next().reflection);
  constants.min_weight = 0;
  point.mirror = {};
  EXPECT_FALSE(next().reflection);
}

TEST_F(ShadingMath, AReflectionIntoTheSurfaceIsTurnedAtTheGeometricNormal) {
  point.mirror = {1, 1, 1};
  point.direction = {0.8f, -0.6f, 0};
  point.shading_normal = {0.6f, 0.8f, 0};  // the ray would be let through unturned, downwards
  expect_vector(next().reflection_direction, 0.8f, 0.6f, 0);
}

TEST_F(ShadingMath, GlassDividesTheLight) {
  point.transmission = {1, 0.5f, 0};
  point.ior = 1.5f;  // four percent at normal incidence
  ASSERT_TRUE(next().reflection && next().refraction);
  expect_vector(next().reflection_weight, 0.04f, 0.02f, 0);
  expect_vector(next().refraction_weight, 0.96f, 0.48f, 0);
  expect_vector(next().refraction_direction, 0, -1, 0);
}

TEST_F(ShadingMath, RefractionFollowsSnell) {
  point.transmission = {1, 1, 1};
  point.ior = 1.5f;
  point.direction = {0.6f, -0.8f, 0};
  expect_vector(next().refraction_direction, 0.4f, -std::sqrt(1 - 0.16f), 0);
  point.front = false;  // out of the glass: the sine grows
  EXPECT_NEAR(next().refraction_direction.x, 0.9, 1e-6);
  EXPECT_NEAR(next().refraction_direction.y, -std::sqrt(1 - 0.81), 1e-6);
}

TEST_F(ShadingMath, BeyondTheCriticalAngleAllIsReflected) {
  point.transmission = {0.5f, 0.5f, 0.5f};
  point.mirror = {0.125f, 0, 0};
  point.ior = 1.5f;
  point.front = false;
  point.direction = {0.8f, -0.6f, 0};
  EXPECT_FALSE(next().refraction);
  expect_vector(next().reflection_weight, 0.625f, 0.5f, 0.5f);
}

TEST_F(ShadingMath, WithoutADifferenceOfIndexNothingIsReflected) {
  point.transmission = {1, 1, 1};
  point.ior = 1;
  point.direction = {0.6f, -0.8f, 0};
  EXPECT_FALSE(next().reflection);
  expect_vector(next().refraction_direction, 0.6f, -0.8f, 0);
  expect_vector(next().refraction_weight, 1, 1, 1);
}

TEST_F(ShadingMath, ARefractionOutOfTheSurfaceGoesStraightOn) {
  point.transmission = {1, 1, 1};
  point.ior = 1.5f;
  point.front = false;
  point.direction = {0.6f, -0.8f, 0};  // bent to (0.9, -0.44), which is above the real surface
  point.geometric_normal = {0.6f, 0.8f, 0};
  expect_vector(next().refraction_direction, 0.6f, -0.8f, 0);
}

}  // namespace
}  // namespace artu::hw::test
