// The whole unit on a frame made by hand: it ends, its laws hold, and how it is run does not matter.
#include "hw/ray_tracing_unit.h"

#include <gtest/gtest.h>

#include "unit/hw/tiny_frame.h"

namespace artu::hw::test {
namespace {

std::vector<std::tuple<std::string, std::string, std::uint64_t>> numbers(const FrameResult& result) {
  std::vector<std::tuple<std::string, std::string, std::uint64_t>> list;
  for (const Statistic& s : result.statistics) list.emplace_back(s.block, s.name, s.value);
  return list;
}

TEST(Unit, AFrameEndsAndItsLawsHold) {
  TinyUnit u;
  const FrameResult result = u.run();
  EXPECT_FALSE(result.dead_locked);
  EXPECT_THAT(result.violations, testing::IsEmpty());
  EXPECT_GT(result.cycles, 0u);
  for (const PixelRecord& record : u.records) EXPECT_EQ(record.written, 1);
}

TEST(Unit, SeesWhatIsThere) {
  TinyUnit u;
  u.run();
  const auto at = [&u](std::uint32_t x, std::uint32_t y) { return u.records[y * u.tiny.width + x]; };
  EXPECT_EQ(at(0, 0).hit_class, HitClass::miss);
  EXPECT_EQ(at(0, 12).hit_class, HitClass::static_geometry);
  EXPECT_EQ(at(0, 12).primitive, 1) << "the upper left triangle of the wall";
  EXPECT_EQ(at(12, 6).hit_class, HitClass::dynamic_geometry);
  EXPECT_EQ(at(12, 6).primitive, 2);
  const float t = float_of(at(12, 6).t_bits);  // 8 in z, along a direction that is nearly the axis
  EXPECT_GT(t, 8.0f);
  EXPECT_LT(t, 8.2f);
}

TEST(Unit, OfEveryTracedPixelTheCyclesAreRecorded) {
  TinyUnit event;
  const FrameResult result = event.run();
  RunMode mode;
  mode.clocked = true;
  TinyUnit clocked(21, 13, mode);
  clocked.run();
  int interpolated = 0;
  for (std::size_t i = 0; i < event.records.size(); ++i) {
    const PixelRecord& record = event.records[i];
    if (record.decision == Decision::interpolated) {
      EXPECT_EQ(record.cycles, 0u);
      ++interpolated;
    } else {
      EXPECT_GT(record.cycles, 20u) << "at least the ray's set-up";
      EXPECT_LT(record.cycles, result.cycles);
    }
    EXPECT_EQ(record.cycles, clocked.records[i].cycles);
  }
  EXPECT_GT(interpolated, 0);
}

TEST(Unit, FramesAreIndependentOfTheFramesBefore) {
  TinyUnit u;
  const FrameResult first = u.run();
  const auto pixels = u.pixels();
  for (int i = 0; i < 3; ++i) {
    const FrameResult again = u.run();
    EXPECT_EQ(again.cycles, first.cycles);
    EXPECT_EQ(numbers(again), numbers(first));
    EXPECT_EQ(u.pixels(), pixels);
    EXPECT_THAT(again.violations, testing::IsEmpty());
  }
}

TEST(Unit, ClockedAndShuffledRunsAreTheSameToTheCycle) {
  TinyUnit event;
  const FrameResult expected = event.run();
  for (const auto& [clocked, shuffle] : {std::pair<bool, bool>{true, false}, {false, true}, {true, true}}) {
    RunMode mode;
    mode.clocked = clocked;
    mode.shuffle = shuffle;
    mode.seed = 17;
    TinyUnit other(21, 13, mode);
    const FrameResult result = other.run();
    EXPECT_EQ(result.cycles, expected.cycles);
    EXPECT_EQ(numbers(result), numbers(expected));
    EXPECT_EQ(other.pixels(), event.pixels());
  }
}

TEST(Unit, RandomStallsChangeCyclesAndNoPixel) {
  TinyUnit plain;
  const FrameResult expected = plain.run();
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    RunMode mode;
    mode.random_stall = true;
    mode.seed = seed;
    TinyUnit stalled(21, 13, mode);
    const FrameResult result = stalled.run();
    EXPECT_NE(result.cycles, expected.cycles);
    EXPECT_EQ(stalled.pixels(), plain.pixels()) << "seed " << seed;
    EXPECT_THAT(result.violations, testing::IsEmpty());
  }
}

TEST(Unit, PhasesSumToTheFrame) {
  TinyUnit u;
  const FrameResult result = u.run();
  std::uint64_t sum = 0;
  for (const char* phase : {"start", "build", "first", "selective", "flush"}) {
    sum += u.statistic(result, "control_unit", std::string("cycles_") + phase);
  }
  EXPECT_EQ(sum, result.cycles);
}

TEST(Unit, TheTreeIsBuiltOnlyWhereItMoved) {
  TinyUnit u;
  const FrameResult still = u.run();
  EXPECT_EQ(u.statistic(still, "tree_builder", "builds"), 0u);
  EXPECT_EQ(u.statistic(still, "control_unit", "cycles_build"), 0u);
  const auto pixels = u.pixels();
  u.tiny.frame().dynamic_moved = 1;
  const FrameResult moved = u.run();
  EXPECT_EQ(u.statistic(moved, "tree_builder", "builds"), 1u);
  EXPECT_EQ(
      moved.cycles,
      still.cycles + u.statistic(moved, "control_unit", "cycles_build") +
          (u.statistic(moved, "control_unit", "cycles_first") - u.statistic(still, "control_unit", "cycles_first")) +
          (u.statistic(moved, "control_unit", "cycles_selective") -
           u.statistic(still, "control_unit", "cycles_selective")) +
          (u.statistic(moved, "control_unit", "cycles_flush") - u.statistic(still, "control_unit", "cycles_flush")));
  EXPECT_EQ(u.pixels(), pixels);
}

TEST(Unit, ABuildThatOverlapsAndThatNoRayNeedsCostsOnlyWhatTheFirstPassDoesNotHide) {
  const auto cycles = [](bool overlap, std::uint32_t per_triangle, std::uint32_t size = 48) {
    UnitConfig config = TinyUnit::small();
    config.tree_builder.overlap = overlap;
    config.tree_builder.cycles_per_record = per_triangle;
    TinyUnit u(size, size, {}, config);
    u.tiny.frame().dynamic_moved = 1;
    u.tiny.frame().dynamic_lo = u.tiny.frame().dynamic_hi = {1.0e6f, 1.0e6f, 1.0e6f};
    const FrameResult result = u.run();
    EXPECT_THAT(result.violations, testing::IsEmpty());
    return std::array<std::uint64_t, 3>{result.cycles, u.statistic(result, "control_unit", "cycles_build"),
                                        u.statistic(result, "core0.traversal", "tree_waits")};
  };
  for (std::uint32_t per_triangle : {1u, 100u}) {
    const auto after_another = cycles(false, per_triangle), beside = cycles(true, per_triangle);
    EXPECT_GT(after_another[1], 0u);
    EXPECT_EQ(beside[1], 0u);
    EXPECT_EQ(beside[2], 0u);
    EXPECT_LT(beside[0], after_another[0]);
  }
  // A build that is longer than all passes: what is left of it is waited for.
  const auto after_another = cycles(false, 1000, 1), beside = cycles(true, 1000, 1);
  EXPECT_GT(beside[1], 0u);
  EXPECT_LT(beside[1], after_another[1]);
}

TEST(Unit, WithoutSelectiveRenderingEveryPixelIsSampled) {
  UnitConfig config = TinyUnit::small();
  config.selective.enabled = false;
  TinyUnit u(21, 13, {}, config);
  const FrameResult result = u.run();
  EXPECT_THAT(result.violations, testing::IsEmpty());
  for (const PixelRecord& record : u.records) EXPECT_EQ(record.decision, Decision::sampled);
  EXPECT_EQ(u.statistic(result, "dispatcher", "pixels"), 21u * 13);
}

TEST(Unit, RendersAnySize) {
  for (const auto& [width, height] :
       {std::pair<std::uint32_t, std::uint32_t>{1, 1}, {1, 9}, {9, 1}, {3, 5}, {65, 17}}) {
    TinyUnit u(width, height);
    const FrameResult result = u.run();
    EXPECT_FALSE(result.dead_locked) << width << "x" << height;
    EXPECT_THAT(result.violations, testing::IsEmpty()) << width << "x" << height;
  }
}

TEST(Unit, TheNumberOfCoresChangesNoPixel) {
  TinyUnit two;
  const Cycle cycles = two.run().cycles;
  for (std::uint32_t cores : {1u, 5u}) {
    UnitConfig config = TinyUnit::small();
    config.core.count = cores;
    TinyUnit other(21, 13, {}, config);
    const FrameResult result = other.run();
    EXPECT_EQ(other.pixels(), two.pixels());
    EXPECT_THAT(result.violations, testing::IsEmpty());
    EXPECT_NE(result.cycles, cycles);
  }
}

TEST(Unit, TheSmallestQueuesAreSlowButSafe) {
  UnitConfig config = TinyUnit::small();
  config.core.contexts = 1;
  config.core.queue_depth = 1;
  for (CacheConfig* cache : {&config.core.node_cache, &config.core.triangle_cache, &config.core.texture_cache,
                             &config.selective.pixel_cache}) {
    *cache = {256, 1, 1, 1, 1};
  }
  TinyUnit tight(21, 13, {}, config), wide;
  const FrameResult slow = tight.run(), fast = wide.run();
  EXPECT_FALSE(slow.dead_locked) << slow.picture;
  EXPECT_THAT(slow.violations, testing::IsEmpty());
  EXPECT_GT(slow.cycles, 2 * fast.cycles);
  EXPECT_EQ(tight.pixels(), wide.pixels());
}

TEST(Unit, ALostAnswerEndsInAPictureOfWhoWaitsForWhom) {
  for (bool clocked : {false, true}) {
    RunMode mode;
    mode.clocked = clocked;
    TinyUnit u(21, 13, mode, TinyUnit::small(), {Datapath::dram, 20});
    const FrameResult result = u.run();
    ASSERT_TRUE(result.dead_locked);
    EXPECT_THAT(result.picture, testing::HasSubstr("dead-lock in cycle"));
    EXPECT_THAT(result.picture, testing::HasSubstr(": stall_mem; 1 of 8 lines outstanding"));
    EXPECT_THAT(result.picture, testing::HasSubstr("control_unit"));
  }
}

}  // namespace
}  // namespace artu::hw::test
