// The DRAM controller: scheduling, bounds of the part, refresh, policies, mappings.
#include <gtest/gtest.h>

#include <set>

#include "unit/hw/dram_support.h"

namespace artu::hw::test {
namespace {

constexpr Cycle burst = 16;

DramConfig config_of(DramPreset preset = DramPreset::lpddr4_3200) {
  DramConfig config;
  apply(preset, config);
  config.channels = 1;
  config.queue_depth = 64;
  config.refresh = RefreshPolicy::none;
  config.bank_hash = false;
  return config;
}

using Memory = DramBench;

TEST(DramController, AnOpenRowGoesBeforeAnOlderRequestToAnotherRow) {
  Memory m(config_of());
  m.read(10, m.at(0, 0, 0), 1).read(11, m.at(0, 1, 0), 2).read(12, m.at(0, 0, 1), 3);
  m.run();
  EXPECT_EQ(m.client.tags(), (std::vector<std::uint32_t>{1, 3, 2}));
  EXPECT_EQ(m.count("row_hits"), 1u);
  EXPECT_EQ(m.count("row_misses"), 1u);
  EXPECT_EQ(m.count("row_empty"), 1u);
}

TEST(DramController, OrFirstComeFirstServedWithAStarvationOfOneClock) {
  DramConfig config = config_of();
  config.starvation = 1;
  Memory m(config);
  m.read(10, m.at(0, 0, 0), 1).read(11, m.at(0, 1, 0), 2).read(12, m.at(0, 0, 1), 3);
  m.run();
  EXPECT_EQ(m.client.tags(), (std::vector<std::uint32_t>{1, 2, 3}));
}

TEST(DramController, NoRequestWaitsForLongerThanTheStarvationAndItsOwnAccess) {
  DramConfig config = config_of();
  config.starvation = 500;
  Memory m(config);
  for (Cycle i = 0; i < 400; ++i) {
    if (i == 6) m.read(100, m.at(0, 1, 0), 2);
    m.read(10 + 16 * i, m.at(0, 0, i % 32), 1);
  }
  const auto cycles = m.run();
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    if (m.client.tags()[i] != 2) continue;
    EXPECT_GT(cycles[i], 600u) << "the others' row is open";
    EXPECT_LE(cycles[i], 100 + 500 + 2 * burst + 12 + 29 + 29 + 28 + burst + 2);
  }
}

TEST(DramController, BanksOpenSideBySideWithinTheLimitsOfActivates) {
  DramConfig config = config_of();
  config.t_command = 1;
  Memory m(config);
  for (std::uint32_t bank = 0; bank < 8; ++bank) m.read(10, m.at(bank, 0), bank);
  const auto cycles = m.run();
  // Activates at 10, 26, 42, 58 (t_rrd), the fifth at 10 + t_faw: here the same; each line's data follow at once.
  EXPECT_EQ(cycles, every(10 + 29 + 28 + burst + 1, 8, 16));
  DramConfig narrow = config_of();
  narrow.t_faw = 200;
  Memory w(narrow);
  for (std::uint32_t bank = 0; bank < 8; ++bank) w.read(10, w.at(bank, 0), bank);
  EXPECT_EQ(w.run()[4] - w.run()[0], 200u);
}

TEST(DramController, WritesThenReadsPayTheTurn) {
  Memory m(config_of());
  m.write(10, m.at(0, 0, 0), 1).read(40, m.at(0, 0, 1), 2);
  // Write: activate 10, command 39, data to 39 + 14 + 16 = 69; read command t_wtr later.
  EXPECT_EQ(m.run(), (std::vector<Cycle>{69 + 1, 69 + 16 + 28 + burst + 1}));
  Memory r(config_of());
  r.read(10, r.at(0, 0, 0), 1).write(11, r.at(0, 0, 1), 2);
  // Read data end at 39 + 28 + 16 = 83; the write's follow after t_turn.
  EXPECT_EQ(r.run(), (std::vector<Cycle>{83 + 1, 83 + 2 + burst + 1}));
}

TEST(DramController, WritesGatherUntilTheHighMark) {
  DramConfig config = config_of();
  config.write_high = 8;
  config.write_low = 2;
  config.starvation = 100000;
  Memory m(config);
  for (Cycle i = 0; i < 40; ++i) m.read(10, m.at(0, 0, i % 32), 1);  // so that reads never run out
  for (Cycle i = 4; i < 300; ++i) {
    m.read(10 + 16 * i, m.at(0, 0, i % 32), 1);
    if (i % 6 == 0 && i < 150) m.write(10 + 16 * i, m.at(1, 0, i / 6), 2);
  }
  m.run();
  // From 8 to 2 three times while there are reads, and what is left at the end.
  EXPECT_LE(m.count("turns"), 8u);
  EXPECT_GE(m.count("turns"), 6u);
  EXPECT_EQ(m.dram.write_bytes(), 24u * 64);
}

TEST(DramController, AWriteWaitsForNoLongerThanTheStarvation) {
  DramConfig config = config_of();
  config.starvation = 600;
  Memory m(config);
  // Reads that never end, and fewer writes than the high mark.
  for (Cycle i = 0; i < 300; ++i) {
    m.read(10 + 16 * i, m.at(0, 0, i % 32), 1);
    if (i == 5) m.write(90, m.at(1, 0, 0), 2);
  }
  const auto cycles = m.run();
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    if (m.client.tags()[i] != 2) continue;
    EXPECT_GT(cycles[i], 690u);
    EXPECT_LT(cycles[i], 690u + 200);
  }
  DramConfig in_order = config;
  in_order.starvation = 1;
  Memory f(in_order);
  f.read(10, f.at(0, 0, 0), 1).write(11, f.at(0, 0, 1), 2).read(12, f.at(0, 0, 2), 3).write(13, f.at(0, 0, 3), 4);
  f.run();
  EXPECT_EQ(f.client.tags(), (std::vector<std::uint32_t>{1, 2, 3, 4})) << "first come, first served, both ways";
}

