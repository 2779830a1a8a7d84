// Every kind of tree, for either class of geometry: the same pixels, to the bit; other cycles.
#include "golden/harness.h"

namespace artu::golden_tests {
namespace {

constexpr hw::TreeKind kinds[] = {hw::TreeKind::bvh2, hw::TreeKind::bvh4, hw::TreeKind::bvh8, hw::TreeKind::kd};

hw::UnitConfig unit_with(hw::TreeKind fixed, hw::TreeKind dynamic) {
  hw::UnitConfig config;
  config.accel.static_kind = fixed;
  config.accel.dynamic_kind = dynamic;
  config.core.stack_entries = 128;
  return config;
}

Recipe everything() {
  Recipe recipe;
  recipe.mirror = recipe.glass = true;
  recipe.frames = 2;
  recipe.subdivisions = 3;
  recipe.spot_lights = 1;
  return recipe;
}

TEST(Trees, AllPairsOfKindsAreExactAndGiveTheSamePixels) {
  const TestScene scene = make_scene(everything());
  const Rendered reference = run(scene);
  for (hw::TreeKind fixed : kinds) {
    for (hw::TreeKind dynamic : kinds) {
      const Rendered r = run(scene, unit_with(fixed, dynamic));
      expect_exact(r);
      for (std::size_t i = 0; i < scene.frames.size(); ++i) {
        EXPECT_EQ(all_pixels(r.outcomes[i]), all_pixels(reference.outcomes[i]))
            << static_cast<unsigned>(fixed) << ", " << static_cast<unsigned>(dynamic);
      }
    }
  }
}

TEST(Trees, AreTheSameClockedShuffledAndStalled) {
  const TestScene scene = make_scene(everything());
  for (hw::TreeKind kind : kinds) {
    hw::UnitConfig config = unit_with(kind, kind);
    config.core.box_testers = 3;
    config.core.queue_depth = 1;
    const Rendered event = run(scene, config);
    sim::SimulationOptions clocked, stalled;
    clocked.fidelity = sim::Fidelity::clocked;
    clocked.shuffle_ticks = true;
    stalled.random_stall = true;
    const Rendered other = run(scene, config, clocked);
    const Rendered slow = run(scene, config, stalled);
    stalled.fidelity = sim::Fidelity::clocked;
    const Rendered slow_clocked = run(scene, config, stalled);
    expect_exact(slow);
    for (std::size_t i = 0; i < scene.frames.size(); ++i) {
      EXPECT_EQ(all_counters(event.outcomes[i]), all_counters(other.outcomes[i])) << static_cast<unsigned>(kind);
      EXPECT_EQ(all_counters(slow.outcomes[i]), all_counters(slow_clocked.outcomes[i])) << static_cast<unsigned>(kind);
    }
  }
}

TEST(Trees, FarAwayAndTinyScenesAreExact) {
  for (float offset : {1000.0f, 100000.0f, 1.0e7f}) {
    Recipe recipe = everything();
    recipe.offset = offset;
    recipe.frames = 1;
    const TestScene scene = make_scene(recipe);
    for (hw::TreeKind kind : kinds) expect_exact(run(scene, unit_with(kind, kind)));
  }
}

TEST(Trees, MoreTestersNeverTakeMoreCycles) {
  Recipe recipe = everything();
  recipe.frames = 1;
  const TestScene scene = make_scene(recipe);
  for (hw::TreeKind kind : {hw::TreeKind::bvh4, hw::TreeKind::bvh8}) {
    hw::UnitConfig config = unit_with(kind, kind);
    config.core.box_testers = 1;
    const std::uint64_t one = run(scene, config).outcomes[0].cycles;
    config.core.box_testers = 8;
    EXPECT_LT(run(scene, config).outcomes[0].cycles, one);
  }
}

TEST(Trees, AFaultInTheirTestsIsSeen) {
  Recipe recipe = everything();
  recipe.frames = 1;
  const TestScene scene = make_scene(recipe);
  for (hw::TreeKind kind : kinds) {
    sim::SimulationOptions options;
    options.fault = {hw::Datapath::box, 31};
    EXPECT_FALSE(run(scene, unit_with(kind, kind), options).check.passed()) << static_cast<unsigned>(kind);
  }
}

TEST(Trees, ATreeThatNeedsMoreStackThanThereIsIsRefused) {
  hw::UnitConfig config = unit_with(hw::TreeKind::bvh8, hw::TreeKind::bvh8);
  config.core.stack_entries = 8;
  EXPECT_THROW(run(make_scene(everything()), config), std::runtime_error);
}

}  // namespace
}  // namespace artu::golden_tests
