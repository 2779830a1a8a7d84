// A white floor at the origin, looked at from above; the light is above it.
#pragma once

#include <gtest/gtest.h>

#include "hw/datapath/shading.h"

namespace artu::hw::test {

inline void expect_vector(Vector v, float x, float y, float z) {
  EXPECT_FLOAT_EQ(v.x, x);
  EXPECT_FLOAT_EQ(v.y, y);
  EXPECT_FLOAT_EQ(v.z, z);
}

struct ShadingMath : testing::Test {
  ShadingMath() {
    point.direction = {0, -1, 0};
    point.weight = {1, 1, 1};
    point.geometric_normal = point.shading_normal = {0, 1, 0};
    point.diffuse = {0.5f, 0.25f, 1};
    light.color = {4, 4, 4};
    light.range = 100;
    light.direction = {0, -1, 0};
    light.position = {0, 2, 0};
    light.type = LightType::point;
  }
  bool lit() { return light_contribution(point, light, shadow); }
  NextRays next() const { return next_rays(constants, point); }
  ShadedPoint point;
  LightRecord light{};
  ShadowRay shadow;
  ShadingConstants constants;
};

}  // namespace artu::hw::test
