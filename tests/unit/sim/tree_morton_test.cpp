// Trees from Morton codes: the codes, the order, the radix tree, and that they are sound for any mesh.
#include "sim/driver/tree_morton.h"

#include "sim/driver/tree_bvh2.h"
#include "tree_check.h"

namespace artu::sim::test {

namespace {

constexpr hw::TreeKind bvhs[] = {hw::TreeKind::bvh2, hw::TreeKind::bvh4, hw::TreeKind::bvh8};

TreeRecipe morton(hw::TreeKind kind, std::uint32_t code_bits = 10, std::uint32_t leaf_size = 4) {
  hw::TreeBuilderConfig builder;
  builder.algorithm = hw::BuildAlgorithm::morton;
  builder.code_bits = code_bits;
  return {kind, leaf_size, builder};
}

Box point(float x, float y, float z) { return {{x, y, z}, {x, y, z}}; }

TEST(Morton, BitsAreInterleavedFromTheHighestDown) {
  EXPECT_EQ(interleave(1, 0, 0, 1), 4u);
  EXPECT_EQ(interleave(0, 1, 0, 1), 2u);
  EXPECT_EQ(interleave(0, 0, 1, 1), 1u);
  EXPECT_EQ(interleave(0b1011, 0b0010, 0b1110, 4), 0b101'001'111'100u);
  EXPECT_EQ(interleave(0x1fffff, 0x1fffff, 0x1fffff, 21), (std::uint64_t{1} << 63) - 1);
}

TEST(Morton, CodesAreTheCellsOfTheCentresOnTheGrid) {
  const std::vector<Box> boxes = {
      point(0, 0, 0), point(8, 4, 2), point(3.9f, 3.9f, 1.9f), {{0, 0, 0}, {8, 4, 2}}, point(4, 0, 0)};
  // Two bits: cells are 2, 1 and 0.5 wide, the last one closed.
  const std::vector<std::uint64_t> codes = morton_codes(boxes, {{0, 0, 0}, {8, 4, 2}}, 2);
  EXPECT_EQ(codes, (std::vector<std::uint64_t>{0, 0b111'111, 0b011'111, 0b111'000, 0b100'000}));
}

TEST(Morton, AFlatGridHasOneCellAcross) {
  const std::vector<Box> boxes = {point(0, 5, 1), point(1, 5, 0)};
  EXPECT_EQ(morton_codes(boxes, centre_box(boxes), 1), (std::vector<std::uint64_t>{1, 4}));
}

TEST(Morton, TheGridIsTheBoxOfTheCentresOrTheKnownOne) {
  // The centres lie in a quarter of the root box, so that a known box leaves them less of its grid.
  traces::Mesh mesh;
  add(mesh, {-100, -100, -100}, {100, 100, 100}, {0, 0, 0});
  for (int i = 0; i < 64; ++i) {
    const float x = static_cast<float>(i) * 0.1f;
    add(mesh, {x, 0, 0}, {x, 0.01f, 0}, {x, 0, 0.01f});
  }
  TreeRecipe own = morton(hw::TreeKind::bvh2, 5, 1), known = own;
  known.builder.known_box = true;
  const Tree a = checked_tree(mesh, own), b = checked_tree(mesh, known);
  EXPECT_NE(a.nodes, b.nodes);
}

/// Triangles in a row along x, one to a cell of the grid's 16.
traces::Mesh row(const std::vector<int>& cells) {
  traces::Mesh mesh;
  for (const int cell : cells) {
    const float x = static_cast<float>(cell);
    add(mesh, {x, 0, 0}, {x, 0, 0}, {x, 0, 0});
  }
  return mesh;
}

TEST(Morton, LeavesAreInTheOrderOfTheCodesAndThenOfTheTriangles) {
  const Tree tree = build_tree(row({15, 3, 0, 3, 8, 0, 15, 3}), morton(hw::TreeKind::bvh2, 4, 1), false, "test");
  EXPECT_EQ(tree.order, (std::vector<std::uint32_t>{2, 5, 1, 3, 7, 4, 0, 6}));
}

/// The tree as text: a leaf is its triangles, a node its children in brackets.
std::string text(const BinaryNode& node) {
  if (!node.is_leaf()) return "(" + text(*node.child[0]) + " " + text(*node.child[1]) + ")";
  std::string result;
  for (std::uint32_t i = 0; i < node.count; ++i) result += (i == 0 ? "" : "+") + std::to_string(node.triangle[i]);
  return result;
}

std::string text_of(const traces::Mesh& mesh, std::uint32_t leaf_size) {
  return text(BinaryTree(triangle_boxes(mesh), morton(hw::TreeKind::bvh2, 4, leaf_size)).root());
}

TEST(Morton, NodesSplitWhereTheHighestBitChanges) {
  // 0, 1, 3 | 8, 12, 15: the top bit; then 0, 1 | 3 and 8 | 12, 15.
  EXPECT_EQ(text_of(row({0, 1, 3, 8, 12, 15}), 1), "(((0 1) 2) (3 (4 5)))");
  EXPECT_EQ(text_of(row({0, 1, 3, 8, 12, 15}), 2), "((0+1 2) (3 4+5))");
  EXPECT_EQ(text_of(row({0, 1, 3, 8, 12, 15}), 3), "(0+1+2 3+4+5)");
  EXPECT_EQ(text_of(row({0, 1, 3, 8, 12, 15}), 6), "0+1+2+3+4+5");
}

TEST(Morton, EqualCodesSplitByTheHighestBitOfTheirPlace) {
  EXPECT_EQ(text_of(row({7, 7, 7, 7, 7, 7, 7}), 1), "(((0 1) (2 3)) ((4 5) 6))");
  // Places 1 ... 3 have code 15: 1 | 2, 3.
  EXPECT_EQ(text_of(row({0, 15, 15, 15}), 1), "(0 (1 (2 3)))");
}

TEST(Morton, AnyMeshGivesASoundTree) {
  for (const hw::TreeKind kind : bvhs) {
    for (const std::uint32_t bits : {4u, 10u, 21u}) {
      for (const auto& mesh : {soup(3000, 0.1f), slivers(1000), sphere(60, 40), heights(30), coincident(30, 40),
                               transformed(soup(500, 0.1f), 0x1p60f, 0), transformed(soup(500, 0.1f), 0x1p-140f, 0),
                               transformed(sphere(40, 20), 1, 1e7f), all_sizes(2000), traces::Mesh()}) {
        checked_tree(mesh, morton(kind, bits), true);
      }
    }
    for (int count = 1; count <= 40; ++count) checked_tree(soup(count, 0.3f), morton(kind));
  }
}

TEST(Morton, NoTreeIsDeeperThanACodeAndAPlaceHaveBits) {
  for (const std::uint32_t bits : {4u, 10u, 21u}) {
    const traces::Mesh mesh = all_sizes(4000);
    EXPECT_LE(build_tree(mesh, morton(hw::TreeKind::bvh2, bits, 1), false, "test").stack, 3 * bits + 12);
  }
}

TEST(Morton, TwoBuildsGiveTheSameBytes) {
  for (const hw::TreeKind kind : bvhs) {
    const Tree a = build_tree(soup(5000, 0.1f), morton(kind), true, "test");
    const Tree b = build_tree(soup(5000, 0.1f), morton(kind), true, "test");
    EXPECT_EQ(a.nodes, b.nodes);
    EXPECT_EQ(a.order, b.order);
  }
}

TEST(Morton, KdTreesAreRefused) {
  EXPECT_THROW(build_tree(soup(5, 1), morton(hw::TreeKind::kd), true, "test"), std::invalid_argument);
}

}  // namespace

}  // namespace artu::sim::test
