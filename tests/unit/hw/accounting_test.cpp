// Every cycle of every block is exactly one of five; round-robin choice is fair.
#include <gtest/gtest.h>

#include <numeric>

#include "hw/fabric/round_robin.h"
#include "unit/hw/support.h"

namespace artu::hw::test {
namespace {

using Classes = std::vector<std::uint64_t>;  // busy, stall_in, stall_out, stall_mem, idle

struct Wire {
  Wire() { fifo.bind(source, sink); }
  Bench bench;
  Fifo<int>& fifo = bench.fifo<int>("wire", 2);
  Source<int>& source = bench.block<Source<int>>("source", fifo);
  Sink<int>& sink = bench.block<Sink<int>>("sink", fifo);
};

TEST(Accounting, EachCycleIsOneOfFiveClasses) {
  Wire wire;
  wire.source.push_at(5, 0).push_at(6, 0).push_at(7, 0);
  wire.sink.open = [](Cycle now) { return now >= 20; };
  wire.bench.run(100);
  // Cycle 0 is the reset's (idle).  1-4 starved, 5-6 push, 7-20 blocked, 21 push, 22-99 starved.
  EXPECT_EQ(cycle_classes(wire.source), (Classes{3, 4 + 78, 14, 0, 1}));
  // Pops in 20, 21, 22.
  EXPECT_EQ(cycle_classes(wire.sink), (Classes{3, 96, 0, 0, 1}));
}

TEST(Accounting, TheClassesSumToTheCyclesWhereverTheFrameEnds) {
  for (Cycle end = 1; end < 40; ++end) {
    Wire wire;
    wire.source.push_all(3, {1, 2, 3, 4, 5, 6});
    wire.sink.open = [](Cycle now) { return now % 4 == 0; };
    wire.bench.run(end);
    for (const Block* block : wire.bench.clock.blocks()) {
      const Classes classes = cycle_classes(*block);
      ASSERT_EQ(std::accumulate(classes.begin(), classes.end(), std::uint64_t{0}), end) << block->name();
    }
  }
}

TEST(Accounting, TheClassesBeginAtZeroInEveryFrame) {
  Wire wire;
  wire.source.push_at(5, 0);
  wire.bench.run(50);
  const Classes first = cycle_classes(wire.source);
  wire.bench.run(50);
  EXPECT_EQ(cycle_classes(wire.source), first);
}

/// Announces phase 2 in cycle 10.
class Announcer : public Block {
 public:
  using Block::Block;
  std::vector<Block*> listeners;
  void reset() override {}

 private:
  Activity tick(Cycle now) override {
    if (now == 10) {
      for (Block* block : listeners) block->set_phase(2);
    }
    return {State::idle, now < 10 ? 10 : never};
  }
};

TEST(Accounting, WaitingIsIdleInAPhaseInWhichTheBlockHasNoPart) {
  Wire wire;
  auto& announcer = wire.bench.block<Announcer>("announcer");
  announcer.listeners = {&wire.source, &wire.sink};
  wire.source.takes_part_in(2);
  wire.sink.takes_part_in(1);
  wire.source.push_at(4, 0);
  wire.bench.run(100);
  // The phase holds from cycle 11 on.  Work is work in any phase: the push of cycle 4, the pop of 5.
  EXPECT_EQ(cycle_classes(wire.source), (Classes{1, 89, 0, 0, 10}));
  EXPECT_EQ(cycle_classes(wire.sink), (Classes{1, 9, 0, 0, 90}));
}

/// Busy in cycle 7, and from then on waiting for memory, without being ticked again.
class Once : public Block {
 public:
  using Block::Block;
  void reset() override {}

 private:
  Activity tick(Cycle now) override {
    if (now < 7) return {State::stall_in, 7};
    return now == 7 ? Activity::once(State::busy, State::stall_mem) : Activity(State::stall_mem);
  }
};

TEST(Accounting, ABlockMaySayWhatFollowsACycle) {
  for (bool clocked : {false, true}) {
    Bench bench;
    const auto& once = bench.block<Once>("once");
    bench.clock.set_clocked(clocked);
    bench.run(100);
    EXPECT_EQ(cycle_classes(once), (Classes{1, 6, 0, 92, 1}));
  }
}

TEST(RoundRobin, FlagsSayWhomToAskAndNothingElse) {
  for (std::size_t count : {1u, 3u, 64u, 65u, 200u}) {
    RoundRobin plain, flagged;
    std::vector<std::uint64_t> flags(count / 64 + 1);
    for (std::uint64_t step = 0; step < 500; ++step) {
      const auto waits = [step](std::size_t i) { return (i * 7919 + step * 104729) % 11 < 2; };
      const auto wants = [step](std::size_t i) { return (i * 31 + step) % 3 != 0; };
      for (std::size_t i = 0; i < count; ++i) {
        const std::uint64_t bit = std::uint64_t{1} << (i % 64);
        flags[i / 64] = waits(i) ? flags[i / 64] | bit : flags[i / 64] & ~bit;
      }
      const std::size_t expected = plain.pick(count, [&](std::size_t i) { return waits(i) && wants(i); });
      ASSERT_EQ(flagged.pick(flags, count, wants), expected) << count << " at step " << step;
      if (expected == count) continue;
      plain.granted(expected, count);
      flagged.granted(expected, count);
    }
  }
}

TEST(RoundRobin, TheOneAfterTheLastGrantedComesFirst) {
  RoundRobin arbiter;
  const auto all = [](std::size_t) { return true; };
  std::vector<std::size_t> order;
  for (int i = 0; i < 7; ++i) {
    order.push_back(arbiter.pick(3, all));
    arbiter.granted(order.back(), 3);
  }
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 0, 1, 2, 0}));
}

TEST(RoundRobin, ThoseThatWantShareEvenly) {
  RoundRobin arbiter;
  std::vector<int> grants(6);  // the last one: nobody
  for (int i = 0; i < 300; ++i) {
    const std::size_t chosen = arbiter.pick(5, [](std::size_t k) { return k != 1 && k != 2; });
    ++grants[chosen];
    arbiter.granted(chosen, 5);
  }
  EXPECT_EQ(grants, (std::vector<int>{100, 0, 0, 100, 100, 0}));
}

TEST(RoundRobin, NobodyIsChosenWhereNobodyWantsAndAPickAloneMovesNothing) {
  RoundRobin arbiter;
  EXPECT_EQ(arbiter.pick(4, [](std::size_t) { return false; }), 4u);
  EXPECT_EQ(arbiter.pick(0, [](std::size_t) { return true; }), 0u);
  arbiter.granted(1, 4);
  EXPECT_EQ(arbiter.pick(4, [](std::size_t) { return true; }), 2u);
  EXPECT_EQ(arbiter.pick(4, [](std::size_t) { return true; }), 2u);
  arbiter.reset();
  EXPECT_EQ(arbiter.pick(4, [](std::size_t) { return true; }), 0u);
}

}  // namespace
}  // namespace artu::hw::test
