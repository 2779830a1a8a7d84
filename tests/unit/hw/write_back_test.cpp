// A cache above a DRAM: fills, write-backs and their acknowledgements share two channels.
#include <gtest/gtest.h>

#include "hw/memory/dram.h"
#include "unit/hw/memory_support.h"

namespace artu::hw::test {
namespace {

struct System {
  System(const CacheConfig& cache_config, const DramConfig& dram_config)
      : cache(bench.block<Cache>("cache", cache_config)),
        dram(bench.block<Dram>("dram", dram_config)),
        below(bench.link("below", cache_config.mshrs, 1, 1)),
        client(bench, "client", cache, 8, 1, cache_config.hit_latency) {
    below.bind(cache, dram);
    cache.bind_below(below);
    dram.bind(below);
    cache.add_client(client.link);
  }
  Bench bench;
  Cache& cache;
  Dram& dram;
  MemoryLink& below;
  Client client;
};

TEST(WriteBack, TrafficIsFillsAndWriteBacks) {
  System s({4096, 4, 10, 8, 8}, {});
  for (std::uint32_t i = 0; i < 600; ++i) {
    const Address line = 64 * (1 + i * 7919u % 300u);
    s.client.requests.push_at(1, i % 3 == 0 ? write_of(line, i % 2 == 0 ? whole_line : 0xff, i) : read_of(line, i));
  }
  s.bench.run(200000);
  EXPECT_EQ(s.client.responses.tokens.size(), 600u);
  EXPECT_TRUE(s.cache.quiet());
  EXPECT_EQ(s.dram.read_bytes(), s.cache.fills() * 64);
  EXPECT_EQ(s.dram.write_bytes(), s.cache.write_backs() * 64);
  EXPECT_GT(s.cache.write_backs(), 50u);
}

// A fill whose victim is dirty waits for room in the request channel; acknowledgements of write-backs, of which there
// is no limit, fill the response channel behind it, so that no channel of the DRAM can answer any more.
TEST(WriteBack, AFillWithADirtyVictimIsNotBlockedForEverByAcknowledgements) {
  DramConfig dram;
  dram.queue_depth = 2;
  System s({4096, 1, 2, 1, 4}, dram);  // one MSHR: request and response channel of two entries
  const auto line = [](Address number) { return number * 64; };
  // Dirty lines: 512 in set 0, victim of the fill; 1026 on channel 0; four more on channel 1, bank 0, row 1.
  const std::vector<Address> dirty{512, 1026, 513, 515, 517, 519};
  for (Address number : dirty) s.client.requests.push_at(1, write_of(line(number), whole_line));
  s.client.requests.push_at(50, read_of(line(21)));     // channel 1, bank 0: another row is open there
  s.client.requests.push_at(500, read_of(line(1024)));  // the fill, channel 0, same row as 1026
  for (Address number : {2050, 2049, 2051, 2053, 2055}) {
    s.client.requests.push_at(500, write_of(line(number), whole_line));  // each throws out one of the dirty lines
  }
  s.bench.run(100000);
  EXPECT_EQ(s.client.responses.tokens.size(), 13u);
  EXPECT_TRUE(s.cache.quiet());
}

}  // namespace
}  // namespace artu::hw::test
