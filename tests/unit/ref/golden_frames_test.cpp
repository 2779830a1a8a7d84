// Whole frames against each other: moved, repeated, in full and selective.
#include <gtest/gtest.h>

#include "ref/golden.h"
#include "unit/ref/meshes.h"

namespace artu::ref {
namespace {

using traces::Frame;
using traces::Material;
using traces::Scene;

/// A perspective camera at `offset` + (0, 0, 4) towards -z, one sphere static and one dynamic.
void two_spheres(const Vec3& offset, Scene& scene, Frame& frame, std::uint32_t width, std::uint32_t height) {
  scene.width = width;
  scene.height = height;
  Material red, mirror;
  red.diffuse = {1, 0.25f, 0.25f};
  mirror.mirror = {0.5f, 0.5f, 0.5f};
  mirror.specular = {0.5f, 0.5f, 0.5f};
  scene.materials = {red, mirror};
  scene.static_geometry = testing::icosphere(3, 1, offset + Vec3{-0.75f, 0, 0}, true);
  frame.dynamic = testing::icosphere(3, 0.5f, offset + Vec3{0.5f, 0, 1}, false);
  frame.dynamic.materials.assign(frame.dynamic.triangle_count(), 1);
  const float w = static_cast<float>(width), h = static_cast<float>(height);
  frame.camera.origin = offset + Vec3{0, 0, 4};
  frame.camera.corner = {-0.5f * w, 0.5f * h, -w};
  frame.camera.du = {1, 0, 0};
  frame.camera.dv = {0, -1, 0};
  traces::Light light;
  light.position = offset + Vec3{4, 8, 4};
  light.color = {60, 60, 60};
  frame.lights = {light};
  frame.ambient = {0.1f, 0.1f, 0.1f};
  frame.sky_nadir = {0.1f, 0.1f, 0.1f};
  frame.sky_zenith = {0.3f, 0.5f, 0.9f};
}

TEST(Golden, HugeOffsetsShowTheSamePicture) {
  Scene at_origin, moved;
  Frame frame, frame_moved;
  two_spheres({}, at_origin, frame, 48, 40);
  two_spheres({4096, -4096, 8192}, moved, frame_moved, 48, 40);
  Settings settings;
  settings.selective = false;
  const Result a = Golden(at_origin, settings).render(frame), b = Golden(moved, settings).render(frame_moved);
  int different = 0, dynamic = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    different += a.pixels[i].hit_class != b.pixels[i].hit_class;
    dynamic += a.pixels[i].hit_class == HitClass::dynamic_geometry;
  }
  EXPECT_GT(dynamic, 100);
  EXPECT_LT(different, 10);  // the silhouettes only
}

TEST(Golden, FramesDoNotDependOnThoseBefore) {
  Scene scene;
  Frame near_frame, far_frame;
  two_spheres({}, scene, near_frame, 31, 17);
  far_frame = near_frame;
  far_frame.camera.origin.z = 4000;  // needs a wider padding
  far_frame.camera.corner.z *= 1000;
  const Golden golden(scene, {});
  const Result first = golden.render(near_frame), far_away = golden.render(far_frame),
               again = golden.render(near_frame);
  const Result alone = Golden(scene, {}).render(far_frame);
  for (std::size_t i = 0; i < first.pixels.size(); ++i) {
    EXPECT_EQ(first.pixels[i].t_bits, again.pixels[i].t_bits);
    EXPECT_EQ(first.pixels[i].primitive, again.pixels[i].primitive);
    EXPECT_EQ(first.pixels[i].r, again.pixels[i].r);
    EXPECT_EQ(far_away.pixels[i].primitive, alone.pixels[i].primitive);
    EXPECT_EQ(far_away.pixels[i].t_bits, alone.pixels[i].t_bits);
  }
}

TEST(Golden, SelectiveTracesFewerPrimaryRaysAndKeepsTheSamples) {
  Scene scene;
  Frame frame;
  two_spheres({}, scene, frame, 33, 21);
  Settings full;
  full.selective = false;
  const Result a = Golden(scene, full).render(frame), b = Golden(scene, {}).render(frame);
  EXPECT_EQ(a.rays.primary, 33u * 21u);
  std::uint64_t traced = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (b.pixels[i].decision == Decision::interpolated) {
      EXPECT_EQ(b.pixels[i].primitive, -1);
      EXPECT_EQ(b.pixels[i].t_bits, 0u);
      continue;
    }
    ++traced;
    EXPECT_EQ(a.pixels[i].r, b.pixels[i].r);
    EXPECT_EQ(a.pixels[i].t_bits, b.pixels[i].t_bits);
    EXPECT_EQ(a.pixels[i].hit_class, b.pixels[i].hit_class);
  }
  EXPECT_EQ(b.rays.primary, traced);
  EXPECT_LT(traced, 33u * 21u);
}

}  // namespace
}  // namespace artu::ref
