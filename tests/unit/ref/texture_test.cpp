#include "ref/texture.h"

#include <gtest/gtest.h>

#include "ref/color.h"

namespace artu::ref {
namespace {

using traces::Wrap;

void expect_tap(float u, std::uint32_t n, Wrap wrap, int first, int second, float weight) {
  const Tap t = tap(u, n, wrap);
  EXPECT_EQ(t.first, first) << u;
  EXPECT_EQ(t.second, second) << u;
  EXPECT_EQ(t.weight, weight) << u;
}

TEST(Tap, Repeat) {
  expect_tap(0.375f, 4, Wrap::repeat, 1, 2, 0);  // the centre of texel 1
  expect_tap(0, 4, Wrap::repeat, 3, 0, 0.5f);
  expect_tap(1, 4, Wrap::repeat, 3, 0, 0.5f);
  expect_tap(-0.125f, 4, Wrap::repeat, 3, 0, 0);
  expect_tap(2.9375f, 4, Wrap::repeat, 3, 0, 0.25f);
  expect_tap(-1e-10f, 4, Wrap::repeat, 3, 0, 0.5f);  // u - floor(u) rounds to 1
  expect_tap(1048576, 4, Wrap::repeat, 3, 0, 0.5f);
}

TEST(Tap, Clamp) {
  expect_tap(0, 4, Wrap::clamp, 0, 0, 0.5f);
  expect_tap(-7, 4, Wrap::clamp, 0, 0, 0.5f);
  expect_tap(1, 4, Wrap::clamp, 3, 3, 0.5f);
  expect_tap(7, 4, Wrap::clamp, 3, 3, 0.5f);
  expect_tap(0.5f, 4, Wrap::clamp, 1, 2, 0.5f);
}

TEST(Tap, Mirror) {
  expect_tap(-0.25f, 4, Wrap::mirror, 0, 1, 0.5f);  // as 0.25
  expect_tap(1.25f, 4, Wrap::mirror, 2, 3, 0.5f);   // as 0.75
  expect_tap(2.25f, 4, Wrap::mirror, 0, 1, 0.5f);
  expect_tap(1, 4, Wrap::mirror, 3, 3, 0.5f);
  expect_tap(2, 4, Wrap::mirror, 0, 0, 0.5f);
  expect_tap(-1e-10f, 4, Wrap::mirror, 0, 0, 0.5f);  // g rounds to 2
}

TEST(Tap, OneTexel) {
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror}) {
    for (const float u : {-0.75f, 0.0f, 0.25f, 0.5f, 1.0f, 1.75f}) {
      const Tap t = tap(u, 1, wrap);
      EXPECT_EQ(t.first, 0);
      EXPECT_EQ(t.second, 0);
    }
  }
}

TEST(Sample, BlendsInLinearLight) {
  traces::Texture texture;
  texture.width = 2;
  texture.height = 2;
  texture.wrap_u = texture.wrap_v = Wrap::clamp;
  texture.rgba = {0, 0, 0, 9, 255, 0, 0, 9, 0, 255, 0, 9, 255, 255, 128, 9};
  const Triple<float> middle = sample<float>(texture, {0.5f, 0.5f});
  EXPECT_EQ(middle.x, 0.5f);  // 188 in sRGB, not 128
  EXPECT_EQ(middle.y, 0.5f);
  EXPECT_EQ(middle.z, srgb().decode(128) * 0.25f);
  EXPECT_EQ(sample<float>(texture, {1, 0}).x, 1.0f);  // row 0 first
  EXPECT_EQ(sample<float>(texture, {1, 0}).y, 0.0f);
  EXPECT_EQ(sample<float>(texture, {0, 1}).y, 1.0f);
  EXPECT_EQ(sample<float>(texture, {0.375f, 0}).x, 0.25f);
}

TEST(Sample, WrapsEachAxisByItsOwnMode) {
  traces::Texture texture;
  texture.width = 2;
  texture.height = 1;
  texture.wrap_u = Wrap::repeat;
  texture.wrap_v = Wrap::clamp;
  texture.rgba = {0, 0, 0, 0, 255, 255, 255, 0};
  EXPECT_EQ(sample<float>(texture, {0, 5}).x, 0.5f);
  texture.wrap_u = Wrap::mirror;
  EXPECT_EQ(sample<float>(texture, {0, 5}).x, 0.0f);
}

}  // namespace
}  // namespace artu::ref
