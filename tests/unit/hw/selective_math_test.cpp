// The integers of selective rendering (docs/selective-rendering.md): counts, threshold, difference, mean.
#include "hw/datapath/selective.h"

#include <gtest/gtest.h>

namespace artu::hw::test {
namespace {

constexpr HitClass none = HitClass::none, miss = HitClass::miss, fixed = HitClass::static_geometry,
                   moving = HitClass::dynamic_geometry;

TEST(SelectiveMath, OnlyStaticAndDynamicHitsCount) {
  const HitCounts counts = count_hits({none, miss, fixed, moving, moving, fixed, moving, none});
  EXPECT_EQ(counts.n_static, 2);
  EXPECT_EQ(counts.n_dynamic, 3);
  EXPECT_EQ(count_hits({}).n_static + count_hits({}).n_dynamic, 0);
  EXPECT_EQ(count_hits({moving, moving, moving, moving, moving, moving, moving, moving}).n_dynamic, 8);
  EXPECT_EQ(count_hits({fixed, fixed, fixed, fixed, fixed, fixed, fixed, fixed}).n_static, 8);
}

/// Thresholds for n_dynamic - n_static = -8 ... 8.
std::vector<int> thresholds(const SelectiveConfig& config) {
  std::vector<int> result;
  for (int excess = -8; excess <= 8; ++excess) {
    HitCounts counts;
    counts.n_dynamic = static_cast<std::uint8_t>(excess > 0 ? excess : 0);
    counts.n_static = static_cast<std::uint8_t>(excess < 0 ? -excess : 0);
    result.push_back(adjusted_threshold(config, counts));
  }
  return result;
}

SelectiveConfig with(Magnitude magnitude, std::uint32_t reference, std::uint32_t step) {
  SelectiveConfig config;
  config.magnitude = magnitude;
  config.reference = reference;
  config.step = step;
  return config;
}

TEST(SelectiveMath, AFixedMoveDoesNotDependOnTheDifference) {
  EXPECT_EQ(thresholds(with(Magnitude::fixed, 16, 5)),
            (std::vector<int>{21, 21, 21, 21, 21, 21, 21, 21, 16, 11, 11, 11, 11, 11, 11, 11, 11}));
}

TEST(SelectiveMath, AProportionalMoveGrowsWithTheDifference) {
  EXPECT_EQ(thresholds(with(Magnitude::proportional, 16, 2)),
            (std::vector<int>{32, 30, 28, 26, 24, 22, 20, 18, 16, 14, 12, 10, 8, 6, 4, 2, 0}));
}

TEST(SelectiveMath, AProgressiveMoveIsThatOfTheTable) {
  SelectiveConfig config = with(Magnitude::progressive, 100, 77);
  config.table = {1, 2, 4, 8, 16, 32, 64, 90};
  EXPECT_EQ(thresholds(config),
            (std::vector<int>{190, 164, 132, 116, 108, 104, 102, 101, 100, 99, 98, 96, 92, 84, 68, 36, 10}));
}

TEST(SelectiveMath, TheResultIsClamped) {
  SelectiveConfig config = with(Magnitude::proportional, 16, 4);
  config.minimum = 6;
  config.maximum = 30;
  EXPECT_EQ(thresholds(config), (std::vector<int>{30, 30, 30, 30, 30, 28, 24, 20, 16, 12, 8, 6, 6, 6, 6, 6, 6}));
  config = with(Magnitude::proportional, 250, 255);
  EXPECT_EQ(thresholds(config).front(), 255);
  EXPECT_EQ(thresholds(config).back(), 0);
}

TEST(SelectiveMath, BothKindsOfHitsOffsetEachOther) {
  const SelectiveConfig config = with(Magnitude::proportional, 16, 2);
  EXPECT_EQ(adjusted_threshold(config, {4, 4}), 16);
  EXPECT_EQ(adjusted_threshold(config, {1, 4}), 10);
  EXPECT_EQ(adjusted_threshold(config, {5, 2}), 22);
}

TEST(SelectiveMath, WithoutAdaptionItIsTheReferenceClampedLikewise) {
  SelectiveConfig config = with(Magnitude::proportional, 16, 2);
  config.adaptive = false;
  EXPECT_EQ(thresholds(config), std::vector<int>(17, 16));
  config.maximum = 9;
  EXPECT_EQ(thresholds(config), std::vector<int>(17, 9));
  config.maximum = 255;
  config.minimum = 20;
  EXPECT_EQ(thresholds(config), std::vector<int>(17, 20));
}

TEST(SelectiveMath, TheColourDifferenceIsThatOfTheWorstChannel) {
  EXPECT_EQ(color_difference({10, 20, 30}, {10, 20, 30}), 0);
  EXPECT_EQ(color_difference({10, 20, 30}, {13, 10, 31}), 10);
  EXPECT_EQ(color_difference({0, 20, 0}, {255, 20, 0}), 255);
  EXPECT_EQ(color_difference({1, 2, 200}, {3, 4, 5}), 195);
}

TEST(SelectiveMath, TheMeanIsRoundedUp) {
  for (int p = 0; p < 256; ++p) {
    for (int q = 0; q < 256; ++q) {
      const auto a = static_cast<std::uint8_t>(p), b = static_cast<std::uint8_t>(q);
      const Rgb mean = interpolate({a, b, a}, {b, a, a});
      ASSERT_EQ(mean.r, (p + q) / 2 + (p + q) % 2);
      ASSERT_EQ(mean.g, mean.r);
      ASSERT_EQ(mean.b, p);
    }
  }
}

}  // namespace
}  // namespace artu::hw::test
