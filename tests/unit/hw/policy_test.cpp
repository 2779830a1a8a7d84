// The policies, each row of docs/selective-rendering.md, and the registry that knows them by their files' names.
#include "hw/selective/policy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>

namespace artu::hw::test {
namespace {

namespace fs = std::filesystem;

std::uint32_t number_of(const std::string& name) {
  const auto& names = policy_names();
  const auto found = std::find(names.begin(), names.end(), name);
  EXPECT_NE(found, names.end()) << name;
  return static_cast<std::uint32_t>(found - names.begin());
}

int threshold(const char* name, const SelectiveConfig& config, HitCounts counts) {
  Evidence evidence;
  evidence.counts = counts;
  return policy(number_of(name)).threshold(evidence, config);
}

TEST(Policies, AreTheFilesOfTheirFolderWithTheDefaultFirst) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(fs::path(ARTU_SOURCE_DIR) / "hw/selective/policies")) {
    files.push_back(entry.path().stem().string());
  }
  const std::vector<std::string> names(policy_names().begin(), policy_names().end());
  EXPECT_THAT(names, ::testing::UnorderedElementsAreArray(files));
  EXPECT_EQ(names[SelectiveConfig().policy], "attention");
  EXPECT_TRUE(std::is_sorted(names.begin() + 1, names.end()));
}

TEST(Policies, HaveALatencyAndNoState) {
  std::mt19937 random(1);
  for (std::uint32_t number = 0; number < policy_names().size(); ++number) {
    const Policy& p = policy(number);
    EXPECT_GE(p.latency, 1u) << policy_names()[number];
    std::vector<Evidence> evidences(50);
    std::vector<int> first;
    for (Evidence& e : evidences) {
      e.counts = {static_cast<std::uint8_t>(random() % 5), static_cast<std::uint8_t>(random() % 5)};
      e.pairs.count = static_cast<std::uint8_t>(random() % 3);
      for (auto& pair : e.pairs.color) pair[0].r = static_cast<std::uint8_t>(random());
      first.push_back(p.threshold(e, {}));
    }
    for (std::size_t i = evidences.size(); i-- > 0;) {
      EXPECT_EQ(p.threshold(evidences[i], {}), first[i]) << policy_names()[number];
    }
  }
}

