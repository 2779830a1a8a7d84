// The sRGB tables and the texture filter (docs/arithmetic.md sections 6 and 8), against the formulas in long double.
#include "hw/datapath/color.h"

#include <gtest/gtest.h>

#include <limits>

#include "hw/datapath/texture.h"

namespace artu::hw::test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

long double curve(long double c) { return c <= 0.04045L ? c / 12.92L : std::pow((c + 0.055L) / 1.055L, 2.4L); }

TEST(Color, DecodeIsTheNearestToTheCurve) {
  for (std::uint32_t code = 0; code < 256; ++code) {
    ASSERT_EQ(decode(code), static_cast<float>(curve(static_cast<long double>(code) / 255))) << code;
  }
  EXPECT_EQ(decode(255), 1.0f);
}

TEST(Color, EncodeStepsAtTheSmallestFloatNotBelowTheHalfWayCode) {
  for (int code = 1; code < 256; ++code) {
    const long double exact = curve((static_cast<long double>(code) - 0.5L) / 255);
    auto threshold = static_cast<float>(exact);
    if (static_cast<long double>(threshold) < exact) threshold = std::nextafter(threshold, infinity);
    ASSERT_EQ(encode(threshold), code);
    ASSERT_EQ(encode(std::nextafter(threshold, 0.0f)), code - 1);
  }
}

TEST(Color, EncodeIsTheInverseOfDecode) {
  for (std::uint32_t code = 0; code < 256; ++code) ASSERT_EQ(encode(decode(code)), code);
}

TEST(Color, EncodeTakesAnyNumber) {
  EXPECT_EQ(encode(-1.0f), 0);
  EXPECT_EQ(encode(-0.0f), 0);
  EXPECT_EQ(encode(std::numeric_limits<float>::quiet_NaN()), 0);
  EXPECT_EQ(encode(1.0f), 255);
  EXPECT_EQ(encode(1e30f), 255);
  EXPECT_EQ(encode(infinity), 255);
  EXPECT_EQ(encode(-infinity), 0);
}

struct Texel {
  std::uint32_t first, second;
  float weight;
};

/// Along u of a texture of `width` texels; along v the same, checked by the way.
Texel at(TextureWrap wrap, std::uint32_t width, float u) {
  MaterialRecord material{};
  material.width = material.height = width;
  material.wrap_u = material.wrap_v = wrap;
  const TextureFootprint f = footprint(material, u, u);
  EXPECT_EQ(f.x[0], f.y[0]);
  EXPECT_EQ(f.x[1], f.y[1]);
  EXPECT_EQ(f.a_u, f.a_v);
  return {f.x[0], f.x[1], f.a_u};
}

void expect_texel(Texel t, std::uint32_t first, std::uint32_t second, float weight) {
  EXPECT_EQ(t.first, first);
  EXPECT_EQ(t.second, second);
  EXPECT_EQ(t.weight, weight);
}

TEST(Texture, InsideAllWrapsAreTheSame) {
  for (TextureWrap wrap : {TextureWrap::repeat, TextureWrap::clamp, TextureWrap::mirror}) {
    expect_texel(at(wrap, 4, 0.375f), 1, 2, 0.0f);  // the centre of texel 1
    expect_texel(at(wrap, 4, 0.5f), 1, 2, 0.5f);
    expect_texel(at(wrap, 8, 0.53125f), 3, 4, 0.75f);
  }
}

TEST(Texture, RepeatGoesRound) {
  expect_texel(at(TextureWrap::repeat, 4, 0.0f), 3, 0, 0.5f);
  expect_texel(at(TextureWrap::repeat, 4, 0.96875f), 3, 0, 0.375f);
  expect_texel(at(TextureWrap::repeat, 4, 2.375f), 1, 2, 0.0f);
  expect_texel(at(TextureWrap::repeat, 4, -0.125f), 3, 0, 0.0f);
  expect_texel(at(TextureWrap::repeat, 1, 0.25f), 0, 0, 0.75f);
}

TEST(Texture, ClampStaysAtTheEdge) {
  expect_texel(at(TextureWrap::clamp, 4, -3.0f), 0, 0, 0.5f);
  expect_texel(at(TextureWrap::clamp, 4, 0.0f), 0, 0, 0.5f);
  expect_texel(at(TextureWrap::clamp, 4, 7.0f), 3, 3, 0.5f);
}

TEST(Texture, MirrorGoesBack) {
  expect_texel(at(TextureWrap::mirror, 4, 1.625f), 1, 2, 0.0f);  // as 0.375
  expect_texel(at(TextureWrap::mirror, 4, -0.375f), 1, 2, 0.0f);
  expect_texel(at(TextureWrap::mirror, 4, 2.375f), 1, 2, 0.0f);
  expect_texel(at(TextureWrap::mirror, 4, 1.0f), 3, 3, 0.5f);
}

TEST(Texture, TheFilterWeighsInLinearLight) {
  TextureFootprint f{};
  f.a_u = 0.25f;
  f.a_v = 0.5f;
  // Red: 0, 255 above; 255, 255 below.  Green: 0 everywhere.  Blue: 188 everywhere.  Alpha is not looked at.
  const std::array<std::uint32_t, 4> texels{0x00bc0000u, 0xffbc00ffu, 0x12bc00ffu, 0x00bc00ffu};
  const Vector color = filter(f, texels);
  EXPECT_EQ(color.x, 0.25f + (1.0f - 0.25f) * 0.5f);
  EXPECT_EQ(color.y, 0.0f);
  EXPECT_EQ(color.z, decode(188));
}

TEST(Texture, TilesOfSixteenTexelsAreLines) {
  EXPECT_EQ(texel_address(4096, 10, 0, 0), 4096u);
  EXPECT_EQ(texel_address(4096, 10, 3, 3), 4096u + 60);
  EXPECT_EQ(texel_address(4096, 10, 4, 0), 4096u + 64);
  EXPECT_EQ(texel_address(4096, 10, 9, 1), 4096u + 2 * 64 + 5 * 4);
  EXPECT_EQ(texel_address(4096, 10, 0, 4), 4096u + 3 * 64) << "a row of tiles is three wide, the last one cut";
}

}  // namespace
}  // namespace artu::hw::test
