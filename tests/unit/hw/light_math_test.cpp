// Lights, sky and materials, worked out by hand (docs/arithmetic.md section 7).
#include <gtest/gtest.h>

#include "unit/hw/shading_math.h"

namespace artu::hw::test {
namespace {

TEST_F(ShadingMath, ADirectionalLightHasNoDistance) {
  light.type = LightType::directional;
  light.range = 0;
  ASSERT_TRUE(lit());
  expect_vector(shadow.contribution, 2, 1, 4);
  expect_vector(shadow.direction, 0, 1, 0);
  EXPECT_EQ(shadow.tmax, two_pow_100);
}

TEST_F(ShadingMath, APointLightFallsWithTheSquareOfTheDistance) {
  ASSERT_TRUE(lit());
  expect_vector(shadow.contribution, 0.5f, 0.25f, 1);
  expect_vector(shadow.direction, 0, 2, 0);
  EXPECT_EQ(shadow.tmax, 1.0f) << "the light is at the end of the unscaled ray";
}

TEST_F(ShadingMath, TheRangeIsInclusive) {
  light.range = 2;
  EXPECT_TRUE(lit());
  light.range = 1.9999f;
  EXPECT_FALSE(lit());
}

TEST_F(ShadingMath, ALightAtThePointIsSkipped) {
  light.position = point.outside;
  EXPECT_FALSE(lit());
  light.position = {0, 0x1p51f, 0};
  light.range = two_pow_100;
  EXPECT_FALSE(lit()) << "and so is one too far for its squared distance";
}

TEST_F(ShadingMath, ASpotFallsBetweenItsCones) {
  light.type = LightType::spot;
  light.cos_inner = 0.75f;
  light.cos_outer = 0.5f;
  ASSERT_TRUE(lit());
  expect_vector(shadow.contribution, 0.5f, 0.25f, 1);
  light.direction = {0, -0.75f, 0};
  ASSERT_TRUE(lit());
  expect_vector(shadow.contribution, 0.5f, 0.25f, 1);
  light.direction = {0, -0.625f, 0};  // half way: a half, squared
  ASSERT_TRUE(lit());
  expect_vector(shadow.contribution, 0.125f, 0.0625f, 0.25f);
  light.direction = {0, -0.5f, 0};
  EXPECT_FALSE(lit()) << "nothing at the outer cone";
}

TEST_F(ShadingMath, ASpotWithoutAPenumbraHasAnEdgeOfTwoToTheMinusTen) {
  light.type = LightType::spot;
  light.cos_inner = light.cos_outer = 0.5f;
  light.direction = {0, -0.5f - 0x1p-11f, 0};  // 2^-11 / 2^-10: a half
  ASSERT_TRUE(lit());
  expect_vector(shadow.contribution, 0.125f, 0.0625f, 0.25f);
}

TEST_F(ShadingMath, ALightBehindEitherNormalIsSkipped) {
  light.position = {0, -2, 0};
  EXPECT_FALSE(lit());
  light.position = {2, 0, 0};
  EXPECT_FALSE(lit()) << "grazing";
  light.position = {2, -0.1f, 0};
  point.shading_normal = {0.8f, 0.6f, 0};
  EXPECT_FALSE(lit()) << "in front of the shading normal only";
}

TEST_F(ShadingMath, ALightThatAddsNothingIsSkipped) {
  light.color = {};
  EXPECT_FALSE(lit());
  light.color = {1, 1, 1};
  point.weight = {};
  EXPECT_FALSE(lit());
}

TEST_F(ShadingMath, TheHighlightIsRaisedToAPowerOfTwo) {
  light.type = LightType::directional;
  light.direction = {-0.8f, -0.6f, 0};  // half vector (0.8, 1.6) / sqrt(3.2): its height squared is 0.8
  light.color = {1, 1, 1};
  point.diffuse = {};
  point.specular = {1, 0.5f, 0};
  point.specular_log2 = 0;
  ASSERT_TRUE(lit());
  EXPECT_NEAR(shadow.contribution.x, std::sqrt(0.8), 1e-6);
  point.specular_log2 = 2;
  ASSERT_TRUE(lit());
  EXPECT_NEAR(shadow.contribution.x, 0.64, 1e-6);
  EXPECT_NEAR(shadow.contribution.y, 0.32, 1e-6);
  point.diffuse = {1, 1, 1};
  ASSERT_TRUE(lit());
  EXPECT_NEAR(shadow.contribution.x, 0.6 + 0.64, 1e-6);
}

TEST_F(ShadingMath, TheSkyIsMixedByHeight) {
  constants.sky_nadir = {0, 1, 2};
  constants.sky_zenith = {1, 3, 2};
  expect_vector(sky(constants, {0, 1, 0}), 1, 3, 2);
  expect_vector(sky(constants, {0, -1, 0}), 0, 1, 2);
  expect_vector(sky(constants, {1, 0, 0}), 0.5f, 2, 2);
}

TEST_F(ShadingMath, TintColoursTheHighlightAndTheMirror) {
  Surface surface;
  surface.color = {0.5f, 1, 1};
  MaterialRecord material{};
  material.diffuse = material.transmission = material.specular = material.mirror = {1, 1, 1};
  material.emission = {0.25f, 0, 0};
  constants.ambient = {0.5f, 0.5f, 0.5f};
  const Vector texture{0.5f, 0.5f, 1};
  const Vector base = begin_shading(constants, surface, material, texture, {0, -1, 0}, {1, 1, 1}, point);
  expect_vector(base, 0.25f + 0.125f, 0.25f, 0.5f);
  expect_vector(point.diffuse, 0.25f, 0.5f, 1);
  expect_vector(point.transmission, 0.25f, 0.5f, 1);
  expect_vector(point.specular, 1, 1, 1);
  material.tint = 1;
  begin_shading(constants, surface, material, texture, {0, -1, 0}, {1, 1, 1}, point);
  expect_vector(point.specular, 0.25f, 0.5f, 1);
  expect_vector(point.mirror, 0.25f, 0.5f, 1);
}

}  // namespace
}  // namespace artu::hw::test
