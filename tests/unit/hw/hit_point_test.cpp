// The hit-point unit: two lines a hit, and a surface.
#include "hw/ray_core/hit_point.h"

#include <gtest/gtest.h>

#include "unit/hw/core_support.h"

namespace artu::hw::test {
namespace {

constexpr Cycle hit_latency = 2;

struct Surfaces {
  Surfaces()
      : scene(32),
        hit_point(bench.block<HitPoint>("hit_point", scene.registers, scene.image, scene.contexts)),
        out(bench.fifo<Slot>("out", 32, scene.pipelines.hit_point)),
        memory(bench.block<ScriptedMemory>("memory", triangles, hit_latency, hit_latency)),
        source(bench.block<Source<Slot>>("source", in)),
        sink(bench.block<Sink<Slot>>("sink", out)) {
    in.bind(source, hit_point);
    out.bind(hit_point, sink);
    triangles.bind(hit_point, memory);
    hit_point.bind(in, out, triangles);
    scene.triangle(false, 3, 5, 1);
    scene.triangle(true, 3, -5, 1);
    for (Slot slot : slots(32)) {
      scene.ray(slot, 1, 1);
      RayContext& context = scene.contexts[slot];
      context.best = {5, 4, 4, 16};  // t, U, V, det: a quarter, a quarter, a half
      context.best_triangle = context.best_attributes = 3;
    }
  }
  Bench bench;
  CoreScene scene;
  Fifo<Slot>& in = bench.fifo<Slot>("in", 5);
  MemoryLink& triangles = bench.link("triangles", 4, 1, hit_latency);
  HitPoint& hit_point;
  Fifo<Slot>& out;
  ScriptedMemory& memory;
  Source<Slot>& source;
  Sink<Slot>& sink;
};

TEST(HitPoint, ASurfaceLeavesItsLatencyAfterTheSecondLine) {
  Surfaces s;
  s.source.push_at(9, 0);
  s.bench.run(500);
  // Arrival 10, requests in 10 and 11, the second line after request channel and cache.
  EXPECT_EQ(s.sink.cycles, std::vector<Cycle>{11 + 1 + hit_latency + s.scene.pipelines.hit_point});
  EXPECT_EQ(s.memory.lines(), (std::vector<Address>{s.scene.registers.descriptor.static_triangles + 3 * 64,
                                                    s.scene.registers.descriptor.static_attributes + 3 * 64}));
  // divide + 2 adds + mix (3 + 6) + unit (3 + 6 + 12 + 12 + 3) + multiply + add
  EXPECT_EQ(s.scene.pipelines.hit_point, 12u + 6 + 9 + 36 + 6);
}

TEST(HitPoint, TwoRequestsAHitMakeOneHitInTwoCycles) {
  Surfaces s;
  for (Slot slot : slots(32)) s.source.push_at(9, slot);
  s.bench.run(500);
  EXPECT_EQ(s.sink.cycles, every(11 + 1 + hit_latency + Cycle{s.scene.pipelines.hit_point}, 32, 2));
  EXPECT_EQ(s.memory.cycles, every(11, 64)) << "one request a cycle";
}

TEST(HitPoint, ReadsTheTreeOfTheHit) {
  Surfaces s;
  s.scene.contexts[0].dynamic = true;
  s.scene.image.at<TriangleRecord>(s.scene.registers.descriptor.dynamic_triangles + 3 * 64).material = 2;
  s.source.push_at(9, 0).push_at(20, 1);
  s.bench.run(500);
  const FrameDescriptor& frame = s.scene.registers.descriptor;
  EXPECT_EQ(s.memory.requests[0].line, frame.dynamic_triangles + 3 * 64);
  EXPECT_EQ(s.memory.requests[1].line, frame.dynamic_attributes + 3 * 64);
  EXPECT_EQ(s.scene.contexts[0].material, frame.materials + 2 * 128);
  EXPECT_EQ(s.scene.contexts[1].material, frame.materials);
  EXPECT_LT(s.scene.contexts[0].surface.outside.z, -4.9f);
  EXPECT_GT(s.scene.contexts[1].surface.outside.z, 5.0f);
}

TEST(HitPoint, LinesMayComeBackInAnyOrder) {
  Surfaces s;
  s.memory.latency = [&s](const MemoryRequest& r) -> Cycle {
    return r.line == s.scene.registers.descriptor.static_triangles + 3 * 64 ? 100 : 10;
  };
  s.source.push_at(9, 0).push_at(9, 1);
  s.bench.run(500);
  // Both wait for their first lines, asked for in 10 and 12.
  EXPECT_EQ(s.sink.cycles, (std::vector<Cycle>{11 + 100 + Cycle{s.scene.pipelines.hit_point},
                                               13 + 100 + Cycle{s.scene.pipelines.hit_point}}));
}

}  // namespace
}  // namespace artu::hw::test
