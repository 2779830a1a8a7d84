// The wake list: blocks sleep, and nothing but the host's time changes by it.
#include <gtest/gtest.h>

#include "unit/hw/support.h"

namespace artu::hw::test {
namespace {

/// Asks to be ticked in the cycles of a list, and writes down when it was.
class Alarm : public Block {
 public:
  Alarm(sc_core::sc_module_name name, ClockDomain& domain, std::vector<Cycle> list)
      : Block(name, domain), list_(std::move(list)) {}
  std::vector<Cycle> rang;
  void reset() override { rang.clear(); }

 private:
  Activity tick(Cycle now) override {
    rang.push_back(now);
    for (Cycle cycle : list_) {
      if (cycle > now) return {State::idle, cycle};
    }
    return {State::idle};
  }
  const std::vector<Cycle> list_;
};

TEST(ClockDomain, TicksABlockInTheCyclesItAsksForHoweverFarAhead) {
  const std::vector<Cycle> cycles{2, 64, 65, 256 + 64, 256 + 65, 577, 578, 578 + 257, 5000, 5256, 1000000, 1000001};
  Bench bench;
  const auto& alarm = bench.block<Alarm>("alarm", cycles);
  bench.run(2000000);
  std::vector<Cycle> expected{1};  // every block is ticked at the beginning of a frame
  expected.insert(expected.end(), cycles.begin(), cycles.end());
  EXPECT_EQ(alarm.rang, expected);
}

TEST(ClockDomain, KeepsFarWakesOfManyBlocksApart) {
  Bench bench;
  std::vector<Alarm*> alarms;
  for (Cycle i = 0; i < 150; ++i) {
    alarms.push_back(&bench.block<Alarm>(("alarm" + std::to_string(i)).c_str(),
                                         std::vector<Cycle>{250 + i, 3 * (250 + i), 20000 - i, 30000}));
  }
  bench.run(40000);
  for (Cycle i = 0; i < 150; ++i) {
    ASSERT_EQ(alarms[i]->rang, (std::vector<Cycle>{1, 250 + i, 3 * (250 + i), 20000 - i, 30000})) << i;
  }
}

TEST(ClockDomain, KeepsAWakeAtTheEdgeOfTheWheelWhenAnotherOneComesOntoIt) {
  for (Cycle ahead : {255, 256, 257}) {
    Bench bench;
    const auto& near = bench.block<Alarm>("near", std::vector<Cycle>{1000});
    const auto& far = bench.block<Alarm>("far", std::vector<Cycle>{1000 + ahead});
    bench.run(3000);
    EXPECT_EQ(near.rang, (std::vector<Cycle>{1, 1000}));
    EXPECT_EQ(far.rang, (std::vector<Cycle>{1, 1000 + ahead}));
  }
}

TEST(ClockDomain, ASleepingBlockCostsNoTicks) {
  Bench bench;
  bench.block<Alarm>("alarm", std::vector<Cycle>{1000, 100000});
  bench.run(1000000);
  EXPECT_EQ(bench.clock.ticks_done(), 3u + 2u);  // the alarm's, and the stopper's first and last
}

TEST(ClockDomain, ClockedModeTicksEveryBlockInEveryCycle) {
  Bench bench;
  const auto& alarm = bench.block<Alarm>("alarm", std::vector<Cycle>{});
  bench.clock.set_clocked(true);
  bench.run(1000);
  EXPECT_EQ(bench.clock.ticks_done(), 2u * 1000u);
  EXPECT_EQ(alarm.rang, every(1, 1000));
}

/// A chain with back-pressure, bursts and pauses; all that can be seen of it.
std::vector<std::vector<std::uint64_t>> chain(bool clocked, bool shuffle) {
  Bench bench;
  auto& first = bench.fifo<MemoryRequest>("first", 3, 2);
  auto& link = bench.link("link", 2, 1, 3);
  auto& source = bench.block<Source<MemoryRequest>>("source", link.request);
  auto& memory = bench.block<ScriptedMemory>("memory", link, 3, 9);
  auto& sink = bench.block<Sink<MemoryResponse>>("sink", link.response);
  auto& other = bench.block<Source<MemoryRequest>>("other", first);
  auto& drain = bench.block<Sink<MemoryRequest>>("drain", first);
  link.request.bind(source, memory);
  link.response.bind(memory, sink);
  first.bind(other, drain);
  for (std::uint32_t i = 0; i < 60; ++i) {
    source.push_at(i * i / 2 + 1, read_of(64 * i, i));
    other.push_at(5 * i + 1, read_of(64 * i, i));
  }
  drain.open = [](Cycle now) { return now % 11 < 2; };
  sink.open = [](Cycle now) { return now % 5 != 0; };
  bench.clock.set_clocked(clocked);
  bench.clock.set_shuffle(shuffle, 99);
  bench.run(4000);
  return {source.pushed,         memory.cycles,         sink.cycles,         drain.cycles,        other.pushed,
          cycle_classes(source), cycle_classes(memory), cycle_classes(sink), cycle_classes(drain)};
}

TEST(ClockDomain, EventModeAndClockedModeGiveTheSameTrace) {
  const auto event = chain(false, false);
  EXPECT_EQ(event[2].size(), 60u);
  EXPECT_EQ(event, chain(true, false));
}

TEST(ClockDomain, AShuffledOrderOfTicksGivesTheSameTrace) {
  const auto event = chain(false, false);
  EXPECT_EQ(event, chain(false, true));
  EXPECT_EQ(event, chain(true, true));
}

TEST(ClockDomain, TheWatchdogStopsAFrameInWhichTokensRest) {
  Bench bench;
  auto& fifo = bench.fifo<int>("wire", 2);
  auto& source = bench.block<Source<int>>("source", fifo).push_at(30, 1);
  auto& sink = bench.block<Sink<int>>("sink", fifo);
  fifo.bind(source, sink);
  sink.open = [](Cycle) { return false; };  // awake in every cycle, moves nothing
  bench.clock.set_watchdog(100);
  for (int frame = 0; frame < 2; ++frame) {  // the second forgets what the first has seen
    bench.run_until_quiet();
    EXPECT_TRUE(bench.clock.dead_locked());
    // The token of cycle 30 is progress for the first look, at 100; by the second one nothing has moved.
    EXPECT_EQ(bench.clock.now(), 200u);
  }
  sink.open = nullptr;
  bench.run(1000);
  EXPECT_FALSE(bench.clock.dead_locked());
}

/// Computes until cycle 1000, moving nothing.
class Thinker : public Block {
 public:
  using Block::Block;
  void reset() override {}