TEST(DramController, AReadOfALineThatWaitsToBeWrittenIsAnsweredFromTheQueue) {
  DramConfig config = config_of();
  Memory m(config);
  m.read(10, m.at(0, 0, 0), 1).write(11, m.at(0, 3, 0), 2).read(12, m.at(0, 3, 0), 3);
  const auto cycles = m.run();
  EXPECT_EQ(m.client.tags()[0], 3u);
  EXPECT_EQ(cycles[0], 14u);
  EXPECT_EQ(m.count("forwarded"), 1u);
}

TEST(DramController, ReadClocksAreTheReadsLatencies) {
  Memory m(config_of());
  m.read(10, m.at(0, 0, 0), 1).write(300, m.at(0, 3, 0), 2).read(301, m.at(0, 3, 0), 3).read(900, m.at(0, 3, 1), 4);
  m.run();
  // No row open: t_rcd, t_cl, data.  From the queue: one clock.  The row that the write opened: t_cl, data.
  EXPECT_EQ(m.count("read_clocks"), (29 + 28 + burst) + 1 + (28 + burst));
}

TEST(DramController, AStreamGetsThePeakLessTheRefresh) {
  for (RefreshPolicy policy : {RefreshPolicy::all_bank, RefreshPolicy::per_bank}) {
    DramConfig config = config_of();
    config.refresh = policy;
    Memory m(config);
    constexpr std::uint32_t lines = 4000;
    for (std::uint32_t i = 0; i < lines; ++i) m.read(10, Address{64} * i, i);
    const Cycle end = m.run(200000).back();
    const double clocks = static_cast<double>(end - 10), data = lines * static_cast<double>(burst);
    EXPECT_GE(m.count("refreshes"), policy == RefreshPolicy::all_bank ? 9u : 70u);
    if (policy == RefreshPolicy::all_bank) {
      // Each costs t_rfc, the open rows' end (t_rtp, t_rp_all) and the first access after it (t_rcd, t_cl).
      const double each = 448 + 34 + 29 + 28 + 12 + 2 * burst;
      EXPECT_GT(clocks, data + 448.0 * static_cast<double>(m.count("refreshes")));
      EXPECT_LT(clocks, data + 100 + each * static_cast<double>(m.count("refreshes")));
    } else {
      EXPECT_LT(clocks, data * 1.15) << "the other banks go on";
    }
  }
}

