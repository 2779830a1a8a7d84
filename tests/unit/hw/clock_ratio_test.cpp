// Two clocks whose edges are whole ticks of one timeline: 16 : 5 is a unit of 500 MHz with a DRAM of 1600 MHz.
#include <gtest/gtest.h>

#include "unit/hw/support.h"

namespace artu::hw::test {
namespace {

struct Crossing {
  Crossing(Tick from_period, Tick to_period, std::uint32_t capacity, std::uint32_t latency)
      : from(bench.domain("from", from_period)),
        to(bench.domain("to", to_period)),
        fifo(bench.fifo<int>("crossing", capacity, latency)),
        source(bench.block_in<Source<int>>(from, "source", fifo)),
        sink(bench.block_in<Sink<int>>(to, "sink", fifo)) {
    fifo.bind(source, sink);
  }
  Bench bench;
  ClockDomain& from;
  ClockDomain& to;
  Fifo<int>& fifo;
  Source<int>& source;
  Sink<int>& sink;
};

struct Ratio {
  Tick from, to;
  std::uint32_t latency;
};
class ClockCrossing : public testing::TestWithParam<Ratio> {};

TEST_P(ClockCrossing, LatencyIsInCyclesOfTheConsumerAfterTheEdgeOfThePush) {
  const auto [from, to, latency] = GetParam();
  Crossing crossing(from, to, 64, latency);
  std::vector<Cycle> expected;
  for (Cycle c : {1, 2, 3, 4, 5, 16, 17, 80, 300, 2000}) {
    crossing.source.push_at(c, 0);
    // The last edge of the consumer not after the push, and `latency` cycles more; one token a cycle.
    const Cycle arrival = c * from / to + latency;
    expected.push_back(expected.empty() ? arrival : std::max(arrival, expected.back() + 1));
  }
  crossing.bench.run(2100 * from + 2000);
  EXPECT_EQ(crossing.sink.cycles, expected);
}

INSTANTIATE_TEST_SUITE_P(Ratios, ClockCrossing,
                         testing::Values(Ratio{16, 5, 1}, Ratio{16, 5, 3}, Ratio{5, 16, 1}, Ratio{5, 16, 4},
                                         Ratio{1, 1, 2}, Ratio{3, 2, 1}));

TEST(ClockCrossing, AFreedEntryIsUsedInTheProducersNextCycle) {
  // The sink pops in cycle 40 of its clock, tick 200: the producer's next edge is cycle 13, tick 208.
  Crossing crossing(16, 5, 1, 1);
  crossing.source.push_at(1, 1).push_at(2, 2);
  crossing.sink.open = [](Cycle now) { return now >= 40; };
  crossing.bench.run(1000);
  EXPECT_EQ(crossing.source.pushed, (std::vector<Cycle>{1, 13}));
  EXPECT_EQ(crossing.sink.cycles, (std::vector<Cycle>{40, 13 * 16 / 5 + 1}));
}

TEST(ClockCrossing, APopAtACommonEdgeFreesTheEntryInTheNextCycle) {
  // Cycle 48 of the sink is tick 240 and so is cycle 15 of the producer: free in 16.
  Crossing crossing(16, 5, 1, 1);
  crossing.source.push_at(1, 1).push_at(15, 2);
  crossing.sink.open = [](Cycle now) { return now >= 48; };
  crossing.bench.run(1000);
  EXPECT_EQ(crossing.source.pushed, (std::vector<Cycle>{1, 16}));
}

TEST(ClockCrossing, FinishStopsEveryDomain) {
  Crossing crossing(16, 5, 4, 1);
  crossing.source.push_at(20, 1);  // tick 320
  crossing.bench.run(319);
  EXPECT_TRUE(crossing.source.pushed.empty());
  crossing.bench.run(324);
  EXPECT_EQ(crossing.source.pushed, (std::vector<Cycle>{20}));
  EXPECT_TRUE(crossing.sink.cycles.empty()) << "it would arrive at tick 325";
}

}  // namespace
}  // namespace artu::hw::test
