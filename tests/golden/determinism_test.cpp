// The same input gives the same bits and cycles, however the model is run; stalls change cycles and no pixel.
#include "golden/harness.h"
#include "hw/selective/policy.h"

namespace artu::golden_tests {
namespace {

TestScene sequence() {
  Recipe recipe;
  recipe.frames = 3;
  recipe.mirror = recipe.glass = true;
  return make_scene(recipe);
}

TEST(Determinism, TwoRunsTakeTheSameCycles) {
  const TestScene scene = sequence();
  const Rendered a = run(scene), b = run(scene);
  for (std::size_t i = 0; i < scene.frames.size(); ++i) {
    EXPECT_EQ(all_counters(a.outcomes[i]), all_counters(b.outcomes[i]));
  }
}

TEST(Determinism, AFrameRunAloneTakesTheSameCycles) {
  const TestScene scene = sequence();
  const Rendered all = run(scene);
  for (std::size_t i : {2u, 1u}) {
    sim::Simulator simulator(scene.scene, {}, {});
    const sim::FrameOutcome alone = simulator.run(scene.frames[i]);
    EXPECT_EQ(all_counters(alone), all_counters(all.outcomes[i]));
    EXPECT_EQ(all_pixels(alone), all_pixels(all.outcomes[i]));
  }
}

TEST(Determinism, FramesInAnyOrderTakeTheSameCycles) {
  const TestScene scene = sequence();
  const Rendered forward = run(scene);
  sim::Simulator simulator(scene.scene, {}, {});
  for (std::size_t i : {2u, 0u, 1u, 0u}) {
    EXPECT_EQ(all_counters(simulator.run(scene.frames[i])), all_counters(forward.outcomes[i])) << i;
  }
}

TEST(Determinism, TickingEveryBlockInEveryCycleChangesNothing) {
  const TestScene scene = sequence();
  sim::SimulationOptions clocked;
  clocked.fidelity = sim::Fidelity::clocked;
  const Rendered a = run(scene), b = run(scene, {}, clocked);
  for (std::size_t i = 0; i < scene.frames.size(); ++i) {
    EXPECT_EQ(all_counters(a.outcomes[i]), all_counters(b.outcomes[i]));
  }
}

TEST(Determinism, TheOrderOfTicksChangesNothing) {
  const TestScene scene = sequence();
  const Rendered a = run(scene);
  for (std::uint64_t seed : {1u, 2u, 3u, 4u, 5u}) {
    sim::SimulationOptions shuffled;
    shuffled.shuffle_ticks = true;
    shuffled.seed = seed;
    if (seed == 5) shuffled.fidelity = sim::Fidelity::clocked;
    const Rendered b = run(scene, {}, shuffled);
    for (std::size_t i = 0; i < scene.frames.size(); ++i) {
      EXPECT_EQ(all_counters(a.outcomes[i]), all_counters(b.outcomes[i])) << "seed " << seed;
    }
  }
}

TEST(Determinism, RandomStallsChangeCyclesAndNoPixel) {
  const TestScene scene = sequence();
  const Rendered a = run(scene);
  for (std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    sim::SimulationOptions stalled;
    stalled.random_stall = true;
    stalled.seed = seed;
    const Rendered b = run(scene, {}, stalled);
    expect_exact(b);
    // Stalled, event-driven and clocked must still agree to the cycle.
    stalled.fidelity = sim::Fidelity::clocked;
    const Rendered c = run(scene, {}, stalled);
    for (std::size_t i = 0; i < scene.frames.size(); ++i) {
      EXPECT_NE(a.outcomes[i].cycles, b.outcomes[i].cycles);
      EXPECT_EQ(all_pixels(a.outcomes[i]), all_pixels(b.outcomes[i]));
      EXPECT_EQ(all_counters(b.outcomes[i]), all_counters(c.outcomes[i]));
    }
  }
}

TEST(Determinism, AnUnmovedTreeIsNotRebuilt) {
  TestScene scene = sequence();
  scene.frames[1].dynamic = scene.frames[0].dynamic;
  const Rendered rebuilt = run(scene);
  scene.frames[1].dynamic_moved = false;
  const Rendered kept = run(scene);
  expect_exact(kept);
  EXPECT_EQ(counter(rebuilt.outcomes[1], "tree_builder", "builds"), 1u);
  EXPECT_EQ(counter(kept.outcomes[1], "tree_builder", "builds"), 0u);
  EXPECT_LT(kept.outcomes[1].cycles, rebuilt.outcomes[1].cycles);
  EXPECT_EQ(all_pixels(kept.outcomes[1]), all_pixels(rebuilt.outcomes[1]));
}

TEST(Determinism, ManyConfigurationsWithStallsEndAndObeyTheLaws) {
  Recipe recipe;
  recipe.width = 21;
  recipe.height = 13;
  recipe.mirror = recipe.glass = true;
  const TestScene scene = make_scene(recipe);
  std::uint32_t state = 12345;
  const auto draw = [&state](std::uint32_t count) {
    state = state * 1664525u + 1013904223u;
    return (state >> 16) % count;
  };
  for (int i = 0; i < 120; ++i) {
    hw::UnitConfig config;
    config.core.count = 1 + draw(8);
    config.core.contexts = 1 + draw(40);
    config.core.queue_depth = 1 + draw(5);
    config.selective.tile = 4u << draw(4);
    config.selective.stride = std::min(2u << draw(3), config.selective.tile);
    config.selective.passes = static_cast<hw::Passes>(draw(2));
    config.selective.overlap = draw(4) != 0;
    config.selective.metric = static_cast<hw::Metric>(draw(3));
    config.selective.policy = draw(static_cast<std::uint32_t>(hw::policy_names().size()));
    const auto cache = [&draw] {
      return hw::CacheConfig{256u << draw(6), 1u << draw(3), 1 + draw(12), 1 + draw(9), 1 + draw(9)};
    };
    config.core.node_cache = cache();
    config.core.triangle_cache = cache();
    config.core.texture_cache = cache();
    config.selective.pixel_cache = cache();
    config.memory.l2 = cache();
    config.memory.l2_banks = 1u << draw(5);
    while (std::uint64_t{config.memory.l2_banks} * config.memory.l2.ways * 64 > config.memory.l2.size) {
      config.memory.l2_banks /= 2;
    }
    config.memory.write_combining = 2 + draw(20);
    config.core.ray_order = static_cast<hw::RayOrder>(draw(3));
    config.core.pixel_order = static_cast<hw::PixelOrder>(draw(2));
    config.core.dispatch = static_cast<hw::Dispatch>(draw(2));
    config.core.box_testers = 1 + draw(8);
    config.core.node_interval = 1 + draw(4);
    config.core.triangle_interval = 1 + draw(4);
    config.core.stack_overflow = static_cast<hw::StackOverflow>(draw(3));
    config.core.stack_entries = config.core.stack_overflow == hw::StackOverflow::refuse  ? 64
                                : config.core.stack_overflow == hw::StackOverflow::spill ? 8 + draw(4)
                                                                                         : 1 + draw(4);
    config.accel.static_kind = static_cast<hw::TreeKind>(draw(4));
    config.accel.dynamic_kind = static_cast<hw::TreeKind>(draw(4));
    config.accel.leaf_size = 1 + draw(16);
    config.tree_builder.overlap = draw(2) != 0;
    if (config.accel.dynamic_kind != hw::TreeKind::kd) {
      config.tree_builder.algorithm = static_cast<hw::BuildAlgorithm>(draw(2));
    }
    config.memory.interconnect_latency = 1 + draw(9);
    config.memory.dram.clock_mhz = 200 + 137 * draw(10);
    config.memory.dram.channels = 1u << draw(4);
    config.memory.dram.queue_depth = 1 + draw(20);
    config.tree_builder.outstanding = 1 + draw(12);
    sim::SimulationOptions options;
    options.random_stall = draw(2) != 0;
    options.seed = draw(1000);
    const Rendered r = run(scene, config, options);
    ASSERT_NO_FATAL_FAILURE(expect_exact(r)) << "configuration " << i;
    if (testing::Test::HasFailure()) FAIL() << "configuration " << i;
  }
}

}  // namespace
}  // namespace artu::golden_tests
