// What is said of a tree: its cost by hand, the work of building it, and leaves of every size.
#include "sim/driver/tree_quality.h"

#include "tree_check.h"

namespace artu::sim::test {

namespace {

TreeRecipe recipe(hw::TreeKind kind, std::uint32_t leaf_size, std::uint32_t on_chip = 1024) {
  hw::TreeBuilderConfig builder;
  builder.triangles_per_pass = on_chip;
  return {kind, leaf_size, builder};
}

/// Walls across x at 0, 1, 2 ... : each is a box of 0 x 1 x 1.
traces::Mesh walls(int count) {
  traces::Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const float x = static_cast<float>(i);
    add(mesh, {x, 0, 0}, {x, 1, 0}, {x, 0, 1});
  }
  return mesh;
}

TEST(TreeQuality, OneLeafIsTestedByEveryRay) {
  TreeRecipe morton = recipe(hw::TreeKind::bvh2, 4);  // whose leaves are as large as they may be
  morton.builder.algorithm = hw::BuildAlgorithm::morton;
  const TreeQuality q = quality_of(build_tree(walls(3), morton, false, "test"));
  EXPECT_EQ(q.nodes, 0u);
  EXPECT_EQ(q.leaves, 1u);
  EXPECT_EQ(q.depth, 0u);
  EXPECT_EQ(q.references, 3u);
  EXPECT_EQ(q.box_tests, 0);
  EXPECT_EQ(q.triangle_tests, 3);
  EXPECT_EQ(q.sah_cost(), 6);
}

TEST(TreeQuality, AnEmptyTreeCostsNothing) {
  const TreeQuality q = quality_of(build_tree({}, hw::TreeKind::bvh4, false, "test"));
  EXPECT_EQ(q.leaves, 0u);
  EXPECT_EQ(q.sah_cost(), 0);
}

TEST(TreeQuality, FourWallsHalvedTwiceByHand) {
  // Half surfaces: 3 x 1 x 1 has 7, a pair's 1 x 1 x 1 has 3, a wall's 0 x 1 x 1 has 1.
  const TreeQuality q = quality_of(build_tree(walls(4), recipe(hw::TreeKind::bvh2, 1), false, "test"));
  EXPECT_EQ(q.nodes, 3u);
  EXPECT_EQ(q.leaves, 4u);
  EXPECT_EQ(q.depth, 2u);
  EXPECT_DOUBLE_EQ(q.box_tests, 2 + 2 * 2 * 3 / 7.0);
  EXPECT_DOUBLE_EQ(q.triangle_tests, 4 / 7.0);
  EXPECT_DOUBLE_EQ(q.sah_cost(), q.box_tests + 2 * q.triangle_tests);
}

TEST(TreeQuality, AFlatTreeIsMetEverywhere) {
  traces::Mesh points;
  for (int i = 0; i < 8; ++i) add(points, {1, 2, 3}, {1, 2, 3}, {1, 2, 3});
  for (const hw::TreeKind kind : kinds) {
    const TreeQuality q = quality_of(build_tree(points, recipe(kind, 4), false, "test"));
    EXPECT_EQ(q.leaves, 2u);
    EXPECT_EQ(q.triangle_tests, 8);
  }
}

TEST(BuildWork, EverySplitHandlesWhatIsBelowIt) {
  const hw::BuildWork work = build_tree(walls(4), recipe(hw::TreeKind::bvh2, 1), false, "test").work;
  EXPECT_EQ(work.splits, 3u);
  EXPECT_EQ(work.references, 4u + 2 + 2);
  EXPECT_EQ(work.upper_splits, 0u);
  EXPECT_EQ(work.lower_references, 4u);
}

TEST(BuildWork, UpperSplitsAreThoseThatDoNotFitOnChip) {
  const traces::Mesh mesh = sphere(64, 33);
  const auto n = static_cast<std::uint32_t>(mesh.triangle_count());
  for (const hw::TreeKind kind : {hw::TreeKind::bvh2, hw::TreeKind::bvh8, hw::TreeKind::kd}) {
    const auto work = [&](std::uint32_t on_chip) {
      return build_tree(mesh, recipe(kind, 4, on_chip), false, "test").work;
    };
    const hw::BuildWork all = work(n), root = work(n - 1), many = work(16);
    EXPECT_EQ(all.upper_splits, 0u);
    EXPECT_EQ(all.upper_levels, 0u);
    EXPECT_EQ(all.lower_references, n);
    EXPECT_EQ(root.upper_splits, 1u);
    EXPECT_EQ(root.upper_references, n);
    EXPECT_EQ(root.upper_levels, 1u);
    EXPECT_GT(many.upper_levels, 5u);
    EXPECT_GE(many.lower_references, n);
    for (const hw::BuildWork& w : {root, many}) {
      EXPECT_EQ(w.splits, all.splits);
      EXPECT_EQ(w.references, all.references);
    }
    if (kind == hw::TreeKind::kd) {
      EXPECT_GT(root.lower_references, n);
    } else {
      EXPECT_EQ(many.lower_references, n);
    }
  }
}

TEST(LeafSize, NoLeafOfAnyTreeIsLarger) {
  for (const hw::TreeKind kind : kinds) {
    for (std::uint32_t leaf_size = 1; leaf_size <= 16; ++leaf_size) {
      for (const auto& mesh : {soup(500, 0.2f), coincident(5, 40), all_sizes(300), soup(7, 1)}) {
        checked_tree(mesh, recipe(kind, leaf_size));
        if (kind == hw::TreeKind::kd) continue;
        TreeRecipe morton = recipe(kind, leaf_size);
        morton.builder.algorithm = hw::BuildAlgorithm::morton;
        checked_tree(mesh, morton);
      }
    }
  }
}

TEST(LeafSize, LargerLeavesMakeFewerNodes) {
  const traces::Mesh mesh = coincident(20, 50);
  for (const hw::TreeKind kind : kinds) {
    const std::uint64_t one = quality_of(build_tree(mesh, recipe(kind, 1), false, "test")).nodes;
    const std::uint64_t four = quality_of(build_tree(mesh, recipe(kind, 4), false, "test")).nodes;
    const std::uint64_t sixteen = quality_of(build_tree(mesh, recipe(kind, 16), false, "test")).nodes;
    EXPECT_GT(one, four);
    EXPECT_GT(four, sixteen);
  }
}

}  // namespace

}  // namespace artu::sim::test
