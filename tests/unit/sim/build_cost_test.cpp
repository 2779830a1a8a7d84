// What the tree builder's plan comes to for whole trees, against what is published of such hardware (docs/trees.md).
#include <gtest/gtest.h>

#include <algorithm>

#include "hw/memory/build_plan.h"
#include "tree_support.h"

namespace artu::sim::test {

namespace {

/// Cycles and lines of a build with a memory that is never waited for.
struct Cost {
  std::uint64_t cycles = 0, lines = 0;
};

Cost cost_of(const traces::Mesh& mesh, hw::TreeKind kind, const hw::TreeBuilderConfig& builder) {
  const Tree tree = build_tree(mesh, TreeRecipe(kind, hw::AccelConfig().leaf_size, builder), true, "test");
  hw::FrameDescriptor frame{};
  frame.dynamic_kind = kind;
  frame.dynamic_triangle_count = static_cast<std::uint32_t>(mesh.triangle_count());
  frame.dynamic_reference_count = static_cast<std::uint32_t>(tree.order.size());
  frame.dynamic_node_lines = static_cast<std::uint32_t>((tree.nodes.size() + 63) / 64);
  frame.dynamic_refit = builder.refit ? 1 : 0;
  frame.build = tree.work;
  Cost cost;
  for (const hw::BuildStep& step : hw::plan_build(builder, frame)) {
    std::uint64_t lines = 0;
    for (const hw::BuildStream& stream : step.streams) lines += stream.lines;
    cost.lines += lines;
    cost.cycles += std::max(step.compute, lines);  // one line a cycle
  }
  return cost;
}

const traces::Mesh& large() {
  static const traces::Mesh mesh = sphere(256, 129);
  return mesh;
}

TEST(BuildCost, AKdTreeOf64KTrianglesTakesAboutAsLongAsRayCores) {
  ASSERT_EQ(large().triangle_count(), 65536u);
  // 20 ms at 500 MHz.
  const double cycles = static_cast<double>(cost_of(large(), hw::TreeKind::kd, {}).cycles);
  EXPECT_GT(cycles, 10e6 / 1.5);
  EXPECT_LT(cycles, 10e6 * 1.5);
}

TEST(BuildCost, SortingIsThreeToSevenTimesAsFastAsBinningAndMovesLess) {
  hw::TreeBuilderConfig morton;
  morton.algorithm = hw::BuildAlgorithm::morton;
  const Cost binned = cost_of(large(), hw::TreeKind::bvh2, {}), sorted = cost_of(large(), hw::TreeKind::bvh2, morton);
  EXPECT_GT(binned.cycles, 3 * sorted.cycles);
  EXPECT_LT(binned.cycles, 7 * sorted.cycles);
  EXPECT_GT(binned.lines, sorted.lines);
}

TEST(BuildCost, RefitIsTheCheapest) {
  hw::TreeBuilderConfig morton, refit;
  morton.algorithm = hw::BuildAlgorithm::morton;
  refit.refit = true;
  for (const hw::TreeKind kind : {hw::TreeKind::bvh2, hw::TreeKind::bvh4, hw::TreeKind::bvh8}) {
    const Cost kept = cost_of(large(), kind, refit), sorted = cost_of(large(), kind, morton);
    EXPECT_LT(kept.cycles, sorted.cycles);
    EXPECT_LT(kept.lines, sorted.lines);
  }
}

}  // namespace

}  // namespace artu::sim::test
