// The intersection unit alone: leaves in, tested contexts out.
#include "hw/ray_core/intersection.h"

#include <gtest/gtest.h>

#include "unit/hw/core_support.h"

namespace artu::hw::test {
namespace {

constexpr Cycle hit_latency = 2;

struct Tester {
  explicit Tester(std::size_t contexts = 32)
      : scene(contexts),
        intersection(bench.block<Intersection>("intersection", scene.registers, scene.image, scene.contexts)),
        tested(bench.fifo<Slot>("tested", static_cast<std::uint32_t>(contexts), scene.pipelines.triangle)),
        memory(bench.block<ScriptedMemory>("memory", triangles, hit_latency, hit_latency)),
        source(bench.block<Source<LeafTask>>("source", leaves)),
        sink(bench.block<Sink<Slot>>("sink", tested)) {
    leaves.bind(source, intersection);
    tested.bind(intersection, sink);
    triangles.bind(intersection, memory);
    intersection.bind(leaves, tested, triangles);
    for (std::uint32_t i = 0; i < 32; ++i) scene.triangle(false, i, 5 - 0.125f * static_cast<float>(i), 100 + i);
    for (Slot slot : slots(contexts)) scene.ray(slot, 1, 1);
  }
  Bench bench;
  CoreScene scene;
  Fifo<LeafTask>& leaves = bench.fifo<LeafTask>("leaves", 5);
  MemoryLink& triangles = bench.link("triangles", 4, 1, hit_latency);
  Intersection& intersection;
  Fifo<Slot>& tested;
  ScriptedMemory& memory;
  Source<LeafTask>& source;
  Sink<Slot>& sink;
};

TEST(Intersection, ALeafTakesOneFetchACycleAndTheTestOfItsLastTriangle) {
  for (std::uint32_t n : {1u, 2u, 5u, 16u}) {
    Tester t;
    t.source.push_at(9, {0, NodeReference::leaf(0, n, false)});
    t.bench.run(500);
    // Arrival 10, fetches 10 ... 10 + n - 1, the last one's data after request channel and cache.
    EXPECT_EQ(t.sink.cycles, std::vector<Cycle>{10 + n - 1 + 1 + hit_latency + t.scene.pipelines.triangle});
    EXPECT_EQ(t.intersection.tests(), n);
    EXPECT_EQ(t.scene.contexts[0].best_primitive, 100u) << "the nearest";
    EXPECT_EQ(t.scene.contexts[0].best_triangle, 0u);
  }
}

TEST(Intersection, LeavesOfManyRaysAreTestedOneTriangleACycle) {
  Tester t;
  for (Slot slot : slots(32)) t.source.push_at(9, {slot, NodeReference::leaf(slot, 1, false)});
  t.bench.run(500);
  EXPECT_EQ(t.sink.cycles, every(10 + 1 + hit_latency + Cycle{t.scene.pipelines.triangle}, 32));
  EXPECT_EQ(t.sink.tokens, slots(32));
}

TEST(Intersection, LeavesOfSeveralTrianglesFollowEachOtherWithoutAGap) {
  Tester t;
  for (Slot slot : slots(8)) t.source.push_at(9, {slot, NodeReference::leaf(0, 4, false)});
  t.bench.run(500);
  EXPECT_EQ(t.sink.cycles, every(10 + 3 + 1 + hit_latency + Cycle{t.scene.pipelines.triangle}, 8, 4));
}

TEST(Intersection, AShadowRaysLeafEndsAtItsFirstHit) {
  Tester t;
  t.scene.contexts[0].kind = RayKind::shadow;
  t.source.push_at(9, {0, NodeReference::leaf(0, 16, false)});
  t.bench.run(500);
  // The first triangle's data come 1 + hit_latency cycles after its fetch: that many fetches are under way.
  EXPECT_EQ(t.memory.requests.size(), 1 + hit_latency);
  EXPECT_EQ(t.intersection.tests(), 1 + hit_latency);
  EXPECT_EQ(counter(t.intersection, "left_out"), 16 - (1 + hit_latency));
  EXPECT_EQ(t.sink.cycles, std::vector<Cycle>{10 + hit_latency + 1 + hit_latency + t.scene.pipelines.triangle});
}

TEST(Intersection, AnUnblockedShadowRayTestsAllTriangles) {
  Tester t;
  t.scene.ray(0, 1000, 1, RayKind::shadow);
  t.source.push_at(9, {0, NodeReference::leaf(0, 16, false)});
  t.bench.run(500);
  EXPECT_EQ(t.intersection.tests(), 16u);
  EXPECT_FALSE(t.scene.contexts[0].found);
}

TEST(Intersection, TheNextLeafBeginsWhereAShadowRaysLeafIsCutShort) {
  Tester t;
  t.scene.contexts[0].kind = RayKind::shadow;
  t.source.push_at(9, {0, NodeReference::leaf(0, 16, false)}).push_at(10, {1, NodeReference::leaf(0, 2, false)});
  t.bench.run(500);
  // The hit is known in 10 + 1 + hit_latency: in that very cycle the next leaf's first triangle is fetched.
  EXPECT_EQ(t.memory.cycles, every(11, 1 + hit_latency + 2));
  EXPECT_EQ(t.sink.tokens, slots(2));
}

TEST(Intersection, OnATieTheSmallerPrimitiveWinsWhateverTheOrder) {
  for (bool swapped : {false, true}) {
    Tester t;
    t.scene.triangle(false, 0, 5, swapped ? 9 : 4);
    t.scene.triangle(false, 1, 5, swapped ? 4 : 9);
    t.source.push_at(9, {0, NodeReference::leaf(0, 2, false)});
    t.bench.run(500);
    EXPECT_EQ(t.scene.contexts[0].best_primitive, 4u);
  }
}

TEST(Intersection, WaitsForTrianglesAsMemory) {
  Tester t;
  t.memory.latency = [](const MemoryRequest&) -> Cycle { return 300; };
  t.source.push_at(9, {0, NodeReference::leaf(0, 2, false)});
  t.bench.run(1000);
  EXPECT_EQ(t.sink.cycles, std::vector<Cycle>{10 + 1 + 1 + 300 + Cycle{t.scene.pipelines.triangle}});
  // From the cycle after the second fetch to the first answer.
  EXPECT_EQ(t.intersection.cycles_in(State::stall_mem), 300u - 1);
}

}  // namespace
}  // namespace artu::hw::test
