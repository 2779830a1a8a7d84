#include "ref/color.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace artu::ref {
namespace {

TEST(Srgb, EncodeInvertsDecode) {
  for (int c = 0; c < 256; ++c) {
    const auto code = static_cast<std::uint8_t>(c);
    EXPECT_EQ(srgb().encode(srgb().decode(code)), code);
  }
}

TEST(Srgb, BothTablesRise) {
  for (int c = 1; c < 256; ++c) {
    EXPECT_LT(srgb().linear[c - 1], srgb().linear[c]);
    EXPECT_LT(srgb().threshold[c - 1], srgb().threshold[c]);
    EXPECT_LT(srgb().linear[c - 1], srgb().threshold[c]);
    EXPECT_LT(srgb().threshold[c], srgb().linear[c]);
  }
}

TEST(Srgb, KnownValues) {
  EXPECT_EQ(srgb().decode(0), 0.0f);
  EXPECT_EQ(srgb().decode(255), 1.0f);
  EXPECT_EQ(srgb().decode(10), static_cast<float>(10.0 / (255.0 * 12.92)));
  EXPECT_NEAR(srgb().decode(11), 0.00334654, 1e-8);  // the first on the power branch
  EXPECT_NEAR(srgb().decode(128), 0.21586050, 1e-8);
  EXPECT_EQ(srgb().encode(0.5f), 188);
  EXPECT_EQ(srgb().encode(0.18f), 118);
}

// The inverse curve decides, not the one that the tables are computed from.
long double code_of(long double x) {
  return 255 * (x <= 0.0031308L ? 12.92L * x : 1.055L * std::pow(x, 1 / 2.4L) - 0.055L);
}

TEST(Srgb, ThresholdsAreTheSmallestThatRoundUp) {
  for (int c = 1; c < 256; ++c) {
    const float at = srgb().threshold[c], before = std::nextafter(at, 0.0f);
    EXPECT_EQ(srgb().encode(at), c);
    EXPECT_EQ(srgb().encode(before), c - 1);
    EXPECT_GE(code_of(at), c - 0.5L - 1e-15L) << c;
    EXPECT_LT(code_of(before), c - 0.5L) << c;
  }
}

TEST(Srgb, DecodeIsTheNearest) {
  for (int c = 1; c < 255; ++c) {
    const float at = srgb().linear[c];
    const auto middle = [&](float neighbour) { return (static_cast<long double>(at) + neighbour) / 2; };
    EXPECT_LE(code_of(middle(std::nextafter(at, 0.0f))), c + 1e-14L) << c;
    EXPECT_GE(code_of(middle(std::nextafter(at, 1.0f))), c - 1e-14L) << c;
  }
}

TEST(Srgb, EncodesWhatIsNotAColour) {
  EXPECT_EQ(srgb().encode(-1.0f), 0);
  EXPECT_EQ(srgb().encode(-0.0f), 0);
  EXPECT_EQ(srgb().encode(1e30f), 255);
  EXPECT_EQ(srgb().encode(std::numeric_limits<float>::infinity()), 255);
  EXPECT_EQ(srgb().encode(std::nanf("")), 0);
}

}  // namespace
}  // namespace artu::ref