 private:
  Activity tick(Cycle now) override {
    return now < 1000 ? Activity{State::busy, now + 7} : Activity{State::stall_in, now + 7};
  }
};

TEST(ClockDomain, TheWatchdogWaitsForABusyBlock) {
  Bench bench;
  bench.block<Thinker>("thinker");
  bench.clock.set_watchdog(100);
  bench.run_until_quiet();
  EXPECT_TRUE(bench.clock.dead_locked());
  EXPECT_GE(bench.clock.now(), 1000u);
  EXPECT_LE(bench.clock.now(), 1000u + 2 * (100 + 7));
}

TEST(ClockDomain, TheWatchdogLetsAFrameGoOnInWhichTokensMove) {
  Bench bench;
  auto& fifo = bench.fifo<int>("wire", 2);
  auto& source = bench.block<Source<int>>("source", fifo);
  auto& sink = bench.block<Sink<int>>("sink", fifo);
  fifo.bind(source, sink);
  for (Cycle i = 0; i < 20; ++i) source.push_at(1 + 90 * i, 1);
  bench.clock.set_watchdog(100);
  bench.run(1750);
  EXPECT_FALSE(bench.clock.dead_locked());
  EXPECT_EQ(sink.cycles, every(2, 20, 90));
}

TEST(ClockDomain, AFrameInWhichNothingIsLeftToHappenReturns) {
  Bench bench;
  const auto& alarm = bench.block<Alarm>("alarm", std::vector<Cycle>{500});
  bench.run_until_quiet();
  EXPECT_EQ(alarm.rang, (std::vector<Cycle>{1, 500}));
  EXPECT_EQ(bench.clock.now(), 500u);
}

TEST(ClockDomain, EveryFrameBeginsAtCycleZero) {
  Bench bench;
  const auto& alarm = bench.block<Alarm>("alarm", std::vector<Cycle>{3, 700});
  bench.run(800);
  const auto first = alarm.rang;
  bench.run(800);
  EXPECT_EQ(alarm.rang, first);
}

}  // namespace
}  // namespace artu::hw::test
