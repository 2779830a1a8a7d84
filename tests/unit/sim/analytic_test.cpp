// The parts of `analytic`, each against what can be worked out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/analytic/build_time.h"
#include "sim/analytic/closed_network.h"
#include "sim/analytic/dram_service.h"
#include "sim/analytic/interleaving.h"
#include "sim/analytic/sampled_cache.h"

namespace artu::sim {
namespace {

using ::testing::DoubleNear;

TEST(ClosedNetwork, WithoutStationsEachCustomerTakesItsDelay) {
  EXPECT_THAT(closed_network({}, 1000, 4, 100, 1), DoubleNear(250, 1e-6));
  EXPECT_THAT(closed_network({{"a", 0, 1}}, 1000, 4, 100, 1), DoubleNear(250, 1e-6));
}

TEST(ClosedNetwork, OneCustomerNeverWaits) {
  EXPECT_THAT(closed_network({{"a", 300, 1}, {"b", 50, 2}}, 1000, 1, 100, 1), DoubleNear(1400, 1e-6));
}

TEST(ClosedNetwork, ManyCustomersAreHeldUpByTheBusiestStation) {
  const double time = closed_network({{"a", 300, 1}, {"b", 100, 1}}, 1000, 1000, 1e6, 1);
  EXPECT_GE(time, 300);
  EXPECT_LT(time, 303);
}

/// Two stations of the same demand and no delay, exponential: N customers use each to N / (N + 1).
TEST(ClosedNetwork, IsExactForBalancedNetworks) {
  for (const double customers : {2.0, 5.0, 20.0}) {
    const double time = closed_network({{"a", 100, 1}, {"b", 100, 1}}, 0, customers, 1e9, 1);
    EXPECT_THAT(time, DoubleNear(100 * (customers + 1) / customers, 0.1)) << customers;
  }
}

TEST(ClosedNetwork, MoreOfAnythingNeverHelpsAndMoreCustomersNeverHurt) {
  double before = 0;
  for (const double demand : {0, 50, 100, 150, 200, 250, 300, 350, 400, 450}) {
    const double time = closed_network({{"a", demand, 1}, {"b", 200, 4}}, 3000, 16, 1000, 0.9);
    EXPECT_GE(time, before);
    before = time;
  }
  before = 1e300;
  for (const double customers : {1, 2, 4, 8, 16, 32, 64}) {
    const double time = closed_network({{"a", 100, 1}, {"b", 200, 4}}, 3000, customers, 1000, 0.9);
    EXPECT_LE(time, before);
    before = time;
  }
}

TEST(ClosedNetwork, NothingToDoTakesNoTime) {
  EXPECT_EQ(closed_network({{"a", 0, 1}}, 0, 4, 0, 1), 0);
  EXPECT_EQ(closed_network({{"a", 0, 1}}, 0, 4, 10, 1), 0);
}

hw::CacheConfig cache(std::uint32_t size, std::uint32_t ways) {
  hw::CacheConfig config;
  config.size = size;
  config.ways = ways;
  return config;
}

/// Number n of the sampled lines.
std::uint64_t sampled(std::uint64_t n) { return n * sample_factor + 1; }

TEST(SampledCache, HoldsAShareOfTheLinesAndDropsTheLeastRecentlyUsed) {
  // 64 lines in 16 sets; the sample has 4 of the sets, 4 lines each.
  SampledCache tags(cache(4096, 4), 4096);
  SampledCache::Look look;
  for (std::uint64_t n = 0; n < 16; ++n) {
    look = tags.access(sampled(n), false, 0, 0);
    EXPECT_FALSE(look.hit);
  }
  for (std::uint64_t n = 0; n < 16; ++n) {
    look = tags.access(sampled(n), false, 0, 0);
    EXPECT_TRUE(look.hit) << n;
  }
  look = tags.access(sampled(0), false, 0, 0);
  look = tags.access(sampled(16), false, 0, 0);  // the set of 0, 4, 8, 12: 4 goes
  EXPECT_FALSE(look.hit);
  look = tags.access(sampled(0), false, 0, 0);
  EXPECT_TRUE(look.hit);
  look = tags.access(sampled(4), false, 0, 0);
  EXPECT_FALSE(look.hit);
}

TEST(SampledCache, TellsOfDirtyLinesThatGo) {
  SampledCache tags(cache(256, 1), 256);  // one line of the sample
  SampledCache::Look look;
  look = tags.access(sampled(3), true, 0, 0);
  EXPECT_FALSE(look.evicted_dirty);
  EXPECT_EQ(tags.dirty_lines(), 1u);
  look = tags.access(sampled(5), false, 0, 0);
  EXPECT_TRUE(look.evicted_dirty);
  EXPECT_EQ(tags.evicted(), sampled(3));
  EXPECT_EQ(tags.dirty_lines(), 0u);
}

TEST(SampledCache, RequestsForALineOnItsWayAreMerged) {
  SampledCache tags(cache(4096, 4), 4096);
  SampledCache::Look look;
  look = tags.access(sampled(1), false, 100, 40);
  look = tags.access(sampled(1), false, 139, 40);
  EXPECT_TRUE(look.hit && look.merged);
  look = tags.access(sampled(1), false, 140, 40);
  EXPECT_TRUE(look.hit && !look.merged);
  tags.drop(sampled(1));
  look = tags.access(sampled(1), false, 200, 40);
  EXPECT_FALSE(look.hit);
}

TEST(DramService, OneReadAtATimeTakesTheAccessLatency) {
  hw::UnitConfig config;
  const hw::DramConfig& dram = config.memory.dram;
  const DramService service(config, {1000, 0, 0});
  const double clock = 500.0 / dram.clock_mhz, data = bus_cycles(config) * dram.channels;
  EXPECT_GT(service.alone(), dram.t_cl * clock + data);
  EXPECT_LT(service.alone(), (dram.t_rcd + dram.t_cl) * clock + 4 * data);
}

TEST(DramService, IsNoFasterThanItsBusesAndSlowerWithMoreTraffic) {
  hw::UnitConfig config;
  config.memory.l2.mshrs = 256;
  const DramService reads(config, {1000, 0, 100}), both(config, {1000, 1000, 200}), misses(config, {1000, 0, 1000});
  EXPECT_LE(reads.most(), 1 / bus_cycles(config));
  EXPECT_GT(reads.most(), 0.7 / bus_cycles(config));
  EXPECT_LT(both.most(), reads.most());
  EXPECT_LT(misses.most(), reads.most());
  double before = 0;
  for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    const double response = reads.response(share * reads.most());
    EXPECT_GE(response, before);
    before = response;
  }
}

TEST(BuildTime, IsTheComputingWhereThatIsMore) {
  hw::UnitConfig config;
  hw::FrameDescriptor frame{};
  frame.dynamic_kind = hw::TreeKind::bvh2;
  frame.dynamic_triangle_count = frame.dynamic_reference_count = 1000;
  frame.dynamic_node_lines = 500;
  frame.build_input = 1 << 20;
  frame.build_scratch = 2 << 20;
  frame.dynamic_nodes = 3 << 20;
  frame.dynamic_triangles = 4 << 20;
  frame.dynamic_attributes = 5 << 20;
  frame.build.splits = 500;
  frame.build.references = 100000;
  MemoryModel memory(config);
  std::uint64_t compute = 0;
  for (const hw::BuildStep& step : hw::plan_build(config.tree_builder, frame)) compute += step.compute;
  const BuildTime slow = build_time(config, frame, memory);
  EXPECT_GT(slow.cycles, compute);
  EXPECT_LT(slow.cycles, compute * 1.1);

  config.tree_builder.cycles_per_triangle = config.tree_builder.cycles_per_bin = 1;
  config.tree_builder.binning_units = 64;
  frame.build.references = 1000;
  MemoryModel other(config);
  const BuildTime fast = build_time(config, frame, other);
  EXPECT_GE(static_cast<double>(fast.cycles), static_cast<double>(fast.dram) * bus_cycles(config));
}

TEST(Interleaving, PixelsBeginWhenAContextIsFree) {
  hw::UnitConfig config;
  config.core.count = 2;
  config.core.contexts = 1;
  MemoryModel memory(config);
  Interleaving order(config, 64, memory);
  for (int i = 0; i < 4; ++i) {
    order.begin_pixel(static_cast<std::uint32_t>(i), 0);
    order.advance(100);
    order.end_pixel();
  }
  // Two cores, two pixels each, the first of which begin a cycle apart.
  EXPECT_GE(order.end(), 200u);
  EXPECT_LE(order.end(), 203u);
  EXPECT_THAT(order.imbalance(), DoubleNear(1, 1e-9));
}

TEST(Interleaving, WhatIsAskedEarlierPassesEarlier) {
  hw::UnitConfig config;
  config.core.count = 1;
  config.core.contexts = 2;
  config.core.node_cache = cache(256, 1);  // one line of the sample
  MemoryModel memory(config);
  Interleaving order(config, 64, memory);
  // The first pixel asks for A early and late; the second for B in between: A is fetched twice.
  order.begin_pixel(0, 0);
  order.read(Client::node, sampled(1));
  order.advance(1000);
  order.read(Client::node, sampled(1));
  order.end_pixel();
  order.begin_pixel(1, 0);
  order.advance(500);
  order.read(Client::node, sampled(2));
  order.end_pixel();
  EXPECT_LT(memory.counts().client[0].requests, 3u);
  order.drain();
  EXPECT_EQ(memory.counts().client[0].requests, 3u);
  EXPECT_EQ(memory.counts().client[0].misses, 3u);
}

TEST(Interleaving, TilesThatAllFallToOneCoreLoadItAlone) {
  hw::UnitConfig config;
  config.core.count = 4;
  config.core.dispatch = hw::Dispatch::tiles;
  MemoryModel memory(config);
  Interleaving order(config, 16, memory);  // one column of tiles
  for (std::uint32_t i = 0; i < 8; ++i) {
    order.begin_pixel(i, 0);
    order.advance(100);
    order.end_pixel();
  }
  EXPECT_THAT(order.imbalance(), DoubleNear(4, 1e-9));
}

}  // namespace
}  // namespace artu::sim
