// What `sampled` knows of a frame without its simulation: its kind, its cost, and which others are equal to it.
#include <gtest/gtest.h>

#include "hw/memory/build_plan.h"
#include "sim/command/example_scene.h"
#include "sim/sampled/frame_costs.h"
#include "tree_support.h"

namespace artu::sim {
namespace {

const traces::Scene& scene() {
  static const traces::Scene all = example_scene();
  return all;
}

traces::Frame frame_with(const traces::Mesh& dynamic) {
  traces::Frame frame = example_frame();
  frame.dynamic = dynamic;
  const std::size_t vertices = dynamic.positions.size();
  frame.dynamic.normals.resize(vertices);
  frame.dynamic.uvs.resize(vertices);
  frame.dynamic.colors.resize(vertices, 0xffffffffu);
  frame.dynamic_moved = true;
  return frame;
}

FrameCost cost_of(const traces::Frame& frame, const hw::UnitConfig& unit = {}) {
  return FrameCosts(scene(), unit, {}).at(frame).cost;
}

TEST(FrameCosts, ABuildCostsWhatItComputes) {
  const traces::Mesh mesh = test::sphere(24, 13);
  traces::Frame moved = frame_with(mesh), still = moved;
  still.dynamic_moved = false;
  const FrameCost with = cost_of(moved), without = cost_of(still);
  EXPECT_EQ(with.kind, FrameKind::built);
  EXPECT_EQ(without.kind, FrameKind::nothing_built);

  const hw::UnitConfig unit;
  const Tree tree =
      build_tree(mesh, TreeRecipe(unit.accel.dynamic_kind, unit.accel.leaf_size, unit.tree_builder), true, "test");
  hw::FrameDescriptor frame{};
  frame.dynamic_kind = unit.accel.dynamic_kind;
  frame.dynamic_triangle_count = static_cast<std::uint32_t>(mesh.triangle_count());
  frame.dynamic_reference_count = static_cast<std::uint32_t>(tree.order.size());
  frame.build = tree.work;
  double computes = 0;
  for (const hw::BuildStep& step : hw::plan_build(unit.tree_builder, frame)) {
    computes += static_cast<double>(step.compute);
  }
  EXPECT_GT(computes, static_cast<double>(mesh.triangle_count()));
  EXPECT_NEAR(with.work - without.work, computes, 1e-6 * computes);

  // Where nothing is skipped it is built in every frame.
  hw::UnitConfig always;
  always.skip.rebuild = false;
  EXPECT_EQ(cost_of(still, always).kind, FrameKind::built);
}

TEST(FrameCosts, FramesAreEqualInAllButTheirPlace) {
  const traces::Frame first = frame_with(test::sphere(8, 5));
  traces::Frame later = first, nearer = first, darker = first, moved = first, still = first;
  later.index += 7;
  later.time += 1;
  nearer.camera.origin.z += 0.125f;
  darker.ambient.x /= 2;
  moved.dynamic.positions[3].y += 0.125f;
  still.dynamic_moved = false;
  FrameCosts costs(scene(), {}, {});
  const FrameCost cost = costs.at(first).cost;
  EXPECT_NE(cost.digest, FrameDigest{});
  EXPECT_EQ(costs.at(later).cost.digest, cost.digest);
  EXPECT_EQ(costs.at(later).cost.work, cost.work);
  for (const traces::Frame& other : {nearer, darker, moved, still}) EXPECT_NE(costs.at(other).cost.digest, cost.digest);
  EXPECT_EQ(FrameCosts(scene(), {}, {}).at(later).cost.digest, cost.digest);
}

TEST(FrameCosts, WithRefitNoFrameIsKnownToEqualAnother) {
  hw::UnitConfig unit;
  unit.tree_builder.refit = true;
  traces::Frame frame = frame_with(test::sphere(8, 5));
  FrameCosts costs(scene(), unit, {}, [&](std::uint32_t) { return frame; });
  EXPECT_EQ(costs.at(frame).cost.digest, FrameDigest{});
}

}  // namespace
}  // namespace artu::sim
