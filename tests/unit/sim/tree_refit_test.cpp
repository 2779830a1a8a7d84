// Refit keeps nodes and order and makes sound boxes; which frame a frame's nodes come from depends on its index alone.
#include "sim/driver/tree_refit.h"

#include "sim/driver/dynamic_trees.h"
#include "sim/driver/tree_quality.h"
#include "tree_check.h"

namespace artu::sim::test {

namespace {

constexpr hw::TreeKind bvhs[] = {hw::TreeKind::bvh2, hw::TreeKind::bvh4, hw::TreeKind::bvh8};

traces::Mesh twisted(const traces::Mesh& mesh, float by) {
  traces::Mesh result = mesh;
  for (traces::Vec3& v : result.positions) {
    const double angle = by * v.y, c = std::cos(angle), s = std::sin(angle);
    v = {static_cast<float>(c * v.x - s * v.z), v.y + by, static_cast<float>(s * v.x + c * v.z)};
  }
  return result;
}

TEST(Refit, MovedTrianglesHaveASoundTreeOfTheSameNodes) {
  for (const hw::TreeKind kind : bvhs) {
    for (const auto& mesh : {soup(3000, 0.1f), sphere(60, 40), coincident(30, 40), soup(1, 1), soup(5, 1)}) {
      const Tree before = build_tree(mesh, kind, true, "test");
      for (const float by : {0.0f, 0.5f, 20.0f}) {
        const traces::Mesh moved = by == 0 ? mesh : twisted(mesh, by);
        Tree after = before;
        refit(moved, after);
        TreeCheck(moved, after, true).run();
        EXPECT_EQ(after.order, before.order);
        EXPECT_EQ(after.root, before.root);
        EXPECT_EQ(quality_of(after).nodes, quality_of(before).nodes);
        if (by == 0) {
          EXPECT_EQ(after.nodes, before.nodes);
        }
      }
    }
  }
}

TEST(Refit, WhatMovesFarApartMakesAWorseTreeThanABuild) {
  const traces::Mesh mesh = sphere(60, 40), moved = twisted(mesh, 6);
  for (const hw::TreeKind kind : bvhs) {
    Tree kept = build_tree(mesh, kind, true, "test");
    refit(moved, kept);
    EXPECT_GT(quality_of(kept).sah_cost(), quality_of(build_tree(moved, kind, true, "test")).sah_cost());
  }
}

TEST(Refit, OtherNumbersOfTrianglesAndKdTreesAreRefused) {
  Tree tree = build_tree(soup(10, 1), hw::TreeKind::bvh2, true, "test");
  EXPECT_THROW(refit(soup(11, 1), tree), std::invalid_argument);
  Tree kd = build_tree(soup(10, 1), hw::TreeKind::kd, true, "test");
  EXPECT_THROW(refit(soup(10, 1), kd), std::invalid_argument);
}

/// A sequence that twists more and more; `first` is the index of the first frame that there is.
struct Sequence {
  explicit Sequence(std::uint32_t first = 0) : first(first) {}
  traces::Frame frame(std::uint32_t index) const {
    traces::Frame result;
    result.index = index;
    result.dynamic = twisted(sphere(20 + (index >= 6 ? 2 : 0), 10), 0.3f * static_cast<float>(index));
    result.dynamic_moved = index != 2 && index != 4;
    return result;
  }
  DynamicTrees trees(std::uint32_t interval) {
    TreeRecipe recipe = hw::TreeKind::bvh4;
    recipe.builder.refit = true;
    recipe.builder.refit_interval = interval;
    return DynamicTrees(recipe, [this](std::uint32_t index) {
      asked.push_back(index);
      return frame(std::max(index, first));
    });
  }
  const std::uint32_t first;
  std::vector<std::uint32_t> asked;
};

TEST(DynamicTrees, AFrameAloneHasTheTreeThatItHasInAnyOrder) {
  Sequence sequence;
  std::vector<DynamicTree> forward;
  DynamicTrees all = sequence.trees(4);
  for (std::uint32_t i = 0; i < 10; ++i) forward.push_back(all.of(sequence.frame(i), "test"));
  EXPECT_TRUE(sequence.asked.empty());
  DynamicTrees mixed = sequence.trees(4);
  for (const std::uint32_t i : {9u, 3u, 4u, 3u, 0u, 8u, 7u, 5u, 2u, 1u, 6u}) {
    DynamicTrees own = sequence.trees(4);
    for (DynamicTrees* trees : {&own, &mixed}) {
      const DynamicTree tree = trees->of(sequence.frame(i), "test");
      EXPECT_EQ(tree.tree.nodes, forward[i].tree.nodes) << i;
      EXPECT_EQ(tree.tree.order, forward[i].tree.order) << i;
      EXPECT_EQ(tree.moved, forward[i].moved) << i;
      EXPECT_EQ(tree.refitted, forward[i].refitted) << i;
    }
  }
}

TEST(DynamicTrees, BasesAreBuiltAlsoWhereNothingMovedAndTheOthersWhereTheNumberOfTrianglesDiffers) {
  Sequence sequence;
  DynamicTrees trees = sequence.trees(4);
  std::string what;
  for (std::uint32_t i = 0; i < 10; ++i) {
    const DynamicTree tree = trees.of(sequence.frame(i), "test");
    what += !tree.moved ? 'k' : tree.refitted ? 'r' : 'b';
  }
  // 2 is kept; 4 has not moved, but is a base; from 6 on there are more triangles than in 4.
  EXPECT_EQ(what, "brkrbrbbbr");
}

TEST(DynamicTrees, ASequenceThatBeginsLaterHasItsFirstFrameAsABase) {
  Sequence sequence(3);
  DynamicTrees trees = sequence.trees(4);
  EXPECT_FALSE(trees.of(sequence.frame(3), "test").refitted);
  DynamicTrees long_interval = sequence.trees(100);
  const DynamicTree later = long_interval.of(sequence.frame(5), "test");
  EXPECT_TRUE(later.refitted);
  EXPECT_EQ(later.tree.order, build_tree(sequence.frame(3).dynamic, hw::TreeKind::bvh4, true, "test").order);
  EXPECT_EQ(sequence.asked, (std::vector<std::uint32_t>{0, 0}));
}

TEST(DynamicTrees, WithoutRefitEveryFrameIsBuilt) {
  const Sequence sequence;
  DynamicTrees trees(hw::TreeKind::bvh2, {});
  const DynamicTree tree = trees.of(sequence.frame(3), "test");
  EXPECT_FALSE(tree.refitted);
  EXPECT_EQ(tree.tree.nodes, build_tree(sequence.frame(3).dynamic, hw::TreeKind::bvh2, true, "test").nodes);
}

}  // namespace

}  // namespace artu::sim::test
