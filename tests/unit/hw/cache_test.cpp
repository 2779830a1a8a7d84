// Reads through a cache: latency, throughput, misses, replacement.
#include <gtest/gtest.h>

#include "unit/hw/memory_support.h"

namespace artu::hw::test {
namespace {

constexpr Cycle memory_latency = CacheBench::memory_latency;

/// 4 sets of 2 ways.
CacheConfig small(std::uint32_t hit_latency = 2, std::uint32_t mshrs = 4, std::uint32_t targets = 4) {
  return {512, 2, hit_latency, mshrs, targets};
}

class CacheLatency : public testing::TestWithParam<std::uint32_t> {};

TEST_P(CacheLatency, AHitIsAnsweredHitLatencyAfterItsArrival) {
  const std::uint32_t hit_latency = GetParam();
  CacheBench b(small(hit_latency));
  b.client().requests.push_at(1, read_of(b.line(0, 0))).push_at(100, read_of(b.line(0, 0)));
  b.bench.run(200);
  ASSERT_EQ(b.client().responses.cycles.size(), 2u);
  // The miss: arrival 2, at the memory 3, back after its latency, then as a hit.
  EXPECT_EQ(b.client().responses.cycles[0], 3 + memory_latency + hit_latency);
  EXPECT_EQ(b.client().responses.cycles[1], Cycle{101} + hit_latency);
  EXPECT_EQ(b.memory.lines(), std::vector<Address>{b.line(0, 0)});
}

TEST_P(CacheLatency, HitsAreServedOneACycle) {
  CacheBench b(small(GetParam()));
  b.client().requests.push_at(1, read_of(b.line(1, 0), 1000));
  for (std::uint32_t i = 0; i < 64; ++i) b.client().requests.push_at(100, read_of(b.line(1, 0), i));
  b.bench.run(300);
  auto cycles = b.client().responses.cycles;
  cycles.erase(cycles.begin());
  EXPECT_EQ(cycles, every(Cycle{101} + GetParam(), 64));
  EXPECT_EQ(b.cache.hits(), 64u);
}

INSTANTIATE_TEST_SUITE_P(HitLatencies, CacheLatency, testing::Values(1, 2, 10));

TEST(Cache, MissesOnTheSameLineAreOneFill) {
  CacheBench b(small());
  for (std::uint32_t i = 0; i < 4; ++i) b.client().requests.push_at(1 + i, read_of(b.line(0, 0), i));
  b.bench.run(100);
  EXPECT_EQ(b.memory.cycles, std::vector<Cycle>{3});
  EXPECT_EQ(b.client().tags(), (std::vector<std::uint32_t>{0, 1, 2, 3}));
  EXPECT_EQ(b.client().responses.cycles, every(3 + memory_latency + 2, 4));  // one answer a cycle
  EXPECT_EQ(b.cache.misses(), 4u);
  EXPECT_EQ(counter(b.cache, "merged_misses"), 3u);
  EXPECT_EQ(b.cache.fills(), 1u);
}

TEST(Cache, ARequestBeyondTheTargetsOfALineWaitsForItsFill) {
  CacheBench b(small(2, 4, 2));
  for (std::uint32_t i = 0; i < 3; ++i) b.client().requests.push_at(1 + i, read_of(b.line(0, 0), i));
  b.bench.run(100);
  // The third: when the fill's targets are answered (23 and 24) it is served as a hit, in 25.
  const Cycle fill = 3 + memory_latency;
  EXPECT_EQ(b.client().responses.cycles, (std::vector<Cycle>{fill + 2, fill + 3, fill + 4}));
  EXPECT_EQ(b.cache.hits(), 1u);
}

TEST(Cache, IndependentMissesOverlapUpToTheMshrs) {
  CacheBench b(small(2, 3));
  for (std::uint32_t i = 0; i < 4; ++i) b.client().requests.push_at(1, read_of(b.line(i, 0), i));
  b.bench.run(200);
  // Three go out in 2, 3, 4; the fourth when the first is answered, in 23: sent in the cycle after that.
  const Cycle fill = 3 + memory_latency;
  EXPECT_EQ(b.memory.cycles, (std::vector<Cycle>{3, 4, 5, fill + 2 + 2}));
  EXPECT_EQ(b.client().tags(), (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

TEST(Cache, AHitGoesAheadOfAnOutstandingMiss) {
  CacheBench b(small());
  b.client().requests.push_at(1, read_of(b.line(0, 0), 1));
  b.client().requests.push_at(100, read_of(b.line(1, 0), 2)).push_at(101, read_of(b.line(0, 0), 3));
  b.bench.run(200);
  EXPECT_EQ(b.client().tags(), (std::vector<std::uint32_t>{1, 3, 2}));
  EXPECT_EQ(b.client().responses.cycles[1], 102u + 2);
}

TEST(Cache, ABlockedClientDoesNotKeepAnotherFromBeingServed) {
  CacheBench b(small(2, 1), 2);
  b.client(0).requests.push_at(1, read_of(b.line(0, 0), 1));
  // Client 0 misses twice with one MSHR; client 1 hits all the while.
  b.client(0).requests.push_at(100, read_of(b.line(1, 0), 2)).push_at(101, read_of(b.line(2, 0), 3));
  for (std::uint32_t i = 0; i < 10; ++i) b.client(1).requests.push_at(104 + i, read_of(b.line(0, 0), i));
  b.bench.run(200);
  EXPECT_EQ(b.client(1).responses.cycles, every(105 + 2, 10));
  EXPECT_EQ(b.client(0).tags(), (std::vector<std::uint32_t>{1, 2, 3}));
}

TEST(Cache, ClientsThatBothWantTakeTurns) {
  CacheBench b(small(), 2);
  b.client(0).requests.push_at(1, read_of(b.line(0, 0)));
  for (std::uint32_t i = 0; i < 5; ++i) {
    b.client(0).requests.push_at(100, read_of(b.line(0, 0), i));
    b.client(1).requests.push_at(100, read_of(b.line(0, 0), i));
  }
  b.bench.run(200);
  // Client 0 was the last one granted: client 1 comes first.
  EXPECT_EQ(b.client(1).responses.cycles, every(103, 5, 2));
  EXPECT_EQ(std::vector<Cycle>(b.client(0).responses.cycles.begin() + 1, b.client(0).responses.cycles.end()),
            every(104, 5, 2));
}

/// Reads lines k of set 0, far apart in time; returns the ones that were fetched.
std::vector<std::uint32_t> fetched(CacheBench& b, const std::vector<std::uint32_t>& pattern) {
  Cycle at = 1;
  for (std::uint32_t k : pattern) b.client().requests.push_at(at += 100, read_of(b.line(0, k)));
  b.bench.run(at + 100);
  std::vector<std::uint32_t> result;
  for (Address line : b.memory.lines()) result.push_back(static_cast<std::uint32_t>(line / 64 / b.sets - 1));
  return result;
}

TEST(Cache, TheLeastRecentlyUsedLineGoes) {
  CacheBench b(small());
  // 0, 1 fill the set; 0 is used again, so 2 replaces 1; then 1 replaces 0 (used before 2), and 2 is still there.
  EXPECT_EQ(fetched(b, {0, 1, 0, 2, 0, 2, 1, 2, 0}), (std::vector<std::uint32_t>{0, 1, 2, 1, 0}));
}

TEST(Cache, AWorkingSetOfAllWaysIsMissedOnceAndOneMoreLineIsMissedAlways) {
  std::vector<std::uint32_t> fits, thrashes;
  for (int round = 0; round < 10; ++round) {
    for (std::uint32_t k = 0; k < 4; ++k) fits.push_back(k);
    for (std::uint32_t k = 0; k < 5; ++k) thrashes.push_back(k);
  }
  const CacheConfig four_ways{1024, 4, 2, 4, 4};
  CacheBench good(four_ways), bad(four_ways);
  EXPECT_EQ(fetched(good, fits).size(), 4u);
  EXPECT_EQ(good.cache.hits(), 36u);
  EXPECT_EQ(fetched(bad, thrashes).size(), 50u);
}

CacheConfig with(ReplacementPolicy policy, std::uint32_t ways, std::uint32_t seed = 1) {
  CacheConfig config{64 * ways, ways, 2, 4, 4};  // one set
  config.replacement = policy;
  config.seed = seed;
  return config;
}

TEST(Cache, PseudoLruFollowsItsTreeOfBits) {
  CacheBench b(with(ReplacementPolicy::plru, 4));
  // 0 ... 3 fill the ways.  Using 0 points the root right and its left node at way 1; the right node still points at
  // way 2, so 4 replaces 2, where LRU would have replaced 1.
  EXPECT_EQ(fetched(b, {0, 1, 2, 3, 0, 4, 1, 2}), (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 2}));
  CacheBench two(with(ReplacementPolicy::plru, 2)), lru(with(ReplacementPolicy::lru, 2));
  const std::vector<std::uint32_t> pattern{0, 1, 0, 2, 0, 1, 2, 2, 0, 1, 0, 3, 1, 0};
  EXPECT_EQ(fetched(two, pattern), fetched(lru, pattern)) << "with two ways there is no difference";
}

TEST(Cache, RandomReplacementFollowsItsSeedAndDoesNotThrash) {
  std::vector<std::uint32_t> pattern;
  for (int round = 0; round < 60; ++round) {
    for (std::uint32_t k = 0; k < 5; ++k) pattern.push_back(k);
  }
  CacheBench a(with(ReplacementPolicy::random, 4)), again(with(ReplacementPolicy::random, 4)),
      other(with(ReplacementPolicy::random, 4, 2)), lru(with(ReplacementPolicy::lru, 4));
  const auto fetches = fetched(a, pattern);
  EXPECT_EQ(fetched(again, pattern), fetches);
  EXPECT_NE(fetched(other, pattern), fetches);
  // Of a cycle of n + 1 lines LRU keeps none; random keeps many.
  EXPECT_EQ(fetched(lru, pattern).size(), pattern.size());
  EXPECT_LT(fetches.size(), pattern.size() * 2 / 3);
  EXPECT_GT(fetches.size(), pattern.size() / 5);
}

TEST(Cache, AHashSpreadsLinesThatWouldShareASet) {
  // Eight lines, a cache's size apart: one set of two ways without the hash, all four sets with it.
  for (bool hashed : {false, true}) {
    CacheConfig config = small();
    config.hashed = hashed;
    CacheBench b(config);
    std::vector<std::uint32_t> pattern;
    for (int round = 0; round < 2; ++round) {
      for (std::uint32_t k = 7; k < 15; ++k) pattern.push_back(k);
    }
    EXPECT_EQ(fetched(b, pattern).size(), hashed ? 8u : 16u);
  }
}

TEST(Cache, AStreamMissesOnceALine) {
  CacheBench b(small(2, 4, 4));
  for (std::uint32_t i = 0; i < 256; ++i) b.client().requests.push_at(1 + 30 * i, read_of(4096 + i / 4 * 64));
  b.bench.run(10000);
  EXPECT_EQ(b.cache.misses(), 64u);
  EXPECT_EQ(b.cache.hits(), 192u);
}

TEST(Cache, WaitsForAFullResponseChannelWithoutLosingAnything) {
  CacheBench b(small());
  b.client().responses.open = [](Cycle now) { return now > 200; };
  for (std::uint32_t i = 0; i < 30; ++i) b.client().requests.push_at(1 + i, read_of(b.line(i % 4, 0), i));
  b.bench.run(400);
  EXPECT_EQ(b.client().responses.cycles, every(201, 30));
  EXPECT_GT(b.cache.cycles_in(State::stall_out), 100u);
}

TEST(Cache, ForgetsEverythingAtTheBeginningOfAFrame) {
  CacheBench b(small());
  b.client().requests.push_at(1, read_of(b.line(0, 0)));
  for (int frame = 0; frame < 2; ++frame) {
    b.bench.run(100);
    EXPECT_EQ(b.cache.misses(), 1u);
    EXPECT_EQ(b.cache.hits(), 0u);
  }
}

}  // namespace
}  // namespace artu::hw::test
