// A channel is latency, capacity and back-pressure, exact to the cycle and whatever the order of ticks.
#include <gtest/gtest.h>

#include <numeric>

#include "unit/hw/support.h"

namespace artu::hw::test {
namespace {

std::vector<int> numbers(int count) {
  std::vector<int> result(static_cast<std::size_t>(count));
  std::iota(result.begin(), result.end(), 0);
  return result;
}

/// A channel with a source and a sink, of which the one or the other is ticked first in each cycle.
struct Wire {
  Wire(std::uint32_t capacity, std::uint32_t latency, bool consumer_first = false)
      : fifo(bench.fifo<int>("wire", capacity, latency)) {
    if (consumer_first) sink = &bench.block<Sink<int>>("sink", fifo);
    source = &bench.block<Source<int>>("source", fifo);
    if (!consumer_first) sink = &bench.block<Sink<int>>("sink", fifo);
    fifo.bind(*source, *sink);
  }
  Bench bench;
  Fifo<int>& fifo;
  Source<int>* source;
  Sink<int>* sink;
};

/// Looks at the channel in every cycle, without popping.
class Looker : public Block {
 public:
  Looker(sc_core::sc_module_name name, ClockDomain& domain, Fifo<int>& in) : Block(name, domain), in_(in) {}
  std::vector<bool> ready{false};  // by cycle
  void reset() override { ready = {false}; }

 private:
  Activity tick(Cycle now) override {
    ready.push_back(in_.can_pop());
    return {State::busy, now + 1};
  }
  Fifo<int>& in_;
};

class FifoLatency : public testing::TestWithParam<std::uint32_t> {};

TEST_P(FifoLatency, IsNotReadyAtNMinusOneAndReadyAtN) {
  Bench bench;
  auto& fifo = bench.fifo<int>("wire", 16, GetParam());
  auto& source = bench.block<Source<int>>("source", fifo).push_at(10, 7);
  auto& looker = bench.block<Looker>("looker", fifo);
  fifo.bind(source, looker);
  const Cycle arrival = 10 + GetParam();
  bench.run(arrival + 5);
  EXPECT_FALSE(looker.ready[arrival - 1]);
  EXPECT_TRUE(looker.ready[arrival]);
}

TEST_P(FifoLatency, WakesASleepingConsumerInTheCycleOfArrival) {
  Wire wire(16, GetParam());
  wire.source->push_at(10, 7).push_at(11, 8).push_at(400, 9);
  wire.bench.run(1500);
  const Cycle n = GetParam();
  EXPECT_EQ(wire.sink->cycles, (std::vector<Cycle>{10 + n, 11 + n, 400 + n}));
}

INSTANTIATE_TEST_SUITE_P(Latencies, FifoLatency, testing::Values(1, 2, 3, 10, 255, 256, 257, 1000));

class FifoOrder : public testing::TestWithParam<bool> {};  // consumer ticked first?

TEST_P(FifoOrder, CapacityCountsTokensInFlight) {
  Wire wire(3, 5, GetParam());
  wire.source->push_all(1, numbers(6));
  wire.bench.run(40);
  // Three go in, the first is popped in cycle 6: its entry can be used in 7.
  EXPECT_EQ(wire.source->pushed, (std::vector<Cycle>{1, 2, 3, 7, 8, 9}));
  EXPECT_EQ(wire.sink->cycles, (std::vector<Cycle>{6, 7, 8, 12, 13, 14}));
}

TEST_P(FifoOrder, APoppedEntryIsFreeInTheNextCycleAndNotEarlier) {
  Wire wire(1, 1, GetParam());
  wire.source->push_all(1, numbers(4));
  wire.bench.run(40);
  EXPECT_EQ(wire.source->pushed, (std::vector<Cycle>{1, 3, 5, 7}));
  EXPECT_EQ(wire.sink->cycles, (std::vector<Cycle>{2, 4, 6, 8}));
}

TEST_P(FifoOrder, TwoEntriesAreEnoughForOneTokenACycleAtLatencyOne) {
  Wire wire(2, 1, GetParam());
  wire.source->push_all(1, numbers(50));
  wire.bench.run(100);
  EXPECT_EQ(wire.sink->cycles, every(2, 50));
}

TEST_P(FifoOrder, BackPressureReachesTheProducer) {
  Wire wire(4, 1, GetParam());
  wire.source->push_all(1, numbers(8));
  wire.sink->open = [](Cycle now) { return now >= 30 && now % 3 == 0; };
  wire.bench.run(60);
  EXPECT_EQ(wire.sink->cycles, every(30, 8, 3));
  EXPECT_EQ(wire.source->pushed, (std::vector<Cycle>{1, 2, 3, 4, 31, 34, 37, 40}));
  EXPECT_EQ(wire.sink->tokens, numbers(8));
}

TEST_P(FifoOrder, AProducerThatFindsTheChannelFullInTheCycleOfAPopIsWoken) {
  // The pop of cycle 10 comes before the producer looks for the first time, in cycle 10: it waits for one cycle.
  Wire wire(1, 1, GetParam());
  wire.source->push_at(1, 1).push_at(10, 2);
  wire.sink->open = [](Cycle now) { return now >= 10; };
  wire.bench.run(1000);
  EXPECT_EQ(wire.source->pushed, (std::vector<Cycle>{1, 11}));
  EXPECT_EQ(wire.sink->cycles, (std::vector<Cycle>{10, 12}));
}

TEST_P(FifoOrder, RandomStallsKeepTheOrderAndLoseNothing) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Wire wire(5, 2, GetParam());
    wire.fifo.stall_randomly(seed);
    wire.source->push_all(1, numbers(200));
    wire.bench.run(5000);
    ASSERT_EQ(wire.sink->tokens, numbers(200)) << "seed " << seed;
    for (std::size_t i = 0; i < 200; ++i) ASSERT_GE(wire.sink->cycles[i], wire.source->pushed[i] + 2);
    EXPECT_GT(wire.sink->cycles.back(), Cycle{1 + 199 + 2}) << "the stalls cost something";
  }
}