/// Thresholds for n_dynamic - n_static = -8 ... 8.
std::vector<int> thresholds(const SelectiveConfig& config) {
  std::vector<int> result;
  for (int excess = -8; excess <= 8; ++excess) {
    HitCounts counts;
    counts.n_dynamic = static_cast<std::uint8_t>(excess > 0 ? excess : 0);
    counts.n_static = static_cast<std::uint8_t>(excess < 0 ? -excess : 0);
    result.push_back(threshold("attention", config, counts));
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

TEST(Attention, AFixedMoveDoesNotDependOnTheDifference) {
  EXPECT_EQ(thresholds(with(Magnitude::fixed, 16, 5)),
            (std::vector<int>{21, 21, 21, 21, 21, 21, 21, 21, 16, 11, 11, 11, 11, 11, 11, 11, 11}));
}

TEST(Attention, AProportionalMoveGrowsWithTheDifference) {
  EXPECT_EQ(thresholds(with(Magnitude::proportional, 16, 2)),
            (std::vector<int>{32, 30, 28, 26, 24, 22, 20, 18, 16, 14, 12, 10, 8, 6, 4, 2, 0}));
}

TEST(Attention, AProgressiveMoveIsThatOfTheTable) {
  SelectiveConfig config = with(Magnitude::progressive, 100, 77);
  config.table = {1, 2, 4, 8, 16, 32, 64, 90};
  EXPECT_EQ(thresholds(config),
            (std::vector<int>{190, 164, 132, 116, 108, 104, 102, 101, 100, 99, 98, 96, 92, 84, 68, 36, 10}));
}

TEST(Attention, TheResultIsClamped) {
  SelectiveConfig config = with(Magnitude::proportional, 16, 4);
  config.minimum = 6;
  config.maximum = 30;
  EXPECT_EQ(thresholds(config), (std::vector<int>{30, 30, 30, 30, 30, 28, 24, 20, 16, 12, 8, 6, 6, 6, 6, 6, 6}));
  config = with(Magnitude::proportional, 250, 255);
  EXPECT_EQ(thresholds(config).front(), 255);
  EXPECT_EQ(thresholds(config).back(), 0);
}

TEST(Attention, BothKindsOfHitsOffsetEachOther) {
  const SelectiveConfig config = with(Magnitude::proportional, 16, 2);
  EXPECT_EQ(threshold("attention", config, {4, 4}), 16);
  EXPECT_EQ(threshold("attention", config, {1, 4}), 10);
  EXPECT_EQ(threshold("attention", config, {5, 2}), 22);
}

TEST(Attention, WithoutAdaptionItIsTheReferenceClampedLikewise) {
  SelectiveConfig config = with(Magnitude::proportional, 16, 2);
  config.adaptive = false;
  EXPECT_EQ(thresholds(config), std::vector<int>(17, 16));
  config.maximum = 9;
  EXPECT_EQ(thresholds(config), std::vector<int>(17, 9));
  config.maximum = 255;
  config.minimum = 20;
  EXPECT_EQ(thresholds(config), std::vector<int>(17, 20));
}

/// Thresholds for the counts 0 ... 8, the other class being 3 where it is not looked at.
std::vector<int> against_reference(Count count, std::uint32_t reference_count, Magnitude magnitude) {
  SelectiveConfig config = with(magnitude, 100, 4);
  config.compare = Compare::reference_count;
  config.count = count;
  config.reference_count = reference_count;
  std::vector<int> result;
  for (int n = 0; n <= 8; ++n) {
    const auto dynamic = static_cast<std::uint8_t>(count == Count::merged ? n / 2 : n);
    const auto fixed = static_cast<std::uint8_t>(count == Count::merged ? n - n / 2 : 3);
    result.push_back(threshold("attention", config, {fixed, dynamic}));
  }
  return result;
}

TEST(Attention, AgainstAReferenceCountOnlyDynamicHitsCountOrAllOfThem) {
  const std::vector<int> expected{108, 104, 100, 96, 92, 88, 84, 80, 76};
  EXPECT_EQ(against_reference(Count::per_class, 2, Magnitude::proportional), expected);
  EXPECT_EQ(against_reference(Count::merged, 2, Magnitude::proportional), expected);
}

TEST(Attention, TheReferenceCountMayBeAnything) {
  EXPECT_EQ(against_reference(Count::merged, 0, Magnitude::proportional),
            (std::vector<int>{100, 96, 92, 88, 84, 80, 76, 72, 68}));
  EXPECT_EQ(against_reference(Count::per_class, 8, Magnitude::fixed),
            (std::vector<int>{104, 104, 104, 104, 104, 104, 104, 104, 100}));
  EXPECT_EQ(against_reference(Count::merged, 8, Magnitude::progressive),
            (std::vector<int>{129, 122, 116, 111, 107, 104, 102, 101, 100}));
}

TEST(Fixed, IsAttentionWithoutAdaption) {
  for (std::uint32_t reference : {0u, 5u, 16u, 255u}) {
    SelectiveConfig config = with(Magnitude::proportional, reference, 9);
    config.minimum = 4;
    config.maximum = 200;
    for (std::uint8_t n = 0; n <= 8; ++n) {
      config.adaptive = true;
      const int own = threshold("fixed", config, {n, static_cast<std::uint8_t>(8 - n)});
      config.adaptive = false;
      EXPECT_EQ(own, threshold("attention", config, {n, static_cast<std::uint8_t>(8 - n)}));
      EXPECT_EQ(own, reference == 0 ? 4 : reference == 255 ? 200 : static_cast<int>(reference));
    }
  }
}

}  // namespace
}  // namespace artu::hw::test
