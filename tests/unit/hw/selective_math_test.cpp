// The integers of selective rendering (docs/selective-rendering.md): counts, differences, means.
#include "hw/datapath/selective.h"

#include <gtest/gtest.h>

namespace artu::hw::test {
namespace {

constexpr HitClass none = HitClass::none, miss = HitClass::miss, fixed = HitClass::static_geometry,
                   moving = HitClass::dynamic_geometry;

Ring ring(const std::array<HitClass, 8>& classes) {
  Ring ring;
  for (std::size_t i = 0; i < 8; ++i) ring[i].hit_class = classes[i];
  return ring;
}

TEST(SelectiveMath, OnlyStaticAndDynamicHitsCount) {
  const HitCounts counts = count_hits(ring({none, miss, fixed, moving, moving, fixed, moving, none}));
  EXPECT_EQ(counts.n_static, 2);
  EXPECT_EQ(counts.n_dynamic, 3);
  EXPECT_EQ(count_hits({}).n_static + count_hits({}).n_dynamic, 0);
  EXPECT_EQ(count_hits(ring({moving, moving, moving, moving, moving, moving, moving, moving})).n_dynamic, 8);
  EXPECT_EQ(count_hits(ring({fixed, fixed, fixed, fixed, fixed, fixed, fixed, fixed})).n_static, 8);
}

TEST(SelectiveMath, ByMaxChannelTheDifferenceIsThatOfTheWorstChannel) {
  EXPECT_EQ(color_difference(Metric::max_channel, {10, 20, 30}, {10, 20, 30}), 0);
  EXPECT_EQ(color_difference(Metric::max_channel, {10, 20, 30}, {13, 10, 31}), 10);
  EXPECT_EQ(color_difference(Metric::max_channel, {0, 20, 0}, {255, 20, 0}), 255);
  EXPECT_EQ(color_difference(Metric::max_channel, {1, 2, 200}, {3, 4, 5}), 195);
}

TEST(SelectiveMath, BySumItIsThatOfAllChannels) {
  EXPECT_EQ(color_difference(Metric::sum, {10, 20, 30}, {10, 20, 30}), 0);
  EXPECT_EQ(color_difference(Metric::sum, {10, 20, 30}, {13, 10, 31}), 14);
  EXPECT_EQ(color_difference(Metric::sum, {0, 255, 0}, {255, 0, 255}), 765);
}

TEST(SelectiveMath, ByLumaItIsThatOfTheRoundedBrightness) {
  EXPECT_EQ(color_difference(Metric::luma, {0, 0, 0}, {255, 255, 255}), 255);
  EXPECT_EQ(color_difference(Metric::luma, {255, 0, 0}, {0, 0, 0}), 77);  // 77 * 255 + 128 >> 8
  EXPECT_EQ(color_difference(Metric::luma, {0, 0, 0}, {0, 255, 0}), 149);
  EXPECT_EQ(color_difference(Metric::luma, {0, 0, 255}, {0, 0, 0}), 29);
  EXPECT_EQ(color_difference(Metric::luma, {1, 0, 0}, {0, 0, 0}), 0);  // 205 >> 8
  EXPECT_EQ(color_difference(Metric::luma, {2, 0, 0}, {0, 0, 0}), 1);  // 282 >> 8
}

Pairs pairs(std::uint8_t count, Rgb a, Rgb b, Rgb c = {}, Rgb d = {}) { return {count, {{{{a, b}}, {{c, d}}}}}; }

TEST(SelectiveMath, TheDifferenceOfPairsIsTheirSum) {
  const Rgb a{10, 0, 0}, b{40, 0, 0}, c{0, 7, 0}, d{0, 0, 0};
  EXPECT_EQ(color_difference(Metric::max_channel, pairs(0, a, b, c, d)), -1);
  EXPECT_EQ(color_difference(Metric::max_channel, pairs(1, a, b, c, d)), 30);
  EXPECT_EQ(color_difference(Metric::max_channel, pairs(2, a, b, c, d)), 37);
  const Rgb black{0, 0, 0}, white{255, 255, 255};
  EXPECT_EQ(color_difference(Metric::sum, pairs(2, black, white, white, black)), 2 * 765);
}

TEST(SelectiveMath, TheMeanOfTwoIsRoundedUp) {
  for (int p = 0; p < 256; ++p) {
    for (int q = 0; q < 256; ++q) {
      const auto a = static_cast<std::uint8_t>(p), b = static_cast<std::uint8_t>(q);
      const Rgb mean = interpolate(pairs(1, {a, b, a}, {b, a, a}));
      ASSERT_EQ(mean.r, (p + q) / 2 + (p + q) % 2);
      ASSERT_EQ(mean.g, mean.r);
      ASSERT_EQ(mean.b, p);
    }
  }
}

TEST(SelectiveMath, TheMeanOfFourIsRoundedHalfUp) {
  const auto mean = [](std::uint8_t a, std::uint8_t b, std::uint8_t c, std::uint8_t d) {
    return static_cast<int>(interpolate(pairs(2, {0, a, 9}, {0, b, 9}, {0, c, 9}, {0, d, 9})).g);
  };
  EXPECT_EQ(mean(0, 0, 0, 1), 0);
  EXPECT_EQ(mean(0, 0, 1, 1), 1);
  EXPECT_EQ(mean(1, 1, 1, 0), 1);
  EXPECT_EQ(mean(10, 20, 30, 41), 25);
  EXPECT_EQ(mean(255, 255, 255, 255), 255);
}

}  // namespace
}  // namespace artu::hw::test
