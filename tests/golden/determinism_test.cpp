// The same input gives the same bits and cycles, however the model is run; stalls change cycles and no pixel.
#include "golden/drawn.h"
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
  Draw draw;
  for (int i = 0; i < 120; ++i) {
    const hw::UnitConfig config = draw_configuration(draw);
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
