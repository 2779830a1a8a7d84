// Traversal with few stack entries on chip, and while the dynamic tree is being built.
#include <gtest/gtest.h>

#include "unit/hw/traversal_support.h"

namespace artu::hw::test {
namespace {

/// A chain of nodes: one child is the next node, the other a leaf behind it.  A ray at x = 1 hits the boxes and none of
/// the triangles, so it pushes an entry at every node but the last two children, and pops them all.
constexpr std::uint32_t depth = 30;
void chain(CoreScene& scene) {
  for (std::uint32_t i = 0; i < depth; ++i) {
    scene.triangle(false, i, 1, 100 + i, 50);
    const std::uint32_t next = i + 1 < depth ? inner(i + 1, false) : leaf(depth, 1, false);
    scene.node(false, i, {next, 5, 6}, {leaf(i, 1, false), 1, 2});
  }
  scene.triangle(false, depth, 5, 100 + depth, 50);
  scene.root(false, inner(0, false));
}

RayCoreConfig short_stack(StackOverflow overflow, std::uint32_t entries) {
  RayCoreConfig config;
  config.stack_overflow = overflow;
  config.stack_entries = entries;
  return config;
}

TEST(ShortStack, SpillsALineOfEightEntriesAtATimeAndReadsEachBackOnce) {
  for (std::uint32_t entries : {8u, 9u, 16u, 29u, 30u}) {
    Walker w(64, short_stack(StackOverflow::spill, entries));
    chain(w.scene);
    w.scene.ray(0, 1, 1);
    w.run(1);
    EXPECT_EQ(w.misses.tokens, std::vector<Slot>{0});
    EXPECT_EQ(counter(w.traversal, "stack_pushes"), depth);
    // The first line goes with entry entries + 1, the others every 8 entries.
    const std::uint64_t lines = entries >= depth ? 0 : (depth - entries + 7) / 8;
    EXPECT_EQ(counter(w.traversal, "spilled_lines"), lines) << entries;
    EXPECT_EQ(counter(w.traversal, "refilled_lines"), lines);
    EXPECT_EQ(counter(w.traversal, "leaves"), depth + 1);
    EXPECT_EQ(w.traversal.node_visits(), depth);
    EXPECT_EQ(w.spill_memory.requests.size(), 2 * lines);
  }
}

TEST(ShortStack, SpilledLinesLieInTheContextsOwnAreaAndAreReadLastInFirstOut) {
  Walker w(64, short_stack(StackOverflow::spill, 8));
  chain(w.scene);
  w.scene.registers.descriptor.stack_spills = 0x10000;
  w.scene.ray(3, 1, 1);
  w.rays.push_all(9, {3});
  w.bench.run(20000);
  const Address area = 0x10000 + 3 * spill_bytes;
  EXPECT_EQ(w.spill_memory.lines(), (std::vector<Address>{area, area + 64, area + 128, area + 128, area + 64, area}));
}

TEST(ShortStack, EachLineThatIsReadBackCostsItsLatency) {
  const auto cycles = [](std::uint32_t entries) {
    Walker w(64, short_stack(StackOverflow::spill, entries));
    chain(w.scene);
    w.scene.ray(0, 1, 1);
    w.run(1);
    return w.misses.cycles.at(0);
  };
  // A step finds the stack empty and asks; request channel, memory, and the step again.
  EXPECT_EQ(cycles(22) - cycles(30), 1 + spill_latency);
  EXPECT_EQ(cycles(8) - cycles(30), 3 * (1 + spill_latency));
}

TEST(ShortStack, WithARestartTrailEveryLeafIsVisitedOnceWithAnyNumberOfEntries) {
  for (std::uint32_t entries : {1u, 2u, 3u, 8u, 29u, 30u}) {
    Walker w(64, short_stack(StackOverflow::restart, entries));
    chain(w.scene);
    w.scene.ray(0, 1, 1);
    w.run(1);
    EXPECT_EQ(w.misses.tokens, std::vector<Slot>{0});
    EXPECT_EQ(counter(w.traversal, "leaves"), depth + 1);
    // The last `entries` of the chain's `depth` entries are there; a restart brings the lowest that are left, by
    // number.
    std::uint64_t restarts = 0, visits = depth;
    for (std::uint32_t left = depth; left > entries;) {
      left -= entries;
      ++restarts;
      visits += left;  // the nodes down to the one whose entry was forgotten
      // That entry is taken at once, and those above it are on the stack again.
      left -= 1;
    }
    EXPECT_EQ(counter(w.traversal, "restarts"), restarts) << entries;
    EXPECT_EQ(w.traversal.node_visits(), visits) << entries;
    EXPECT_TRUE(w.spill_memory.requests.empty());
  }
}

TEST(ShortStack, WithARestartTrailTheNearestHitIsFound) {
  for (std::uint32_t entries : {1u, 2u, 30u}) {
    Walker w(64, short_stack(StackOverflow::restart, entries));
    chain(w.scene);
    w.scene.triangle(false, 4, 1.5f, 77);  // seen by the ray: one of the leaves that wait
    w.scene.ray(0, 1, 1);
    w.run(1);
    EXPECT_EQ(w.hits.tokens, std::vector<Slot>{0});
    EXPECT_EQ(w.scene.contexts[0].best_primitive, 77u);
  }
}

TEST(ShortStack, ARayEndsWhenItsSpillsAreAcknowledged) {
  Walker w(64, short_stack(StackOverflow::spill, 8));
  chain(w.scene);
  w.scene.triangle(false, depth, 5, 55);  // the nearest leaf of all is hit: everything that waits is dropped
  w.scene.ray(0, 1, 1, RayKind::shadow);
  w.spill_memory.latency = [](const MemoryRequest&) -> Cycle { return 5000; };
  w.run(1);
  ASSERT_EQ(w.shadows.tokens, std::vector<Slot>{0});
  EXPECT_EQ(counter(w.traversal, "refilled_lines"), 0u);
  EXPECT_GT(w.shadows.cycles[0], w.spill_memory.cycles.back() + 5000);
}

TEST(TreeBuilding, RaysWalkTheStaticTreeFirstAndWaitForTheDynamicOne) {
  for (float dynamic_z : {0.5f, 6.0f}) {
    Walker w;
    a_triangle_in_each_tree(w.scene, dynamic_z);
    w.scene.registers.descriptor.dynamic_moved = 1;
    w.scene.registers.descriptor.dynamic_triangle_count = 1;
    w.builder.push_at(500, {});
    w.run(1);
    EXPECT_EQ(w.triangle_memory.requests.front().line, w.scene.registers.descriptor.static_triangles);
    EXPECT_EQ(w.scene.contexts[0].best_primitive, dynamic_z > 3 ? 8u : 7u);
    EXPECT_EQ(counter(w.traversal, "tree_waits"), 1u);
    // Woken by the token: fetch of the triangle, its test, channel to hit_point; channel to intersection before.
    const Cycle fetch = 1 + hit_latency, triangle = w.scene.pipelines.triangle;
    EXPECT_EQ(w.hits.cycles, std::vector<Cycle>{501 + 1 + fetch + triangle + 1});
  }
}

TEST(TreeBuilding, RaysThatDoNotNeedTheTreeDoNotWait) {
  Walker w;
  two_leaves(w.scene);
  w.scene.triangle(true, 0, 2, 8);
  w.scene.root(true, leaf(0, 1, true), 50, 60);
  w.scene.registers.descriptor.dynamic_moved = 1;
  w.scene.registers.descriptor.dynamic_triangle_count = 1;
  w.scene.ray(0, 1, 1);
  w.builder.push_at(5000, {});
  w.run(1);
  EXPECT_LT(w.hits.cycles.at(0), 200u);
  EXPECT_EQ(counter(w.traversal, "tree_waits"), 0u);
}

TEST(TreeBuilding, ATreeThatDidNotMoveIsThere) {
  Walker w;
  w.scene.triangle(true, 0, 2, 8);
  w.scene.root(true, leaf(0, 1, true));
  w.scene.ray(0, 1, 1);
  w.run(1);
  EXPECT_EQ(w.hits.tokens.size(), 1u);
}

TEST(TriangleInterval, IsTheTimeBetweenTwoTests) {
  for (std::uint32_t interval : {1u, 4u}) {
    RayCoreConfig config;
    config.triangle_interval = interval;
    Walker w(64, config);
    w.scene.triangle(false, 0, 1, 100);
    w.scene.root(false, leaf(0, 1, false));
    for (Slot slot : slots(32)) w.scene.ray(slot, 1, 1);
    w.run(32);
    ASSERT_EQ(w.hits.cycles.size(), 32u);
    EXPECT_EQ(w.hits.cycles.back() - w.hits.cycles.front(), 31 * interval);
  }
}

TEST(NodeInterval, IsTheTimeBetweenTwoNodes) {
  for (std::uint32_t interval : {1u, 3u}) {
    RayCoreConfig config;
    config.node_interval = interval;
    Walker w(64, config);
    two_leaves(w.scene);
    for (Slot slot : slots(32)) w.scene.ray(slot, 1000, 1);
    w.run(32);
    ASSERT_EQ(w.misses.cycles.size(), 32u);
    EXPECT_EQ(w.misses.cycles.back() - w.misses.cycles.front(), 31 * interval);
  }
}

}  // namespace
}  // namespace artu::hw::test
