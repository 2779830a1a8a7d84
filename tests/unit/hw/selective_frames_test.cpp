// Whole frames with every plan of passes: each pixel in its pass and once, laws kept, the same bits in every mode.
#include <gtest/gtest.h>

#include "hw/selective/pass_plan.h"
#include "unit/hw/tiny_frame.h"

namespace artu::hw::test {
namespace {

UnitConfig with(std::uint32_t stride, Passes passes) {
  UnitConfig config = TinyUnit::small();
  config.selective.stride = stride;
  config.selective.passes = passes;
  return config;
}

template <class Test>
void for_every_plan(const Test& test) {
  for (std::uint32_t stride : {2u, 4u, 8u}) {
    for (Passes passes : {Passes::horizontal_vertical, Passes::average}) {
      SCOPED_TRACE("stride " + std::to_string(stride) + (passes == Passes::average ? ", average" : ""));
      test(with(stride, passes));
    }
  }
}

TEST(SelectiveFrames, EveryPixelIsWrittenOnceInItsPass) {
  for_every_plan([](const UnitConfig& config) {
    for (const auto& [width, height] :
         {std::pair<std::uint32_t, std::uint32_t>{1, 1}, {3, 5}, {7, 1}, {1, 9}, {21, 13}, {33, 18}}) {
      SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
      TinyUnit u(width, height, {}, config);
      const FrameResult result = u.run();
      ASSERT_FALSE(result.dead_locked) << result.picture;
      EXPECT_TRUE(result.violations.empty()) << result.violations.front();
      const PassPlan plan(config.selective);
      for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
          const PixelRecord& p = u.records[y * width + x];
          ASSERT_EQ(p.pass, plan.pass_of(x, y)) << x << ", " << y;
          ASSERT_EQ(p.decision == Decision::sampled, p.pass == 0);
          ASSERT_EQ(p.threshold == -1, p.pass == 0);
        }
      }
    }
  });
}

TEST(SelectiveFrames, AllModesOfSimulationAgree) {
  for_every_plan([](const UnitConfig& config) {
    TinyUnit event(21, 13, {}, config);
    const FrameResult expected = event.run();
    for (const auto& [clocked, shuffle, stall] : {std::tuple<bool, bool, bool>{true, false, false},
                                                  {true, true, false},
                                                  {false, true, false},
                                                  {false, false, true}}) {
      RunMode mode;
      mode.clocked = clocked;
      mode.shuffle = shuffle;
      mode.random_stall = stall;
      mode.seed = 7;
      TinyUnit other(21, 13, mode, config);
      const FrameResult result = other.run();
      EXPECT_TRUE(result.violations.empty()) << result.violations.front();
      EXPECT_EQ(other.pixels(), event.pixels());
      if (stall) continue;
      EXPECT_EQ(result.cycles, expected.cycles);
    }
  });
}

TEST(SelectiveFrames, ACentreIsTracedAboveTwiceItsThreshold) {
  TinyUnit u(40, 30, {}, with(4, Passes::average));
  u.run();
  const PassPlan plan(with(4, Passes::average).selective);
  std::size_t interpolated = 0, traced = 0;
  for (const PixelRecord& p : u.records) {
    if (p.pass == 0 || plan.pass(p.pass).kind != PassKind::centre || p.difference < 0) continue;
    ASSERT_EQ(p.decision == Decision::interpolated, p.difference <= 2 * p.threshold);
    ++(p.decision == Decision::interpolated ? interpolated : traced);
  }
  EXPECT_GT(interpolated, 0u);
  EXPECT_GT(traced, 0u);
}

TEST(SelectiveFrames, PoliciesMetricsAndComparisonsChangeWhatIsTraced) {
  const auto traced = [](const SelectiveConfig& selective) {
    UnitConfig config = TinyUnit::small();
    config.selective = selective;
    TinyUnit u(40, 30, {}, config);
    const FrameResult result = u.run();
    EXPECT_TRUE(result.violations.empty()) << result.violations.front();
    return u.statistic(result, "render_executor", "traced");
  };
  SelectiveConfig config;
  const auto by_default = traced(config);
  config.metric = Metric::sum;
  EXPECT_GT(traced(config), by_default);
  config.metric = Metric::luma;
  EXPECT_LE(traced(config), by_default);
  config = {};
  config.adaptive = false;
  const auto without = traced(config);
  config = {};
  config.policy = 1;  // fixed
  EXPECT_EQ(traced(config), without);
  config = {};
  config.compare = Compare::reference_count;
  config.count = Count::merged;
  config.step = 8;
  config.reference_count = 8;
  const auto high = traced(config);
  config.reference_count = 0;
  EXPECT_GE(traced(config), high);
}

}  // namespace
}  // namespace artu::hw::test
