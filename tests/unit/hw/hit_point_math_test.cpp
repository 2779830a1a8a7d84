// The surface at a hit (docs/arithmetic.md section 5).
#include "hw/datapath/hit_point.h"

#include <gtest/gtest.h>

#include <tuple>

namespace artu::hw::test {
namespace {

void expect_vector(Vector v, float x, float y, float z) {
  EXPECT_EQ(v.x, x);
  EXPECT_EQ(v.y, y);
  EXPECT_EQ(v.z, z);
}

/// Hit at the weights 1/4, 1/4, 1/2 of a triangle in the plane z = 1.
struct HitPointMath : testing::Test {
  HitPointMath() {
    triangle.a = {0, 0, 1};
    triangle.b = {4, 0, 1};
    triangle.c = {0, 4, 1};
    triangle.color[0] = triangle.color[1] = triangle.color[2] = 0xffffffffu;
    for (Vector& normal : attributes.normal) normal = {0, 0, 1};
    hit.U = 4;
    hit.V = 4;
    hit.det = 16;
    ray.direction = {0, 0, -1};
  }
  Surface surface() const { return surface_at(ray, hit, triangle, attributes); }
  TriangleRecord triangle{};
  AttributeRecord attributes{};
  TriangleHit hit;
  Ray ray;
};

TEST_F(HitPointMath, TheOriginsAreOffTheSurfaceBySixtyFourUnitsOfTheLargestCoordinate) {
  const float epsilon = 4.0f * 0x1p-18f;
  expect_vector(surface().outside, 1, 2, 1 + epsilon);
  expect_vector(surface().inside, 1, 2, 1 - epsilon);
}

TEST_F(HitPointMath, TheOffsetGrowsWithTheLongestEdgeWhicheverItIs) {
  // Coordinates of 4 at most, and from one corner to another 8 along an axis; a narrow test, so that edges count.
  constexpr int bits = 10;
  const float epsilon = 4 * 0x1p-19f + 8 * 0x1p-6f;
  const Vector corner{0, 4, 0}, low{-4, 0, 0}, high{4, 0, 0};
  ray.direction = {0, 0, -1};
  for (const auto& [a, b, c] :
       {std::tuple{corner, low, high}, std::tuple{high, corner, low}, std::tuple{low, high, corner}}) {
    triangle.a = a;
    triangle.b = b;
    triangle.c = c;
    EXPECT_EQ(surface_at(ray, hit, triangle, attributes, bits).outside.z, epsilon);
  }
}

TEST_F(HitPointMath, NormalsAreOnTheRaysSide) {
  expect_vector(surface().geometric_normal, 0, 0, 1);
  EXPECT_TRUE(surface().front);
  ray.direction = {0, 0, 1};
  EXPECT_FALSE(surface().front);
  EXPECT_EQ(surface().geometric_normal.z, -1.0f);
  EXPECT_EQ(surface().shading_normal.z, -1.0f) << "turned with the geometric one";
  ray.direction = {1, 0, 0};
  EXPECT_TRUE(surface().front) << "a grazing ray is in front";
}

TEST_F(HitPointMath, TheShadingNormalIsMixedAndMadeAUnit) {
  attributes.normal[0] = {1, 0, 0};
  attributes.normal[1] = {1, 0, 0};
  attributes.normal[2] = {0, 0, 1};  // 1/4, 1/4, 1/2: (1/2, 0, 1/2)
  const float s = 0.5f * (1.0f / std::sqrt(0.5f));
  expect_vector(surface().shading_normal, s, 0, s);
}

TEST_F(HitPointMath, AZeroShadingNormalIsReplacedByTheGeometricOne) {
  attributes.normal[0] = {0, 0, 1};
  attributes.normal[1] = {0, 0, 1};
  attributes.normal[2] = {0, 0, -1};  // cancels
  expect_vector(surface().shading_normal, 0, 0, 1);
}

TEST_F(HitPointMath, TinyTrianglesKeepTheirNormal) {
  for (float scale : {0x1p-70f, 0x1p70f}) {
    triangle.a = {0, 0, 0};
    triangle.b = {3 * scale, 0, 0};
    triangle.c = {0, scale, 0};
    expect_vector(surface().geometric_normal, 0, 0, 1);
  }
}

TEST_F(HitPointMath, ADegenerateTriangleFacesTheRay) {
  triangle.b = triangle.c = triangle.a;
  attributes.normal[0] = attributes.normal[1] = attributes.normal[2] = {};
  expect_vector(surface().geometric_normal, 0, 0, 1);
  expect_vector(surface().shading_normal, 0, 0, 1);
}

TEST_F(HitPointMath, TextureCoordinatesAndColoursAreMixed) {
  attributes.uv[0][0] = 1;
  attributes.uv[1][0] = 2;
  attributes.uv[2][0] = 3;
  attributes.uv[2][1] = 8;
  triangle.color[0] = 0x00ff0033u;  // R 51, G 0, B 255
  triangle.color[1] = 0x0000ff00u;
  triangle.color[2] = 0x000000ffu;
  const Surface s = surface();
  EXPECT_EQ(s.u, 0.25f + 0.5f + 1.5f);
  EXPECT_EQ(s.v, 4.0f);
  expect_vector(s.color, 0.25f * (51.0f / 255.0f) + 0.5f, 0.25f, 0.25f);
}

}  // namespace
}  // namespace artu::hw::test
