// The blocks that candidates pass through, one a cycle: latency, throughput, back-pressure, decision.
#include <gtest/gtest.h>

#include "hw/selective/collision_counter.h"
#include "hw/selective/render_executor.h"
#include "hw/selective/threshold_adjuster.h"
#include "unit/hw/support.h"

namespace artu::hw::test {
namespace {

/// A block between two channels of candidates.
template <class Stage>
struct StageBench {
  template <class... Args>
  explicit StageBench(std::uint32_t latency, Args&&... args)
      : in(bench.fifo<Candidate>("in", 4)),
        out(bench.fifo<Candidate>("out", 2 + latency, latency)),
        stage(bench.block<Stage>("stage", std::forward<Args>(args)...)),
        source(bench.block<Source<Candidate>>("source", in)),
        sink(bench.block<Sink<Candidate>>("sink", out)) {
    in.bind(source, stage);
    out.bind(stage, sink);
    stage.bind(in, out);
  }
  Bench bench;
  Fifo<Candidate>&in, &out;
  Stage& stage;
  Source<Candidate>& source;
  Sink<Candidate>& sink;
};

Candidate candidate(std::uint16_t x) {
  Candidate c;
  c.x = x;
  c.ring[0].hit_class = HitClass::static_geometry;
  c.ring[1].hit_class = c.ring[2].hit_class = HitClass::dynamic_geometry;
  c.ring[3].hit_class = HitClass::miss;
  c.counts = {1, 2};
  return c;
}

template <class Stage, class... Args>
void expect_latency_and_one_a_cycle(std::uint32_t latency, Args&&... args) {
  StageBench<Stage> b(latency, args...);
  for (std::uint16_t i = 0; i < 50; ++i) b.source.push_at(9, candidate(i));
  b.bench.run(200);
  // Arrival in 10, then the latency.
  EXPECT_EQ(b.sink.cycles, every(10 + latency, 50));
  for (std::uint16_t i = 0; i < 50; ++i) EXPECT_EQ(b.sink.tokens[i].x, i);

  StageBench<Stage> blocked(latency, args...);
  blocked.sink.open = [](Cycle now) { return now >= 100; };
  for (std::uint16_t i = 0; i < 50; ++i) blocked.source.push_at(9, candidate(i));
  blocked.bench.run(400);
  EXPECT_EQ(blocked.sink.tokens.size(), 50u);
  EXPECT_GE(blocked.stage.cycles_in(State::stall_out), 80u);
}

TEST(CollisionCounter, HasLatencyTwoAndTakesOneCandidateACycle) { expect_latency_and_one_a_cycle<CollisionCounter>(2); }

TEST(CollisionCounter, FillsInTheCounts) {
  StageBench<CollisionCounter> b(CollisionCounter::latency);
  Candidate c = candidate(1);
  c.counts = {};
  b.source.push_at(1, c);
  b.bench.run(50);
  EXPECT_EQ(b.sink.tokens[0].counts.n_static, 1);
  EXPECT_EQ(b.sink.tokens[0].counts.n_dynamic, 2);
  EXPECT_EQ(counter(b.stage, "static_hits"), 1u);
  EXPECT_EQ(counter(b.stage, "dynamic_hits"), 2u);
}

TEST(ThresholdAdjuster, HasThePolicysLatencyAndTakesOneCandidateACycle) {
  SelectiveConfig config;
  EXPECT_EQ(ThresholdAdjuster::latency(config), 2u) << "of attention";
  for (; config.policy < policy_names().size(); ++config.policy) {
    expect_latency_and_one_a_cycle<ThresholdAdjuster>(ThresholdAdjuster::latency(config), config);
  }
}

TEST(ThresholdAdjuster, FillsInTheThreshold) {
  StageBench<ThresholdAdjuster> b(2, SelectiveConfig{});
  b.source.push_at(1, candidate(1));  // one more dynamic hit than static ones: 16 - 2
  b.bench.run(50);
  EXPECT_EQ(b.sink.tokens[0].threshold, 14);
  EXPECT_EQ(counter(b.stage, "lowered"), 1u);
  EXPECT_EQ(counter(b.stage, "raised"), 0u);
}

TEST(ThresholdAdjuster, CountsThresholdsOnEitherSideOfTheReference) {
  StageBench<ThresholdAdjuster> b(2, SelectiveConfig{});
  Cycle at = 1;
  for (const HitCounts& counts : {HitCounts{2, 2}, HitCounts{1, 2}, HitCounts{3, 2}, HitCounts{4, 0}}) {
    Candidate c = candidate(1);
    c.counts = counts;
    b.source.push_at(at++, c);
  }
  b.bench.run(50);
  EXPECT_EQ(b.sink.tokens[0].threshold, 16) << "the reference itself is neither";
  EXPECT_EQ(counter(b.stage, "lowered"), 1u);
  EXPECT_EQ(counter(b.stage, "raised"), 2u);
}

struct Executor {
  explicit Executor(Metric metric = Metric::max_channel)
      : executor(bench.block<RenderExecutor>("executor", metric, registers)) {
    registers.descriptor.width = 64;
    in.bind(source, executor);
    interpolated.bind(executor, pixels);
    traced.bind(executor, jobs);
    executor.bind(in, interpolated, traced);
  }
  /// A pair whose colours differ by `difference` at threshold 10.
  static Candidate pair(std::uint16_t x, std::uint8_t difference) {
    Candidate c;
    c.x = x;
    c.pairs.count = 1;
    c.pairs.color[0] = {Rgb{100, 100, 100}, Rgb{100, static_cast<std::uint8_t>(100 + difference), 100}};
    c.threshold = 10;
    return c;
  }
  Bench bench;
  FrameRegisters registers;
  Fifo<Candidate>& in = bench.fifo<Candidate>("in", 4);
  Fifo<PixelToken>& interpolated = bench.fifo<PixelToken>("interpolated", 4);
  Fifo<PixelJob>& traced = bench.fifo<PixelJob>("traced", 4);
  RenderExecutor& executor;
  Source<Candidate>& source = bench.block<Source<Candidate>>("source", in);
  Sink<PixelToken>& pixels = bench.block<Sink<PixelToken>>("pixels", interpolated);
  Sink<PixelJob>& jobs = bench.block<Sink<PixelJob>>("jobs", traced);
};

TEST(RenderExecutor, HasLatencyOneAndTakesOneCandidateACycle) {
  Executor e;
  for (std::uint16_t i = 0; i < 60; ++i) e.source.push_at(9, Executor::pair(i, i % 2 == 0 ? 10 : 11));
  e.bench.run(200);
  EXPECT_EQ(e.pixels.cycles, every(11, 30, 2));
  EXPECT_EQ(e.jobs.cycles, every(12, 30, 2));
}

TEST(RenderExecutor, InterpolatesUpToTheThresholdAndTracesAboveAndAtTheBorder) {
  Executor e;
  Candidate border = Executor::pair(3, 0);
  border.pairs = {};
  e.source.push_at(1, Executor::pair(1, 10)).push_at(2, Executor::pair(2, 11)).push_at(3, border);
  e.bench.run(100);
  ASSERT_EQ(e.pixels.tokens.size(), 1u);
  EXPECT_EQ(e.pixels.tokens[0].x, 1);
  EXPECT_EQ(e.pixels.tokens[0].g, 105);
  EXPECT_EQ(e.pixels.tokens[0].hit_class, HitClass::none);
  ASSERT_EQ(e.jobs.tokens.size(), 2u);
  EXPECT_EQ(e.jobs.tokens[0].x, 2);
  EXPECT_EQ(e.jobs.tokens[1].x, 3);
}

/// A centre whose pairs differ by these.
Candidate centre(std::uint16_t x, std::uint8_t horizontal, std::uint8_t vertical) {
  Candidate c = Executor::pair(x, horizontal);
  c.kind = PassKind::centre;
  c.pairs.count = 2;
  c.pairs.color[1] = {Rgb{100, 100, 100}, Rgb{100, 100, static_cast<std::uint8_t>(100 + vertical)}};
  return c;
}

TEST(RenderExecutor, ACentreIsInterpolatedUpToTwiceTheThreshold) {
  Executor e;
  Candidate border = centre(4, 0, 0);
  border.pairs = {};
  e.source.push_at(1, centre(1, 20, 0)).push_at(2, centre(2, 0, 21)).push_at(3, centre(3, 9, 11)).push_at(4, border);
  e.bench.run(100);
  ASSERT_EQ(e.pixels.tokens.size(), 2u);
  EXPECT_EQ(e.pixels.tokens[0].x, 1);
  EXPECT_EQ(e.pixels.tokens[0].g, 105);  // (100 + 120 + 100 + 100 + 2) / 4
  EXPECT_EQ(e.pixels.tokens[1].x, 3);
  EXPECT_EQ(e.pixels.tokens[1].b, 103);  // (100 + 100 + 100 + 111 + 2) / 4
  ASSERT_EQ(e.jobs.tokens.size(), 2u);
  EXPECT_EQ(e.jobs.tokens[0].x, 2);
  EXPECT_EQ(e.jobs.tokens[1].x, 4);
  EXPECT_EQ(counter(e.executor, "differences"), 8u);
}

TEST(RenderExecutor, ComparesByTheMetric) {
  const auto traced = [](Metric metric, Rgb b) {
    Executor e(metric);
    Candidate c = Executor::pair(1, 0);
    c.pairs.color[0][1] = b;
    e.source.push_at(1, c);
    e.bench.run(100);
    return e.jobs.tokens.size();
  };
  const Rgb everywhere{104, 104, 104}, red{120, 100, 100}, green{100, 118, 100};
  EXPECT_EQ(traced(Metric::max_channel, everywhere), 0u);
  EXPECT_EQ(traced(Metric::sum, everywhere), 1u);
  EXPECT_EQ(traced(Metric::max_channel, red), 1u);
  EXPECT_EQ(traced(Metric::luma, red), 0u);
  EXPECT_EQ(traced(Metric::luma, green), 1u);
}

TEST(RenderExecutor, WaitsOnlyForTheOutputThatTheDecisionNeeds) {
  Executor e;
  e.jobs.open = [](Cycle now) { return now >= 500; };
  for (std::uint16_t i = 0; i < 4; ++i) e.source.push_at(1, Executor::pair(i, 200));  // fills the traced channel
  for (std::uint16_t i = 4; i < 10; ++i) e.source.push_at(1, Executor::pair(i, 0));   // goes past it
  e.source.push_at(20, Executor::pair(10, 200)).push_at(21, Executor::pair(11, 0));
  e.bench.run(400);
  EXPECT_EQ(e.pixels.tokens.size(), 6u);
  e.bench.run(1000);
  EXPECT_EQ(e.pixels.tokens.size(), 7u);
  EXPECT_EQ(e.jobs.tokens.size(), 5u);
}

}  // namespace
}  // namespace artu::hw::test
