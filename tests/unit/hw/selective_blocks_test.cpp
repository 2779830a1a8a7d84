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
  explicit StageBench(Args&&... args)
      : in(bench.fifo<Candidate>("in", 4)),
        out(bench.fifo<Candidate>("out", 2 + Stage::latency, Stage::latency)),
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
  c.neighbours = {HitClass::static_geometry, HitClass::dynamic_geometry, HitClass::dynamic_geometry, HitClass::miss};
  c.counts = {1, 2};
  return c;
}

template <class Stage, class... Args>
void expect_latency_two_and_one_a_cycle(Args&&... args) {
  StageBench<Stage> b(args...);
  for (std::uint16_t i = 0; i < 50; ++i) b.source.push_at(9, candidate(i));
  b.bench.run(200);
  // Arrival in 10, two cycles of latency.
  EXPECT_EQ(b.sink.cycles, every(12, 50));
  for (std::uint16_t i = 0; i < 50; ++i) EXPECT_EQ(b.sink.tokens[i].x, i);

  StageBench<Stage> blocked(args...);
  blocked.sink.open = [](Cycle now) { return now >= 100; };
  for (std::uint16_t i = 0; i < 50; ++i) blocked.source.push_at(9, candidate(i));
  blocked.bench.run(400);
  EXPECT_EQ(blocked.sink.tokens.size(), 50u);
  EXPECT_GE(blocked.stage.cycles_in(State::stall_out), 80u);
}

TEST(CollisionCounter, HasLatencyTwoAndTakesOneCandidateACycle) {
  expect_latency_two_and_one_a_cycle<CollisionCounter>();
}

TEST(CollisionCounter, FillsInTheCounts) {
  StageBench<CollisionCounter> b;
  Candidate c = candidate(1);
  c.counts = {};
  b.source.push_at(1, c);
  b.bench.run(50);
  EXPECT_EQ(b.sink.tokens[0].counts.n_static, 1);
  EXPECT_EQ(b.sink.tokens[0].counts.n_dynamic, 2);
}

TEST(ThresholdAdjuster, HasLatencyTwoAndTakesOneCandidateACycle) {
  expect_latency_two_and_one_a_cycle<ThresholdAdjuster>(SelectiveConfig{});
}

TEST(ThresholdAdjuster, FillsInTheThreshold) {
  StageBench<ThresholdAdjuster> b{SelectiveConfig{}};
  b.source.push_at(1, candidate(1));  // one more dynamic hit than static ones: 16 - 2
  b.bench.run(50);
  EXPECT_EQ(b.sink.tokens[0].threshold, 14);
  EXPECT_EQ(counter(b.stage, "lowered"), 1u);
  EXPECT_EQ(counter(b.stage, "raised"), 0u);
}

struct Executor {
  Executor() {
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
    c.pair = true;
    c.a = {100, 100, 100};
    c.b = {100, static_cast<std::uint8_t>(100 + difference), 100};
    c.threshold = 10;
    return c;
  }
  Bench bench;
  FrameRegisters registers;
  Fifo<Candidate>& in = bench.fifo<Candidate>("in", 4);
  Fifo<PixelToken>& interpolated = bench.fifo<PixelToken>("interpolated", 4);
  Fifo<PixelJob>& traced = bench.fifo<PixelJob>("traced", 4);
  RenderExecutor& executor = bench.block<RenderExecutor>("executor", registers);
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
  border.pair = false;
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
