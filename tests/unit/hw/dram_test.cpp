// DRAM timing: latencies are sums of the timing parameters, the data bus is the bound of a stream.
#include <gtest/gtest.h>

#include "unit/hw/dram_support.h"

namespace artu::hw::test {
namespace {

constexpr Cycle burst = 16;  // clocks of data for a line: 64 bytes, 16 bits, both edges

/// LPDDR4-3200 without refresh, banks not hashed.
DramConfig config_of(std::uint32_t channels = 1, std::uint32_t queue_depth = 16) {
  DramConfig config;
  config.refresh = RefreshPolicy::none;
  config.bank_hash = false;
  config.channels = channels;
  config.queue_depth = queue_depth;
  return config;
}

using Memory = DramBench;

TEST(Dram, AnEmptyBankCostsActivateAndColumn) {
  Memory m(config_of());
  m.client.requests.push_at(9, read_of(m.at(0, 0, 0)));
  EXPECT_EQ(m.run(), std::vector<Cycle>{10 + 29 + 28 + burst + 1});
  EXPECT_EQ(counter(m.dram, "row_empty"), 1u);
}

TEST(Dram, AnOpenRowCostsTheColumnOnly) {
  Memory m(config_of());
  m.client.requests.push_at(9, read_of(m.at(3, 5, 0))).push_at(999, read_of(m.at(3, 5, 31)));
  EXPECT_EQ(m.run()[1], 1000 + 28 + burst + 1);
  EXPECT_EQ(counter(m.dram, "row_hits"), 1u);
}

TEST(Dram, AnotherRowCostsPrechargeActivateAndColumn) {
  Memory m(config_of());
  m.client.requests.push_at(9, read_of(m.at(3, 5, 0))).push_at(999, read_of(m.at(3, 6, 0)));
  EXPECT_EQ(m.run()[1], 1000 + 29 + 29 + 28 + burst + 1);
  EXPECT_EQ(counter(m.dram, "row_misses"), 1u);
}

TEST(Dram, EveryParameterCountsOnce) {
  DramConfig config = config_of();
  config.t_rcd = 100;
  config.t_rp = 900;
  config.t_cl = 800;
  Memory m(config);
  m.client.requests.push_at(9, read_of(m.at(0, 0, 0))).push_at(19999, read_of(m.at(0, 0, 1)));
  m.client.requests.push_at(39999, read_of(m.at(0, 1, 0)));
  EXPECT_EQ(m.run(70000), (std::vector<Cycle>{10 + 100 + 800 + burst + 1, 20000 + 800 + burst + 1,
                                              40000 + 900 + 100 + 800 + burst + 1}));
}

TEST(Dram, ARowStaysOpenForAtLeastTRas) {
  Memory m(config_of());
  m.client.requests.push_at(9, read_of(m.at(0, 0, 0))).push_at(10, read_of(m.at(0, 1, 0)));
  // Activate in 10; precharge 68 later and not before.
  EXPECT_EQ(m.run()[1], 10 + 68 + 29 + 29 + 28 + burst + 1);
  DramConfig early = config_of();
  early.t_ras = 1;
  Memory e(early);
  e.client.requests.push_at(9, read_of(e.at(0, 0, 0))).push_at(10, read_of(e.at(0, 1, 0)));
  // Then it waits for t_rtp after the last of the first line's two bursts.
  EXPECT_EQ(e.run()[1], 10 + 29 + 8 + 12 + 29 + 29 + 28 + burst + 1);
}

TEST(Dram, AStreamRunsAtThePeakOfTheBus) {
  // The queue holds more than a row, so that the next bank is opened while this one transfers.
  Memory m(config_of(1, 40));
  constexpr std::uint32_t lines = 1000;  // through all banks, several times
  for (std::uint32_t i = 0; i < lines; ++i) m.client.requests.push_at(9, read_of(Address{64} * i, i));
  EXPECT_EQ(m.run(), every(10 + 29 + 28 + burst + 1, lines, burst)) << "nothing is paid but the first access";
  EXPECT_EQ(m.dram.read_bytes(), lines * 64u);
  EXPECT_EQ(counter(m.dram, "bus_clocks"), lines * burst);
  EXPECT_EQ(counter(m.dram, "row_hits") + counter(m.dram, "row_misses") + counter(m.dram, "row_empty"), lines);
}

TEST(Dram, ChannelsWorkSideBySide) {
  for (std::uint32_t channels : {2u, 4u}) {
    Memory m(config_of(channels));
    constexpr std::uint32_t lines = 512;
    for (std::uint32_t i = 0; i < lines; ++i) m.client.requests.push_at(9, read_of(Address{64} * i, i));
    const auto cycles = m.run();
    ASSERT_EQ(cycles.size(), lines);
    for (std::uint32_t i = 0; i < lines; ++i) {
      // One request a clock is accepted, so channel c runs c clocks behind channel 0.
      ASSERT_EQ(cycles[i], 10 + 29 + 28 + burst + 1 + i / channels * burst + i % channels) << channels << " " << i;
    }
  }
}

TEST(Dram, TheBurstFollowsFromTheBus) {
  for (std::uint32_t bits : {8u, 16u, 32u, 64u}) {
    DramConfig config = config_of();
    config.bus_bits = bits;
    config.burst_length = 8;
    config.t_ccd_l = config.t_command = 1;
    Memory m(config);
    m.client.requests.push_at(9, read_of(64)).push_at(10, read_of(128));
    const auto cycles = m.run();
    EXPECT_EQ(cycles[1] - cycles[0], 64 * 8 / bits / 2) << bits;
  }
  DramConfig wide = config_of();
  wide.bus_bits = 128;
  wide.burst_length = 16;
  wide.t_command = 1;  // a burst is 256 bytes: a line pays for all of it
  Memory m(wide);
  m.client.requests.push_at(9, read_of(64)).push_at(10, read_of(128));
  const auto cycles = m.run();
  EXPECT_EQ(cycles[1] - cycles[0], 8u);
}

TEST(Dram, AcceptsNoMoreThanTheQueueHolds) {
  Memory m(config_of(1, 2));
  for (std::uint32_t i = 0; i < 4; ++i) m.client.requests.push_at(9, read_of(m.at(0, 0, i), i));
  // A request leaves the queue with its column command: 39, 55, ...; the next is there in time.
  EXPECT_EQ(m.run(), every(10 + 29 + 28 + burst + 1, 4, burst));
  Memory one(config_of(1, 1));
  for (std::uint32_t i = 0; i < 20; ++i) one.client.requests.push_at(9, read_of(one.at(i % 2, 0, i), i));
  // With one at a time no bank is opened ahead: the second waits for the first one's column command.
  EXPECT_EQ(one.run()[1] - one.run()[0], one.config.t_command + 29u);
}

TEST(Dram, AnswersComeInTheOrderOfTheirCommandsAndWritesAreAnsweredToo) {
  Memory m(config_of());
  m.client.requests.push_at(9, read_of(m.at(0, 0, 0), 1)).push_at(10, write_of(m.at(0, 1, 0), whole_line, 2));
  m.client.requests.push_at(11, read_of(m.at(1, 0, 0), 3));
  m.run();
  EXPECT_EQ(m.client.tags(), (std::vector<std::uint32_t>{1, 3, 2})) << "reads go before writes";
  EXPECT_EQ(m.dram.read_bytes(), 128u);
  EXPECT_EQ(m.dram.write_bytes(), 64u);
}

TEST(Dram, RowsAreClosedAtTheBeginningOfAFrame) {
  Memory m(config_of());
  m.client.requests.push_at(9, read_of(m.at(0, 7, 0)));
  const auto first = m.run();
  EXPECT_EQ(m.run(), first);
  EXPECT_EQ(counter(m.dram, "row_empty"), 1u);
}

TEST(Dram, WaitsForAFullResponseChannel) {
  Memory m(config_of());
  m.client.responses.open = [](Cycle now) { return now >= 5000; };
  for (std::uint32_t i = 0; i < 100; ++i) m.client.requests.push_at(9, read_of(Address{64} * i, i));
  const auto cycles = m.run();
  ASSERT_EQ(cycles.size(), 100u);
  EXPECT_EQ(cycles[0], 5000u);
  EXPECT_GT(m.dram.cycles_in(State::stall_out), 3000u);
}

TEST(Dram, ItsObserverSeesEachRequestInTheClockInWhichItIsTaken) {
  Memory m(config_of());
  std::vector<std::pair<Cycle, Address>> seen;
  m.dram.observe([&seen](Cycle cycle, const MemoryRequest& request) { seen.emplace_back(cycle, request.line); });
  m.client.requests.push_at(9, read_of(640)).push_at(9, write_of(128, whole_line)).push_at(99, read_of(64));
  m.run();
  EXPECT_EQ(seen, (std::vector<std::pair<Cycle, Address>>{{10, 640}, {11, 128}, {100, 64}}));
}

}  // namespace
}  // namespace artu::hw::test