TEST(DramController, ARefreshClosesTheRowAndTakesItsTime) {
  DramConfig config = config_of();
  config.refresh = RefreshPolicy::all_bank;
  Memory m(config);
  m.read(10, m.at(0, 0, 0)).read(config.t_refi + 100, m.at(0, 0, 1));
  // Precharge all at t_refi, refresh, then as for the first access.
  EXPECT_EQ(m.run()[1], 6247 + 34 + 448 + 29 + 28 + burst + 1);
  EXPECT_EQ(m.count("refreshes"), 1u);
  Memory late(config);
  late.read(10, late.at(0, 0, 0)).read(10 * 6247 + 3000, late.at(0, 0, 1));
  EXPECT_EQ(late.run()[1], 10 * 6247 + 3000 + 29 + 28 + burst + 1) << "refreshes while nothing waits cost nothing";
  EXPECT_EQ(late.count("refreshes"), 10u);
}

TEST(DramController, BankByBankEachIsRefreshedInItsTurn) {
  DramConfig config = config_of();
  config.refresh = RefreshPolicy::per_bank;
  const Cycle interval = config.t_refi / config.banks;
  // Two banks are opened before the first refresh, which is bank 0's; the second one is bank 1's.
  const auto row_hits = [&](std::uint32_t bank, Cycle at) {
    Memory m(config);
    m.read(10, m.at(0, 0, 0)).read(11, m.at(1, 0, 0)).read(at, m.at(bank, 0, 1));
    m.run();
    return m.count("row_hits");
  };
  const Cycle after_first = interval + 300, after_second = 2 * interval + 300;
  ASSERT_LT(after_first, 2 * interval);
  EXPECT_EQ(row_hits(0, after_first), 0u);
  EXPECT_EQ(row_hits(1, after_first), 1u);
  EXPECT_EQ(row_hits(1, after_second), 0u);
  EXPECT_EQ(row_hits(0, after_second), 0u);
}

TEST(DramController, RowPoliciesCloseRows) {
  DramConfig closed = config_of();
  closed.row_policy = RowPolicy::closed;
  Memory c(closed);
  c.read(10, c.at(0, 0, 0)).read(1000, c.at(0, 1, 0));
  EXPECT_EQ(c.run()[1], 1000 + 29 + 28 + burst + 1) << "no precharge to wait for";
  EXPECT_EQ(c.count("row_empty"), 2u);

  DramConfig timeout = config_of();
  timeout.row_policy = RowPolicy::timeout;
  timeout.row_timeout = 200;
  Memory t(timeout);
  t.read(10, t.at(0, 0, 0)).read(150, t.at(0, 0, 1)).read(1000, t.at(0, 0, 2));
  const auto cycles = t.run();
  EXPECT_EQ(cycles[1], 150 + 28 + burst + 1) << "still open";
  EXPECT_EQ(cycles[2], 1000 + 29 + 28 + burst + 1) << "closed, long ago";
}

TEST(DramController, AShortTimeoutClosesNoRowThatIsWaitedFor) {
  DramConfig config = config_of();
  config.row_policy = RowPolicy::timeout;
  config.row_timeout = 1;
  config.t_ras = 1;  // the row may be closed long before its first column command
  Memory m(config);
  m.read(10, m.at(0, 0, 0)).read(1000, m.at(0, 0, 1));
  const auto cycles = m.run();
  EXPECT_EQ(cycles[0], 10 + 29 + 28 + burst + 1);
  EXPECT_EQ(cycles[1], 1000 + 29 + 28 + burst + 1) << "closed in between";
  EXPECT_EQ(m.count("activates"), 2u);
}

TEST(DramController, BankGroupsSpaceTheirColumns) {
  DramConfig config = config_of(DramPreset::lpddr5_6400);
  Memory same(config), turn(config);
  for (std::uint32_t i = 0; i < 20; ++i) same.read(10, same.at(0, 0, i), i);
  for (std::uint32_t i = 0; i < 20; ++i) turn.read(10, turn.at(i % 4, 0, i), i);
  const auto slow = same.run(), fast = turn.run();
  // A line is two bursts of 8 clocks; in a group the next command follows t_ccd_l = 16 after the last one.
  EXPECT_EQ(slow[19] - slow[18], 8u + 16u);
  EXPECT_EQ(fast[19] - fast[18], 16u);
}

