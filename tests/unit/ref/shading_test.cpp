// Hit points, lights, reflection and refraction against values worked out by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "ref/embree_scene.h"
#include "ref/hit_point.h"
#include "ref/lights.h"
#include "ref/scatter.h"
#include "unit/ref/meshes.h"

namespace artu::ref {
namespace {

using testing::add_triangle;
using testing::Mesh;

template <class V>
void expect_vector(const V& v, float x, float y, float z) {
  EXPECT_EQ(v.x, x);
  EXPECT_EQ(v.y, y);
  EXPECT_EQ(v.z, z);
}

// A (0, 0, 0), B (4, 0, 0), C (0, 4, 0): normal +z.
Mesh plane() {
  Mesh mesh;
  add_triangle(mesh, {0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  return mesh;
}

HitPoint point_of(const Mesh& mesh, const Vec3& origin, const Vec3& direction) {
  EmbreeDevice device;
  EmbreeScene scene(device);
  scene.set(mesh, 0);
  TriangleHit hit{};
  EXPECT_TRUE(scene.tests().intersect(make_ray(origin, direction), scene.triangles()[0], hit));
  return hit_point(mesh, 0, direction, hit);
}

TEST(HitPoint, MixesTheVerticesByTheirOwnWeights) {
  Mesh mesh = plane();
  mesh.uvs = {{1, 0}, {0, 8}, {0, 16}};
  mesh.colors = {0xff0000ffu, 0xff00ff00u, 0xffff0000u};     // red, green, blue
  const HitPoint p = point_of(mesh, {1, 2, 3}, {0, 0, -1});  // weights 1/4, 1/4, 1/2
  EXPECT_EQ(p.uv.x, 0.25f);
  EXPECT_EQ(p.uv.y, 10.0f);
  expect_vector(p.color, 0.25f, 0.25f, 0.5f);
  expect_vector(p.ng, 0, 0, 1);
  EXPECT_TRUE(p.front);
  expect_vector(p.outside, 1, 2, 4 * 0x1p-19f + 4 * 0x1p-19f);  // m = L = 4
  expect_vector(p.inside, 1, 2, -4 * 0x1p-18f);
}

TEST(HitPoint, NormalsTurnTowardsTheRay) {
  Mesh mesh = plane();
  mesh.normals.assign(3, {3, 0, 4});
  const HitPoint front = point_of(mesh, {1, 1, 3}, {0, 0, -1});
  expect_vector(front.ns, 3 * (1.0f / 5), 0, 4 * (1.0f / 5));
  const HitPoint back = point_of(mesh, {1, 1, -3}, {0, 0, 1});
  EXPECT_FALSE(back.front);
  expect_vector(back.ng, 0, 0, -1);
  expect_vector(back.ns, -3 * (1.0f / 5), 0, -4 * (1.0f / 5));
  EXPECT_LT(back.outside.z, 0);
  EXPECT_GT(back.inside.z, 0);
}

TEST(HitPoint, ZeroNormalsFallBackToTheTriangle) {
  const HitPoint p = point_of(plane(), {1, 1, -3}, {0, 0, 1});
  expect_vector(p.ns, 0, 0, -1);
}

TEST(HitPoint, NormalSurvivesAnyScale) {
  for (const float scale : {0x1p-60f, 0x1p-130f, 0x1p55f}) {  // unscaled, the cross product would be 0 or overflow
    Mesh mesh;
    add_triangle(mesh, {0, 0, 0}, {scale, 0, 0}, {0, scale, 0});
    expect_vector(hit_point(mesh, 0, {0, 0, -1}, {1, 0.25f, 0.25f, 1}).ng, 0, 0, 1);
  }
}

TEST(HitPoint, DegenerateTriangleFacesTheRay) {
  Mesh mesh;
  add_triangle(mesh, {0, 0, 0}, {1, 0, 0}, {2, 0, 0});
  const HitPoint p = hit_point(mesh, 0, {0, 0, -1}, {1, 0.25f, 0.25f, 1});
  expect_vector(p.ng, 0, 0, 1);
  EXPECT_TRUE(p.front);
}

TEST(Light, Directional) {
  traces::Light light;
  light.kind = traces::LightKind::directional;
  light.direction = {0, -1, 0};
  light.color = {1, 2, 3};
  LightSample<float> s;
  ASSERT_TRUE(sample_light(light, {5, 5, 5}, s));
  expect_vector(s.towards, 0, 1, 0);
  expect_vector(s.shadow, 0, 1, 0);
  expect_vector(s.intensity, 1, 2, 3);
  EXPECT_EQ(s.tmax, 0x1p100f);
}

TEST(Light, PointFallsWithTheSquareAndEndsAtItsRange) {
  traces::Light light;
  light.position = {0, 4, 0};
  light.color = {32, 16, 8};
  LightSample<float> s;
  ASSERT_TRUE(sample_light(light, {0, 0, 0}, s));
  expect_vector(s.towards, 0, 1, 0);
  expect_vector(s.shadow, 0, 4, 0);
  expect_vector(s.intensity, 2, 1, 0.5f);
  EXPECT_EQ(s.tmax, 1.0f);
  light.range = 4;
  EXPECT_TRUE(sample_light(light, {0, 0, 0}, s));  // at the range itself
  light.range = 3.99f;
  EXPECT_FALSE(sample_light(light, {0, 0, 0}, s));
  light.range = 1e15f;
  EXPECT_FALSE(sample_light(light, {0, 4, 0}, s));  // at the light
  EXPECT_TRUE(sample_light(light, {0x1p-50f, 4, 0}, s));
  EXPECT_FALSE(sample_light(light, {0x1.8p-51f, 4, 0}, s));
  EXPECT_FALSE(sample_light(light, {1e18f, 4, 0}, s));
}

TEST(Light, SpotFadesBetweenItsCones) {
  traces::Light light;
  light.kind = traces::LightKind::spot;
  light.position = {0, 0, 0};
  light.direction = {0, -1, 0};
  light.color = {100, 100, 100};
  light.cos_inner = 1;
  light.cos_outer = 0.5f;
  LightSample<float> s;
  ASSERT_TRUE(sample_light(light, {0, -10, 0}, s));  // on the axis: full
  EXPECT_EQ(s.intensity.x, 100 * (1.0f / 100));
  ASSERT_TRUE(sample_light(light, {3, -4, 0}, s));  // cos 0.8: (0.8 - 0.5) / 0.5 = 0.6, squared 0.36, / 25
  EXPECT_NEAR(s.intensity.x, 100 * 0.36 / 25, 1e-6);
  ASSERT_TRUE(sample_light(light, {4, -3, 0}, s));
  EXPECT_NEAR(s.intensity.x, 100 * 0.04 / 25, 1e-6);
  ASSERT_TRUE(sample_light(light, {4, 3, 0}, s));  // behind
  EXPECT_EQ(s.intensity.x, 0);
}

HitPoint floor_point(bool front) {
  HitPoint p{};
  p.ng = p.ns = {0, 1, 0};
  p.front = front;
  return p;
}

TEST(Contribution, LambertAndBlinnPhong) {
  const LightSample<float> light{{0, 1, 0}, {1, 0.5f, 0.25f}, {0, 1, 0}, 1};
  const Surface<float> diffuse{{0.5f, 0.5f, 0.5f}, {}, {}, {}};
  Triple<float> c;
  ASSERT_TRUE(contribution(light, floor_point(true), {0, -1, 0}, diffuse, 5, {2, 2, 2}, c));
  expect_vector(c, 1, 0.5f, 0.25f);
  const Surface<float> shiny{{}, {}, {1, 1, 1}, {}};
  ASSERT_TRUE(contribution(light, floor_point(true), {0, -1, 0}, shiny, 5, {1, 1, 1}, c));
  expect_vector(c, 1, 0.5f, 0.25f);  // h = N
  // The ray comes from 120 degrees off the light: h is at 60 degrees to N, its cosine 1/2.
  const Vec3 d{-0.8660254f, 0.5f, 0};
  ASSERT_TRUE(contribution(light, floor_point(true), d, shiny, 0, {1, 1, 1}, c));
  EXPECT_NEAR(c.x, 0.5f, 1e-6);
  ASSERT_TRUE(contribution(light, floor_point(true), d, shiny, 2, {1, 1, 1}, c));
  EXPECT_NEAR(c.x, 0.0625f, 1e-6);
}

TEST(Contribution, IsSkippedFromBelowAndWhereItIsBlack) {
  const Surface<float> diffuse{{1, 1, 1}, {}, {}, {}};
  const Surface<float> black{};
  Triple<float> c;
  const LightSample<float> below{{0, -1, 0}, {1, 1, 1}, {0, -1, 0}, 1}, above{{0, 1, 0}, {1, 1, 1}, {0, 1, 0}, 1};
  EXPECT_FALSE(contribution(below, floor_point(true), {0, -1, 0}, diffuse, 5, {1, 1, 1}, c));
  EXPECT_FALSE(contribution(above, floor_point(true), {0, -1, 0}, black, 5, {1, 1, 1}, c));
  HitPoint bent = floor_point(true);
  bent.ng = {0, -1, 0};  // above by the shading normal only
  EXPECT_FALSE(contribution(above, bent, {0, -1, 0}, diffuse, 5, {1, 1, 1}, c));
  bent = floor_point(true);
  bent.ns = {0, -1, 0};
  EXPECT_FALSE(contribution(above, bent, {0, -1, 0}, diffuse, 5, {1, 1, 1}, c));
}

TEST(Surface, TintIsForSpecularAndMirror) {
  traces::Material m;
  m.diffuse = m.specular = m.mirror = m.transmission = {1, 1, 1};
  Surface<float> s = surface_of<float>(m, {0.5f, 0.25f, 0});
  expect_vector(s.kd, 0.5f, 0.25f, 0);
  expect_vector(s.kt, 0.5f, 0.25f, 0);
  expect_vector(s.ks, 1, 1, 1);
  expect_vector(s.kr, 1, 1, 1);
  m.tint = true;
  s = surface_of<float>(m, {0.5f, 0.25f, 0});
  expect_vector(s.ks, 0.5f, 0.25f, 0);
  expect_vector(s.kr, 0.5f, 0.25f, 0);
}

TEST(Scatter, AMirrorHasNoRefraction) {
  const Scatter<float> s = scatter<float>(floor_point(true), {0, -1, 0}, {0.5f, 0.25f, 0}, {}, 1.5f);
  expect_vector(s.reflection, 0.5f, 0.25f, 0);
  expect_vector(s.refraction, 0, 0, 0);
  expect_vector(reflected(floor_point(true), {0.6f, -0.8f, 0}), 0.6f, 0.8f, 0);
}

TEST(Scatter, NormalIncidenceOnGlass) {
  const Scatter<float> s = scatter<float>(floor_point(true), {0, -1, 0}, {}, {1, 1, 1}, 1.5f);
  const float r0 = (-0.5f / 2.5f) * (-0.5f / 2.5f);
  EXPECT_EQ(s.reflection.x, r0);
  EXPECT_EQ(s.refraction.x, 1 - r0);
  expect_vector(s.refracted, 0, -1, 0);
}

TEST(Scatter, Snell) {
  const Vec3 d{0.6f, -0.8f, 0};
  const Scatter<float> in = scatter<float>(floor_point(true), d, {}, {1, 1, 1}, 1.5f);
  EXPECT_NEAR(in.refracted.x, 0.4, 1e-6);  // sin 0.6 / 1.5
  EXPECT_NEAR(in.refracted.y, -std::sqrt(1 - 0.16), 1e-6);
  EXPECT_NEAR(in.reflection.x, 0.04 + 0.96 * std::pow(0.2, 5), 1e-6);
  const Scatter<float> out = scatter<float>(floor_point(false), d, {}, {1, 1, 1}, 1.5f);
  EXPECT_NEAR(out.refracted.x, 0.9, 1e-6);
  EXPECT_NEAR(out.reflection.x, 0.04 + 0.96 * std::pow(1 - std::sqrt(0.19), 5), 1e-6);  // the angle outside
  EXPECT_NEAR(out.refraction.x + out.reflection.x, 1, 1e-6);
}

TEST(Scatter, TotalInternalReflection) {
  const Scatter<float> s = scatter<float>(floor_point(false), {0.8f, -0.6f, 0}, {0.125f, 0, 0}, {0.5f, 0.5f, 1}, 1.5f);
  expect_vector(s.reflection, 0.625f, 0.5f, 1);
  expect_vector(s.refraction, 0, 0, 0);
  EXPECT_GT(scatter<float>(floor_point(true), {0.8f, -0.6f, 0}, {}, {1, 1, 1}, 1.5f).refraction.x,
            0.9f);  // not from outside
}

TEST(Scatter, SameIndexPassesStraight) {
  const Scatter<float> s = scatter<float>(floor_point(true), {0.6f, -0.8f, 0}, {}, {0.75f, 1, 1}, 1.0f);
  expect_vector(s.reflection, 0, 0, 0);
  expect_vector(s.refraction, 0.75f, 1, 1);
  EXPECT_NEAR(s.refracted.x, 0.6f, 1e-6);
}

TEST(Scatter, ABentShadingNormalCannotTurnARayToTheWrongSide) {
  HitPoint p = floor_point(true);
  p.ns = unit({0.99f, 0.1f, 0});
  const Vec3 d = unit({0.8f, -0.1f, 0});
  EXPECT_GT(dot(reflected(p, d), p.ng), 0);
  EXPECT_LT(dot(scatter<float>(p, d, {}, {1, 1, 1}, 1.5f).refracted, p.ng), 0);
}

// Secondary rays of a sphere: none may find the triangle that it leaves.
TEST(Scatter, SecondaryRaysLeaveTheirTriangle) {
  for (const float offset : {0.0f, 1000.0f}) {
    for (const bool smooth : {false, true}) {
      const Vec3 center{offset, offset, offset};
      const Mesh mesh = testing::icosphere(3, 1, center, smooth);
      const EmbreeDevice device;
      EmbreeScene scene(device);
      scene.set(mesh, 0);
      scene.build(1e-3 * (1 + offset));
      testing::Random random(5);
      int refracted_hits = 0;
      for (int i = 0; i < 5000; ++i) {
        const Vec3 origin = center + unit(random.point(1)) * 3;
        const Vec3 d = unit(center + random.point(0.55f) - origin);
        Hit hit;
        scene.closest(make_ray(origin, d), hit);
        ASSERT_GE(hit.id, 0);
        const HitPoint p = hit_point(mesh, static_cast<std::size_t>(hit.id), d, hit.at);
        ASSERT_TRUE(p.front);
        const Scatter<float> s = scatter<float>(p, d, {}, {1, 1, 1}, 1.5f);
        Hit next;
        scene.closest(make_ray(p.inside, s.refracted), next);
        ASSERT_GE(next.id, 0);
        ASSERT_NE(next.id, hit.id);
        ++refracted_hits;
        ASSERT_FALSE(scene.occluded(make_ray(p.outside, reflected(p, d))));  // convex
      }
      EXPECT_EQ(refracted_hits, 5000);
    }
  }
}

}  // namespace
}  // namespace artu::ref
