// Every algorithm of the tree builder, for every kind of tree: other trees and cycles, the same pixels to the bit; and
// with refit, frames that stay independent of each other.
#include "golden/harness.h"

namespace artu::golden_tests {
namespace {

constexpr hw::TreeKind bvhs[] = {hw::TreeKind::bvh2, hw::TreeKind::bvh4, hw::TreeKind::bvh8};
constexpr hw::TreeKind all_kinds[] = {hw::TreeKind::bvh2, hw::TreeKind::bvh4, hw::TreeKind::bvh8, hw::TreeKind::kd};

/// A ball that is twisted more and more.
TestScene deforming(unsigned frames) {
  Recipe recipe;
  recipe.frames = frames;
  recipe.mirror = true;
  recipe.subdivisions = 3;
  TestScene scene = make_scene(recipe);
  for (traces::Frame& frame : scene.frames) {
    for (traces::Vec3& v : frame.dynamic.positions) {
      const float lean = 0.3f * static_cast<float>(frame.index);
      v.x += lean * v.y * v.y;
      v.z -= lean * v.x * v.y;
    }
  }
  return scene;
}

hw::UnitConfig unit_with(hw::TreeKind kind, hw::BuildAlgorithm algorithm, bool refit = false) {
  hw::UnitConfig config;
  config.accel.dynamic_kind = kind;
  config.tree_builder.algorithm = algorithm;
  config.tree_builder.refit = refit;
  config.tree_builder.refit_interval = 3;
  config.tree_builder.triangles_per_pass = 256;  // less than the ball has
  config.core.stack_entries = 128;
  return config;
}

std::vector<hw::UnitConfig> all_units() {
  std::vector<hw::UnitConfig> units{unit_with(hw::TreeKind::kd, hw::BuildAlgorithm::sah)};
  for (const hw::TreeKind kind : bvhs) {
    for (const hw::BuildAlgorithm algorithm : {hw::BuildAlgorithm::sah, hw::BuildAlgorithm::morton}) {
      for (const bool refit : {false, true}) units.push_back(unit_with(kind, algorithm, refit));
    }
  }
  return units;
}

TEST(TreeBuilders, AllAreExactAndGiveTheSamePixels) {
  const TestScene scene = deforming(5);
  const Rendered reference = run(scene);
  for (const hw::UnitConfig& config : all_units()) {
    const Rendered r = run(scene, config);
    expect_exact(r);
    for (std::size_t i = 0; i < scene.frames.size(); ++i) {
      EXPECT_EQ(all_pixels(r.outcomes[i]), all_pixels(reference.outcomes[i]));
    }
  }
}

TEST(TreeBuilders, AreTheSameClockedShuffledAndExactWhenStalled) {
  const TestScene scene = deforming(2);
  for (hw::UnitConfig config : all_units()) {
    config.tree_builder.outstanding = 3;
    const Rendered event = run(scene, config);
    sim::SimulationOptions clocked, stalled;
    clocked.fidelity = sim::Fidelity::clocked;
    clocked.shuffle_ticks = true;
    stalled.random_stall = true;
    const Rendered other = run(scene, config, clocked), slow = run(scene, config, stalled);
    stalled.fidelity = sim::Fidelity::clocked;
    const Rendered slow_clocked = run(scene, config, stalled);
    expect_exact(slow);
    for (std::size_t i = 0; i < scene.frames.size(); ++i) {
      EXPECT_EQ(all_counters(event.outcomes[i]), all_counters(other.outcomes[i]));
      EXPECT_EQ(all_counters(slow.outcomes[i]), all_counters(slow_clocked.outcomes[i]));
    }
  }
}

TEST(TreeBuilders, MortonBuildsFasterAndMakesAWorseTree) {
  const TestScene scene = deforming(1);
  for (const hw::TreeKind kind : bvhs) {
    const sim::FrameOutcome sah = run(scene, unit_with(kind, hw::BuildAlgorithm::sah)).outcomes[0];
    const sim::FrameOutcome morton = run(scene, unit_with(kind, hw::BuildAlgorithm::morton)).outcomes[0];
    EXPECT_LT(counter(morton, "control_unit", "cycles_build"), counter(sah, "control_unit", "cycles_build"));
    EXPECT_GT(morton.dynamic_tree.sah_cost(), sah.dynamic_tree.sah_cost());
    EXPECT_NE(morton.node_visits, sah.node_visits);
  }
}

TEST(TreeBuilders, RefitIsFasterThanABuildAndBuildsEachInterval) {
  const TestScene scene = deforming(5);
  for (const hw::TreeKind kind : bvhs) {
    const Rendered built = run(scene, unit_with(kind, hw::BuildAlgorithm::sah));
    const Rendered kept = run(scene, unit_with(kind, hw::BuildAlgorithm::sah, true));
    for (std::size_t i = 0; i < scene.frames.size(); ++i) {
      const bool base = i % 3 == 0;
      EXPECT_EQ(counter(kept.outcomes[i], "tree_builder", "builds"), base ? 1u : 0u);
      EXPECT_EQ(counter(kept.outcomes[i], "tree_builder", "refits"), base ? 0u : 1u);
      if (base) {
        EXPECT_EQ(all_counters(kept.outcomes[i]), all_counters(built.outcomes[i]));
      } else {
        EXPECT_LT(counter(kept.outcomes[i], "control_unit", "cycles_build"),
                  counter(built.outcomes[i], "control_unit", "cycles_build"));
        EXPECT_GE(kept.outcomes[i].dynamic_tree.sah_cost(), built.outcomes[i].dynamic_tree.sah_cost());
      }
    }
  }
}

TEST(TreeBuilders, WithRefitAFrameAloneAndInAnyOrderTakesTheSameCycles) {
  TestScene scene = deforming(6);
  scene.frames[2].dynamic = scene.frames[1].dynamic;
  scene.frames[2].dynamic_moved = false;
  scene.frames[3].dynamic = scene.frames[2].dynamic;
  scene.frames[3].dynamic_moved = false;  // a base, which is built all the same
  const hw::UnitConfig config = unit_with(hw::TreeKind::bvh4, hw::BuildAlgorithm::sah, true);
  const Rendered forward = run(scene, config);
  expect_exact(forward);
  EXPECT_EQ(counter(forward.outcomes[2], "tree_builder", "refits"), 0u);
  EXPECT_EQ(counter(forward.outcomes[3], "tree_builder", "builds"), 1u);
  sim::Simulator mixed(scene.scene, config, {}, frames_of(scene));
  for (const std::size_t i : {5u, 2u, 0u, 4u, 1u, 3u, 1u}) {
    sim::Simulator own(scene.scene, config, {}, frames_of(scene));
    for (sim::Simulator* simulator : {&own, &mixed}) {
      const sim::FrameOutcome outcome = simulator->run(scene.frames[i]);
      EXPECT_EQ(all_counters(outcome), all_counters(forward.outcomes[i])) << i;
      EXPECT_EQ(outcome.dynamic_tree.sah_cost(), forward.outcomes[i].dynamic_tree.sah_cost()) << i;
    }
  }
}

TEST(TreeBuilders, LeavesOfEverySizeAreExact) {
  const TestScene scene = deforming(1);
  for (const hw::TreeKind kind : all_kinds) {
    for (const std::uint32_t leaf_size : {1u, 2u, 7u, 16u}) {
      hw::UnitConfig config = unit_with(kind, hw::BuildAlgorithm::sah);
      config.accel.static_kind = kind;
      config.accel.leaf_size = leaf_size;
      expect_exact(run(scene, config));
    }
  }
}

TEST(TreeBuilders, WideCodesAndAKnownBoxAreExact) {
  const TestScene scene = deforming(1);
  hw::UnitConfig config = unit_with(hw::TreeKind::bvh2, hw::BuildAlgorithm::morton);
  config.tree_builder.code_bits = 21;
  config.tree_builder.digit_bits = 11;
  config.tree_builder.known_box = true;
  expect_exact(run(scene, config));
}

}  // namespace
}  // namespace artu::golden_tests