TEST(DramController, PresetsHaveThePartsPeakAndLatency) {
  const struct {
    DramPreset preset;
    double gigabytes, nanoseconds;  // peak of a 16-bit channel; activate to first data, by the data sheets
  } parts[] = {{DramPreset::lpddr4_3200, 6.4, 18 + 17.5},
               {DramPreset::lpddr4x_4266, 8.532, 18 + 16.9},
               {DramPreset::lpddr5_6400, 12.8, 18.75 + 25}};
  for (const auto& part : parts) {
    const DramConfig config = config_of(part.preset);
    EXPECT_NEAR(config.clock_mhz * 2.0 * config.bus_bits / 8 / 1000, part.gigabytes, 0.01);
    Memory m(config);
    m.read(10, 0);
    const double clocks = static_cast<double>(m.run()[0] - 10 - burst - 1);
    EXPECT_NEAR(clocks * 1000 / config.clock_mhz, part.nanoseconds, 1.0);
  }
}

TEST(DramController, EveryMappingPlacesEveryLineOnce) {
  for (DramMapping mapping : {DramMapping::row_bank_column_channel, DramMapping::row_column_bank_channel,
                              DramMapping::row_bank_channel_column}) {
    for (bool hash : {false, true}) {
      DramConfig config = config_of();
      config.channels = 4;
      config.mapping = mapping;
      config.bank_hash = hash;
      std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint64_t>, std::uint32_t> lines;
      const std::uint32_t rows = 16, columns = config.row_bytes / 64;
      for (std::uint32_t i = 0; i < rows * columns * config.banks * config.channels; ++i) {
        const DramPlace place = place_of_line(config, i);
        ++lines[{place.channel, place.bank, place.row}];
      }
      EXPECT_EQ(lines.size(), std::size_t{rows} * config.banks * config.channels);
      for (const auto& [place, count] : lines) EXPECT_EQ(count, columns);
    }
  }
  DramConfig config = config_of();
  config.channels = 2;
  EXPECT_NE(place_of_line(config, 0).channel, place_of_line(config, 1).channel);
  config.mapping = DramMapping::row_column_bank_channel;
  EXPECT_NE(place_of_line(config, 0).bank, place_of_line(config, 2).bank);
  config.mapping = DramMapping::row_bank_channel_column;
  EXPECT_EQ(place_of_line(config, 0).channel, place_of_line(config, 31).channel);
  EXPECT_NE(place_of_line(config, 0).channel, place_of_line(config, 32).channel);
}

/// Requests that hit every rule, with an odd configuration.
TEST(DramController, EveryRequestIsAnsweredOnce) {
  for (std::uint32_t variant = 0; variant < 12; ++variant) {
    DramConfig config = config_of(static_cast<DramPreset>(variant % 3));
    config.channels = 1u << variant % 3;
    config.refresh = static_cast<RefreshPolicy>(variant % 3);
    config.row_policy = static_cast<RowPolicy>(variant / 3 % 3);
    config.queue_depth = 1 + variant;
    config.write_queue_depth = 4;
    config.write_high = 3;
    config.write_low = 1;
    config.starvation = 50 + 100 * variant;
    config.bank_hash = variant % 2 != 0;
    Memory m(config);
    std::uint32_t random = 7 + variant;
    for (std::uint32_t i = 0; i < 3000; ++i) {
      random = random * 1664525 + 1013904223;
      const Address line = Address{random >> 14} * 64;
      const Cycle cycle = 10 + i * (variant % 4 == 0 ? 40 : 3);
      if ((random >> 9 & 3) == 0) {
        m.write(cycle, line, i);
      } else {
        m.read(cycle, line, i);
      }
    }
    m.run(1000000);
    const auto tags = m.client.tags();
    EXPECT_EQ(std::set<std::uint32_t>(tags.begin(), tags.end()).size(), 3000u) << variant;
    EXPECT_EQ(m.count("row_hits") + m.count("row_misses") + m.count("row_empty") + m.count("forwarded"), 3000u);
    EXPECT_EQ(m.count("reads") + m.count("writes") + m.count("forwarded"), 3000u);
    EXPECT_EQ(m.count("bus_clocks"), (3000 - m.count("forwarded")) * burst);
    EXPECT_GE(m.count("activates"), m.count("row_misses") + m.count("row_empty"));
    EXPECT_LE(m.count("precharges"), m.count("activates"));
  }
}

}  // namespace
}  // namespace artu::hw::test
