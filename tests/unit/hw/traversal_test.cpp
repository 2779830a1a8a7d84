// Traversal and intersection together, on trees made by hand: latency, throughput, order, what is left out.
#include <gtest/gtest.h>

#include "unit/hw/traversal_support.h"

namespace artu::hw::test {
namespace {

TEST(Traversal, OneRayThroughOneNodeAndOneTriangleIsTheSumOfItsStages) {
  Walker w;
  two_leaves(w.scene);
  w.scene.ray(0, 1, 1);
  w.run(1);
  const Cycle box = w.scene.pipelines.box, triangle = w.scene.pipelines.triangle;
  const Cycle fetch = 1 + hit_latency;  // request channel, cache
  // Root boxes, fetch of the node, its boxes, leaf channel, fetch of the triangle, its test, channel to hit_point.
  EXPECT_EQ(w.hits.cycles, std::vector<Cycle>{10 + box + fetch + box + 1 + fetch + triangle + 1});
  EXPECT_EQ(box, 14u);       // (3 + 3) + 3 * 1 + 3 + 2 * 1
  EXPECT_EQ(triangle, 36u);  // 3 + (3 + 3) + (3 + 3) + 2 * 3 + 12 + 3 * 1
  EXPECT_EQ(w.scene.contexts[0].best_primitive, 100u);
  EXPECT_EQ(w.scene.contexts[0].best.t, 9.0f);
  EXPECT_EQ(w.scene.contexts[0].hit_class, HitClass::static_geometry);
}

TEST(Traversal, ARayThatMissesTheRootBoxesCostsOneBoxTest) {
  Walker w;
  two_leaves(w.scene);
  w.scene.ray(0, 1000, 1);
  w.run(1);
  EXPECT_EQ(w.misses.cycles, std::vector<Cycle>{10 + Cycle{w.scene.pipelines.box} + 1});
  EXPECT_TRUE(w.node_memory.requests.empty());
  EXPECT_EQ(w.scene.contexts[0].hit_class, HitClass::miss);
}

TEST(Traversal, ARootBoxBeyondTheRaysLimitIsNotEntered) {
  Walker w;
  two_leaves(w.scene);
  w.scene.registers.descriptor.static_hi.z = 1;  // 9 away
  for (Slot slot : slots(2)) w.scene.ray(slot, 1, 1, RayKind::shadow);
  w.scene.contexts[0].ray.tmax = 8.5f;
  w.scene.contexts[1].ray.tmax = 9;
  w.run(2);
  EXPECT_EQ(w.shadows.tokens, (std::vector<Slot>{0, 1}));
  EXPECT_FALSE(w.scene.contexts[0].found);
  EXPECT_TRUE(w.scene.contexts[1].found) << "the limit is inclusive";
  EXPECT_EQ(w.traversal.node_visits(), 1u);
}

TEST(Traversal, ADeadRayIsAMiss) {
  Walker w;
  two_leaves(w.scene);
  w.scene.ray(0, 1, 1);
  w.scene.contexts[0].ray.direction = {};
  w.run(1);
  EXPECT_EQ(w.misses.cycles, std::vector<Cycle>{10 + Cycle{w.scene.pipelines.box} + 1});
}

TEST(Traversal, RaysThatMissTheRootBoxesEndOneACycle) {
  Walker w;
  two_leaves(w.scene);
  for (Slot slot : slots(64)) w.scene.ray(slot, 1000, 1);
  w.run(64);
  EXPECT_EQ(w.misses.cycles, every(10 + Cycle{w.scene.pipelines.box} + 1, 64));
}

TEST(Traversal, TheBoxTesterWorksInEveryCycleForManyIndependentRays) {
  // A chain of nodes whose last one is missed: with its root boxes a ray needs `depth` + 1 box tests.
  constexpr std::uint32_t depth = 8;
  constexpr std::size_t count = 64;
  Walker w(count);
  for (std::uint32_t i = 0; i < depth; ++i) {
    const std::uint32_t next = i + 1 < depth ? inner(i + 1, false) : leaf(0, 1, false);
    w.scene.node(false, i, {next, 1, 1, i + 1 < depth ? 0.0f : 50.0f}, {leaf(0, 1, false), 1, 1, 50});
  }
  w.scene.root(false, inner(0, false));
  for (Slot slot : slots(count)) w.scene.ray(slot, 1, 1);
  w.run(count);
  ASSERT_EQ(w.misses.tokens.size(), count);
  EXPECT_EQ(w.traversal.node_visits(), count * depth);
  const Cycle lone = depth * (w.scene.pipelines.box + 1 + hit_latency) + w.scene.pipelines.box + 1;
  // No idle cycle but for the latency of the last ray.
  EXPECT_GE(w.misses.cycles.back() - 10, count * (depth + 1));
  EXPECT_LE(w.misses.cycles.back() - 10, count * (depth + 1) + lone);
}

TEST(Traversal, TheNearerChildIsVisitedFirstAndTheOtherOneDroppedBehindTheHit) {
  for (bool swapped : {false, true}) {
    Walker w;
    w.scene.triangle(false, 0, 5, 100);
    w.scene.triangle(false, 1, 1, 101);
    const CoreScene::Child near{leaf(0, 1, false), 5, 5}, far{leaf(1, 1, false), 1, 1};
    w.scene.node(false, 0, swapped ? far : near, swapped ? near : far);
    w.scene.root(false, inner(0, false));
    w.scene.ray(0, 1, 1);
    w.run(1);
    EXPECT_EQ(w.scene.contexts[0].best_primitive, 100u);
    EXPECT_EQ(counter(w.traversal, "leaves"), 1u);
    EXPECT_EQ(counter(w.traversal, "dropped"), 1u);
    // As a single leaf, and a step and a cycle for the entry that is dropped.
    const Cycle box = w.scene.pipelines.box, triangle = w.scene.pipelines.triangle, fetch = 1 + hit_latency;
    EXPECT_EQ(w.hits.cycles, std::vector<Cycle>{10 + box + fetch + box + 1 + fetch + triangle + 1 + 2});
  }
}

TEST(Traversal, AStackEntryThatBeginsAtTheBestHitIsStillVisited) {
  Walker w;
  w.scene.triangle(false, 0, 5, 101);
  w.scene.triangle(false, 1, 5, 100);  // the same plane, and the smaller number: it wins the tie
  w.scene.node(false, 0, {leaf(0, 1, false), 5, 5}, {leaf(1, 1, false), 5, 5});
  w.scene.root(false, inner(0, false));
  w.scene.ray(0, 1, 1);
  w.run(1);
  EXPECT_EQ(w.scene.contexts[0].best_primitive, 100u);
  EXPECT_EQ(counter(w.traversal, "dropped"), 0u);
  EXPECT_EQ(w.intersection.tests(), 2u);
}

TEST(Traversal, BothTreesAreWalkedForTheNearestHit) {
  for (float dynamic_z : {0.5f, 6.0f}) {
    Walker w;
    a_triangle_in_each_tree(w.scene, dynamic_z);
    w.run(1);
    const bool dynamic = dynamic_z > 3;
    EXPECT_EQ(w.scene.contexts[0].best_primitive, dynamic ? 8u : 7u);
    EXPECT_EQ(w.scene.contexts[0].hit_class, dynamic ? HitClass::dynamic_geometry : HitClass::static_geometry);
    EXPECT_EQ(w.scene.contexts[0].primary_t_bits, bits_of(dynamic ? 4.0f : 7.0f));
  }
}

TEST(Traversal, ARayThatMissesTheDynamicRootBoxSkipsTheDynamicTree) {
  Walker w;
  two_leaves(w.scene);
  w.scene.triangle(true, 0, 2, 8);
  w.scene.root(true, leaf(0, 1, true), 50, 60);
  w.scene.ray(0, 1, 1);
  w.scene.ray(1, 51, 1);
  w.run(2);
  EXPECT_EQ(counter(w.traversal, "dynamic_skipped"), 1u);
  EXPECT_EQ(w.hits.tokens.size(), 2u);
  EXPECT_EQ(w.scene.contexts[0].hit_class, HitClass::static_geometry);
}

TEST(Traversal, AShadowRayEndsAtItsFirstHitWhereverItIs) {
  Walker w;
  w.scene.triangle(false, 0, 5, 100);
  w.scene.triangle(false, 1, 6, 101);
  // Overlapping boxes: the farther leaf would have to be visited by any other ray.
  w.scene.node(false, 0, {leaf(0, 1, false), 0, 7}, {leaf(1, 1, false), 0, 7});
  w.scene.root(false, inner(0, false));
  w.scene.ray(0, 1, 1, RayKind::shadow);
  w.scene.ray(1, 1, 1, RayKind::reflection);
  w.run(2);
  EXPECT_EQ(w.shadows.tokens, std::vector<Slot>{0});
  EXPECT_EQ(w.hits.tokens, std::vector<Slot>{1});
  EXPECT_EQ(w.intersection.tests(), 1u + 2u);
  EXPECT_EQ(w.scene.contexts[1].best_primitive, 101u);
  EXPECT_EQ(w.traversal.finished(RayKind::shadow), 1u);
  EXPECT_EQ(w.traversal.finished(RayKind::reflection), 1u);
}

TEST(Traversal, WaitsForTheNodeCacheAndForFullOutputs) {
  Walker w;
  two_leaves(w.scene);
  for (Slot slot : slots(64)) w.scene.ray(slot, slot % 2 == 0 ? 1.0f : 1000.0f, 1);
  w.misses.open = [](Cycle now) { return now > 2000; };
  w.node_memory.latency = [](const MemoryRequest&) -> Cycle { return 150; };
  w.run(64);
  EXPECT_EQ(w.hits.tokens.size(), 32u);
  EXPECT_EQ(w.misses.tokens.size(), 32u);
  EXPECT_GT(w.traversal.cycles_in(State::stall_out), 1000u);
}

/// A primary ray and another one wait for the box testers: the slots in the order in which they begin.
std::vector<Slot> order_of(RayOrder order, Cycle primary_arrival, Cycle other_arrival) {
  RayCoreConfig config = core_config;
  config.ray_order = order;
  Walker w(2, config);
  two_leaves(w.scene);
  w.scene.ray(0, 1000, 1);
  w.scene.ray(1, 1000, 1, RayKind::reflection);
  w.scene.contexts[0].arrival = primary_arrival;
  w.scene.contexts[1].arrival = other_arrival;
  w.no_rays.push_at(9, 1);
  w.run(1);
  return w.misses.tokens;
}

TEST(Traversal, OfTwoRaysThatOfTheOrderBegins) {
  const std::vector<Slot> primary{0, 1}, other{1, 0};
  for (const Cycle arrival : {3, 5}) {
    EXPECT_EQ(order_of(RayOrder::secondary_first, 4, arrival), other);
    EXPECT_EQ(order_of(RayOrder::primary_first, 4, arrival), primary);
  }
  EXPECT_EQ(order_of(RayOrder::first_come, 4, 5), primary);
  EXPECT_EQ(order_of(RayOrder::first_come, 4, 3), other);
  EXPECT_EQ(order_of(RayOrder::first_come, 4, 4), other) << "on a tie the ray that is nearer to its pixel's end";
}

}  // namespace
}  // namespace artu::hw::test