INSTANTIATE_TEST_SUITE_P(TickOrders, FifoOrder, testing::Bool());

TEST(Fifo, TheOrderOfTicksDoesNotChangeTheTrace) {
  std::vector<std::vector<Cycle>> traces;
  for (bool consumer_first : {false, true}) {
    Wire wire(3, 2, consumer_first);
    wire.source->push_all(1, numbers(100));
    wire.sink->open = [](Cycle now) { return now * 2654435761u % 7 < 4; };
    wire.bench.run(1000);
    traces.push_back(wire.source->pushed);
    traces.push_back(wire.sink->cycles);
  }
  ASSERT_EQ(traces[1].size(), 100u);
  EXPECT_EQ(traces[0], traces[2]);
  EXPECT_EQ(traces[1], traces[3]);
}

TEST(Fifo, ExtraLatencyDelaysATokenAndThoseBehindIt) {
  Bench bench;
  auto& fifo = bench.fifo<int>("wire", 8, 1);
  class Pusher : public Block {
   public:
    Pusher(sc_core::sc_module_name name, ClockDomain& domain, Fifo<int>& out) : Block(name, domain), out_(out) {}
    void reset() override {}

   private:
    Activity tick(Cycle now) override {
      if (now == 1) out_.push(1, 20);  // arrives in 22
      if (now == 2) out_.push(2);      // would arrive in 3: must not overtake
      return {State::busy, now < 2 ? now + 1 : never};
    }
    Fifo<int>& out_;
  };
  auto& pusher = bench.block<Pusher>("pusher", fifo);
  auto& sink = bench.block<Sink<int>>("sink", fifo);
  fifo.bind(pusher, sink);
  bench.run(100);
  EXPECT_EQ(sink.tokens, (std::vector<int>{1, 2}));
  EXPECT_EQ(sink.cycles, (std::vector<Cycle>{22, 23}));
}

}  // namespace
}  // namespace artu::hw::test
