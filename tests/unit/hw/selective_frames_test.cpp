// Whole frames with every plan of passes: each pixel in its pass and once, laws kept, the same bits in every mode.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "hw/selective/pass_plan.h"
#include "hw/selective/policy.h"
#include "unit/hw/every_plan.h"
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
  for_every_stride_and_passes([&test](std::uint32_t stride, Passes passes) { test(with(stride, passes)); });
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

TEST(SelectiveFrames, OverlapChangesNoPixelInAnyMode) {
  for_every_plan([](const UnitConfig& config) {
    for (const auto& [width, height] : {std::pair<std::uint32_t, std::uint32_t>{1, 1}, {3, 5}, {7, 1}, {41, 27}}) {
      TinyUnit apart(width, height, {}, config);
      apart.run();
      std::uint64_t cycles = 0;
      for (int i = 0; i < 6; ++i) {
        UnitConfig together = config;
        together.selective.overlap = true;
        RunMode mode;
        mode.clocked = i == 1 || i == 2;
        mode.shuffle = i == 2 || i == 3;
        mode.random_stall = i >= 4;
        mode.seed = static_cast<std::uint64_t>(i) + 1;
        TinyUnit u(width, height, mode, together);
        const FrameResult result = u.run();
        ASSERT_FALSE(result.dead_locked) << result.picture;
        EXPECT_TRUE(result.violations.empty()) << result.violations.front();
        EXPECT_EQ(u.pixels(), apart.pixels()) << width << " x " << height << ", mode " << i;
        std::uint64_t phases = 0;
        for (const char* phase : {"start", "build", "first", "selective", "flush"}) {
          phases += u.statistic(result, "control_unit", std::string("cycles_") + phase);
        }
        EXPECT_EQ(phases, result.cycles);
        if (i == 0) cycles = result.cycles;
        if (i <= 3) {
          EXPECT_EQ(result.cycles, cycles) << "mode " << i;
        }
      }
    }
  });
}

TEST(SelectiveFrames, OverlapWorksWithAnyTileAnyCoresAndAnyBuffers) {
  std::uint32_t state = 1;
  const auto draw = [&state](std::uint32_t count) {
    state = state * 1664525u + 1013904223u;
    return (state >> 16) % count;
  };
  for (int i = 0; i < 150; ++i) {
    UnitConfig config = with(2u << draw(3), draw(2) != 0 ? Passes::average : Passes::horizontal_vertical);
    config.selective.tile = std::max(config.selective.stride, 4u << draw(7));
    config.selective.pixel_cache = {256u << draw(5), 1u << draw(3), 1 + draw(8),
                                    1 + draw(8),     1 + draw(8),   draw(2) != 0};
    config.selective.reference = draw(40);
    config.core.count = 1 + draw(6);
    config.core.contexts = 1 + draw(20);
    config.core.pixel_order = static_cast<PixelOrder>(draw(2));
    config.core.dispatch = static_cast<Dispatch>(draw(2));
    config.memory.write_combining = 2 + draw(20);
    config.memory.interconnect_latency = 1 + draw(12);
    config.memory.l2 = {2048u << draw(4), 2, 1 + draw(12), 1 + draw(12), 1 + draw(8)};
    config.memory.l2_banks = 1u << draw(3);
    const std::uint32_t width = 1 + draw(90), height = 1 + draw(50);
    RunMode mode;
    mode.random_stall = draw(2) != 0;
    mode.shuffle = draw(2) != 0;
    mode.seed = draw(1000);
    TinyUnit apart(width, height, {}, config);
    apart.run();
    config.selective.overlap = true;
    TinyUnit u(width, height, mode, config);
    const FrameResult result = u.run();
    ASSERT_FALSE(result.dead_locked) << "configuration " << i << "\n" << result.picture;
    ASSERT_TRUE(result.violations.empty()) << "configuration " << i << ": " << result.violations.front();
    ASSERT_EQ(u.pixels(), apart.pixels()) << "configuration " << i;
    mode.clocked = true;
    TinyUnit clocked(width, height, mode, config);
    const FrameResult again = clocked.run();
    ASSERT_EQ(again.cycles, result.cycles) << "configuration " << i;
    for (std::size_t n = 0; n < result.statistics.size(); ++n) {
      ASSERT_EQ(again.statistics[n].value, result.statistics[n].value)
          << "configuration " << i << ": " << result.statistics[n].block << "." << result.statistics[n].name;
    }
  }
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
  const auto& names = policy_names();
  config.policy =
      static_cast<std::uint32_t>(std::find(names.begin(), names.end(), std::string("fixed")) - names.begin());
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
