// Ray generator and dispatcher: latencies, priorities, what limits them.
#include "hw/ray_core/ray_generator.h"

#include <gtest/gtest.h>

#include "hw/ray_core/dispatcher.h"
#include "unit/hw/core_support.h"

namespace artu::hw::test {
namespace {

struct Generator {
  explicit Generator(std::size_t contexts, RayOrder order = RayOrder::secondary_first)
      : scene(contexts),
        generator(bench.block<RayGenerator>("generator", scene.registers, scene.contexts, PrecisionConfig{}, order)),
        primary(bench.fifo<Slot>("primary", 64, scene.pipelines.generate + scene.pipelines.set_up)),
        others(bench.fifo<Slot>("others", 64, scene.pipelines.set_up)),
        pixels(bench.block<Source<PixelJob>>("pixels", jobs)),
        next_source(bench.block<Source<Slot>>("next_source", next_rays)),
        free_source(bench.block<Source<Slot>>("free_source", freed)),
        primary_sink(bench.block<Sink<Slot>>("primary_sink", primary)),
        others_sink(bench.block<Sink<Slot>>("others_sink", others)) {
    jobs.bind(pixels, generator);
    next_rays.bind(next_source, generator);
    freed.bind(free_source, generator);
    primary.bind(generator, primary_sink);
    others.bind(generator, others_sink);
    generator.bind(jobs, next_rays, freed, primary, others);
    CameraRegisters& camera = scene.registers.descriptor.camera;
    camera.corner = {-32, -32, -64};
    camera.du = {1, 0, 0};
    camera.dv = {0, 1, 0};
    for (Slot slot : slots(contexts)) scene.ray(slot, 1, 1, RayKind::shadow);
  }
  Cycle primary_latency() const { return scene.pipelines.generate + scene.pipelines.set_up; }
  Bench bench;
  CoreScene scene;
  RayGenerator& generator;
  Fifo<PixelJob>& jobs = bench.fifo<PixelJob>("jobs", 5);
  Fifo<Slot>& next_rays = bench.fifo<Slot>("next_rays", 64);
  Fifo<Slot>& freed = bench.fifo<Slot>("freed", 64);
  Fifo<Slot>&primary, &others;
  Source<PixelJob>& pixels;
  Source<Slot>&next_source, &free_source;
  Sink<Slot>&primary_sink, &others_sink;
};

TEST(RayGenerator, APrimaryRayTakesGenerateAndSetUp) {
  Generator g(4);
  g.pixels.push_at(9, {3, 5});
  g.bench.run(200);
  EXPECT_EQ(g.primary_sink.cycles, std::vector<Cycle>{10 + g.primary_latency()});
  EXPECT_EQ(g.scene.pipelines.generate, 3u + 2 * 3 + (3 + 2 * 3 + 12 + 12 + 3));
  EXPECT_EQ(g.scene.pipelines.set_up, 12u + 2);
  const RayContext& context = g.scene.contexts[g.primary_sink.tokens[0]];
  EXPECT_EQ(context.pixel.x, 3);
  EXPECT_EQ(context.pixel.y, 5);
  EXPECT_EQ(context.kind, RayKind::primary);
  EXPECT_LT(context.ray.direction.z, -0.5f);
  EXPECT_EQ(g.generator.rays(RayKind::primary), 1u);
}

TEST(RayGenerator, OtherRaysTakeSetUp) {
  Generator g(4);
  g.next_source.push_at(9, 2);
  g.bench.run(200);
  EXPECT_EQ(g.others_sink.cycles, std::vector<Cycle>{10 + Cycle{g.scene.pipelines.set_up}});
  EXPECT_EQ(g.others_sink.tokens, std::vector<Slot>{2});
  EXPECT_EQ(g.generator.rays(RayKind::shadow), 1u);
}

TEST(RayGenerator, SetsUpOneRayACycle) {
  Generator g(64);
  for (std::uint16_t i = 0; i < 60; ++i) g.pixels.push_at(9, {i, 0});
  g.bench.run(300);
  EXPECT_EQ(g.primary_sink.cycles, every(10 + g.primary_latency(), 60));
  Generator n(64);
  n.next_source.push_all(9, slots(60));
  n.bench.run(300);
  EXPECT_EQ(n.others_sink.cycles, every(10 + Cycle{n.scene.pipelines.set_up}, 60));
}

TEST(RayGenerator, NextRaysGoFirst) {
  Generator g(64);
  for (std::uint16_t i = 0; i < 4; ++i) g.pixels.push_at(9, {i, 0});
  g.next_source.push_all(9, slots(10));
  g.bench.run(300);
  EXPECT_EQ(g.others_sink.cycles, every(10 + Cycle{g.scene.pipelines.set_up}, 10));
  EXPECT_EQ(g.primary_sink.cycles, every(20 + g.primary_latency(), 4));
}

TEST(RayGenerator, OrPixelsGoFirst) {
  Generator g(64, RayOrder::primary_first);
  for (std::uint16_t i = 0; i < 4; ++i) g.pixels.push_at(9, {i, 0});
  g.next_source.push_all(9, slots(10));
  g.bench.run(300);
  EXPECT_EQ(g.primary_sink.cycles, every(10 + g.primary_latency(), 4));
  EXPECT_EQ(g.others_sink.cycles, every(14 + Cycle{g.scene.pipelines.set_up}, 10));
}

TEST(RayGenerator, OrBothTakeTurnsAndThePixelBegins) {
  Generator g(64, RayOrder::first_come);
  for (std::uint16_t i = 0; i < 4; ++i) g.pixels.push_at(9, {i, 0});
  g.next_source.push_all(9, slots(4));
  g.bench.run(300);
  EXPECT_EQ(g.primary_sink.cycles, every(10 + g.primary_latency(), 4, 2));
  EXPECT_EQ(g.others_sink.cycles, every(11 + Cycle{g.scene.pipelines.set_up}, 4, 2));
}

TEST(RayGenerator, StartsNoMorePixelsThanThereAreContexts) {
  Generator g(3);
  for (std::uint16_t i = 0; i < 5; ++i) g.pixels.push_at(9, {i, 0});
  g.free_source.push_at(199, 1).push_at(299, 0);
  g.bench.run(1000);
  // A context that is freed is used in the same cycle.
  EXPECT_EQ(g.primary_sink.cycles,
            (std::vector<Cycle>{10 + g.primary_latency(), 11 + g.primary_latency(), 12 + g.primary_latency(),
                                200 + g.primary_latency(), 300 + g.primary_latency()}));
  EXPECT_EQ(g.primary_sink.tokens[3], 1);
  EXPECT_EQ(g.primary_sink.tokens[4], 0);
}

struct Dispatching {
  Dispatching(std::size_t source_count, std::size_t core_count, Dispatch policy = Dispatch::first_come)
      : dispatcher(bench.block<Dispatcher>("dispatcher", registers, policy, 16u)) {
    for (std::size_t i = 0; i < source_count; ++i) {
      const std::string name = "source" + std::to_string(i);
      auto& fifo = bench.fifo<PixelJob>(name.c_str(), 8);
      sources.push_back(&bench.block<Source<PixelJob>>((name + "_block").c_str(), fifo));
      fifo.bind(*sources.back(), dispatcher);
      dispatcher.add_source(fifo);
    }
    for (std::size_t i = 0; i < core_count; ++i) {
      const std::string name = "core" + std::to_string(i);
      auto& fifo = bench.fifo<PixelJob>(name.c_str(), 5);
      cores.push_back(&bench.block<Sink<PixelJob>>((name + "_block").c_str(), fifo));
      fifo.bind(dispatcher, *cores.back());
      dispatcher.add_core(fifo);
    }
  }
  Bench bench;
  FrameRegisters registers;
  Dispatcher& dispatcher;
  std::vector<Source<PixelJob>*> sources;
  std::vector<Sink<PixelJob>*> cores;
};

TEST(Dispatcher, HandsOutOnePixelACycleRoundRobinWithLatencyOne) {
  Dispatching d(1, 3);
  for (std::uint16_t i = 0; i < 30; ++i) d.sources[0]->push_at(9, {i, 0});
  d.bench.run(200);
  for (std::size_t core = 0; core < 3; ++core) {
    EXPECT_EQ(d.cores[core]->cycles, every(11 + core, 10, 3));
    EXPECT_EQ(d.cores[core]->tokens[4].x, core + 12);
  }
}

TEST(Dispatcher, LeavesOutACoreWithoutRoom) {
  Dispatching d(1, 3);
  d.cores[1]->open = [](Cycle) { return false; };
  for (std::uint16_t i = 0; i < 45; ++i) d.sources[0]->push_at(9, {i, 0});
  d.bench.run(500);
  EXPECT_EQ(d.cores[0]->tokens.size() + d.cores[2]->tokens.size(), 40u);  // five fill core 1's channel
  EXPECT_EQ(d.cores[0]->tokens.size(), 20u);
  EXPECT_EQ(d.sources[0]->pushed.back(), 9u + 44) << "nobody waits for core 1";
}

TEST(Dispatcher, WaitsWhereNoCoreHasRoom) {
  Dispatching d(1, 2);
  for (auto* core : d.cores) core->open = [](Cycle now) { return now >= 300; };
  for (std::uint16_t i = 0; i < 40; ++i) d.sources[0]->push_at(9, {i, 0});
  d.bench.run(1000);
  EXPECT_EQ(d.cores[0]->tokens.size() + d.cores[1]->tokens.size(), 40u);
  EXPECT_GT(d.dispatcher.cycles_in(State::stall_out), 250u);
}

TEST(Dispatcher, SourcesTakeTurns) {
  Dispatching d(2, 1);
  for (std::uint16_t i = 0; i < 10; ++i) {
    d.sources[0]->push_at(9, {i, 0});
    d.sources[1]->push_at(9, {i, 1});
  }
  d.bench.run(200);
  ASSERT_EQ(d.cores[0]->tokens.size(), 20u);
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(d.cores[0]->tokens[i].y, i % 2);
}

TEST(Dispatcher, ByTileTheCoreFollowsFromThePlace) {
  Dispatching d(1, 3, Dispatch::tiles);
  d.registers.descriptor.width = 40;  // three tiles a row, the last of them 8 wide
  for (const PixelJob& pixel : {PixelJob{0, 0}, {15, 15}, {16, 0}, {39, 0}, {0, 16}, {16, 31}, {39, 16}, {0, 32}}) {
    d.sources[0]->push_at(9, pixel);
  }
  d.bench.run(200);
  // Tile 3, the first of the second row, is core 0's again.
  const auto places_of = [&](std::size_t core) {
    std::vector<std::pair<int, int>> places;
    for (const PixelJob& pixel : d.cores[core]->tokens) places.emplace_back(pixel.x, pixel.y);
    return places;
  };
  using Places = std::vector<std::pair<int, int>>;
  EXPECT_EQ(places_of(0), (Places{{0, 0}, {15, 15}, {0, 16}, {0, 32}}));
  EXPECT_EQ(places_of(1), (Places{{16, 0}, {16, 31}}));
  EXPECT_EQ(places_of(2), (Places{{39, 0}, {39, 16}}));
}

TEST(Dispatcher, ByTileAFullCoreIsWaitedFor) {
  Dispatching d(1, 2, Dispatch::tiles);
  d.registers.descriptor.width = 32;
  d.cores[0]->open = [](Cycle now) { return now >= 300; };
  for (std::uint16_t i = 0; i < 6; ++i) d.sources[0]->push_at(9, {i, 0});
  d.sources[0]->push_at(15, {16, 0});
  d.bench.run(1000);
  ASSERT_EQ(d.cores[1]->cycles.size(), 1u);
  EXPECT_GE(d.cores[1]->cycles[0], 300u) << "it stands behind those of core 0";
}

}  // namespace
}  // namespace artu::hw::test
