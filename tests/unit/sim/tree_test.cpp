// Every kind of tree is sound for ordinary and for degenerate meshes.
#include <gtest/gtest.h>

#include "sim/driver/tree_wide.h"
#include "traces/error.h"
#include "tree_check.h"

namespace artu::sim::test {

namespace {

TEST(Tree, OrdinaryMeshesAreSound) {
  for (const hw::TreeKind kind : kinds) {
    for (const bool dynamic : {false, true}) {
      for (const auto& mesh : {soup(5000, 0.1f), slivers(2000), sphere(60, 40), heights(40), coincident(30, 40)}) {
        EXPECT_LE(checked_tree(mesh, kind, dynamic).stack, 60u);
      }
    }
  }
}

TEST(Tree, MovedAndScaledMeshesAreSound) {
  for (const hw::TreeKind kind : kinds) {
    for (const float move : {1000.0f, 1e5f, 1e7f, -0x1p61f}) {
      checked_tree(transformed(sphere(40, 20), 1, move), kind);
      checked_tree(transformed(soup(500, 0.1f), 1, move), kind);
    }
    for (const float scale : {1e-6f, 1e6f, 0x1p60f, 0x1p-60f, 0x1p-100f, 0x1p-140f}) {
      EXPECT_LE(checked_tree(transformed(soup(2000, 0.1f), scale, 0), kind).stack, 60u);
    }
  }
}

TEST(Tree, SizesFarApartStayShallow) {
  for (const hw::TreeKind kind : kinds) {
    EXPECT_LE(checked_tree(all_sizes(3000), kind).stack, 63u) << name(kind);
    traces::Mesh mixed = transformed(soup(1000, 0.1f), 0x1p61f, 0);
    const traces::Mesh tiny = transformed(soup(1000, 0.1f, 7), 0x1p-120f, 0);
    for (std::size_t i = 0; i < tiny.triangle_count(); ++i) {
      add(mixed, vertex(tiny, i, 0), vertex(tiny, i, 1), vertex(tiny, i, 2));
    }
    EXPECT_LE(checked_tree(mixed, kind).stack, 63u) << name(kind);
  }
}

TEST(Tree, NoTriangles) {
  for (const hw::TreeKind kind : kinds) {
    const Tree tree = checked_tree({}, kind);
    EXPECT_EQ(tree.kind, kind);
    EXPECT_EQ(tree.stack, 0u);
  }
}

TEST(Tree, MoreTrianglesThanTheFormatCanAddressAreRefused) {
  traces::Mesh mesh;
  mesh.materials.resize(hw::NodeReference::maximum_triangles + std::size_t{1});
  for (const hw::TreeKind kind : kinds) EXPECT_THROW(build_tree(mesh, kind, false, "test"), InputError);
}

TEST(Tree, AFewTriangles) {
  for (const hw::TreeKind kind : kinds) {
    for (int count = 1; count <= 40; ++count) {
      const Tree tree = checked_tree(soup(count, 0.3f), kind, count % 2 == 0);
      EXPECT_TRUE(count > 1 || hw::NodeReference::is_leaf(tree.root));
    }
  }
}

TEST(Tree, FlatThinAndPointLikeMeshes) {
  for (const hw::TreeKind kind : kinds) {
    Random random(9);
    traces::Mesh plane, line, points, point;
    for (int i = 0; i < 3000; ++i) {
      const auto corner = [&] { return hw::Vector{random.in(-1, 1), 0.5f, random.in(-1, 1)}; };
      add(plane, corner(), corner(), corner());
      const auto along = [&] { return hw::Vector{random.in(-1, 1), 0.5f, -2}; };
      add(line, along(), along(), along());
      const hw::Vector at = random.in_cube(1);
      add(points, at, at, at);
      add(point, {1, 2, 3}, {1, 2, 3}, {1, 2, 3});
    }
    for (const traces::Mesh* mesh : {&plane, &line, &points, &point}) {
      EXPECT_LE(checked_tree(*mesh, kind).stack, 63u) << name(kind);
    }
  }
}

TEST(Tree, AMillionCoincidentTriangles) {
  traces::Mesh mesh;
  for (int i = 0; i < 3; ++i)
    mesh.positions.push_back({i == 0 ? 1.0f : 0.0f, i == 1 ? 1.0f : 0.0f, i == 2 ? 1.0f : 0.0f});
  for (int i = 0; i < 1000000; ++i) mesh.indices.insert(mesh.indices.end(), {0, 1, 2});
  mesh.materials.resize(1000000);
  for (const hw::TreeKind kind : kinds) {
    const Tree tree = build_tree(mesh, kind, false, "test");
    EXPECT_LT(tree.stack, 64u) << name(kind);
    EXPECT_EQ(tree.order.size(), 1000000u);
    TreeCheck check(mesh, tree, false);
    check.run();
    EXPECT_LE(check.depth, 24u);
  }
}

TEST(Tree, KdTreesReferToTrianglesAFewTimes) {
  const auto times = [](const traces::Mesh& mesh) {
    return static_cast<double>(build_tree(mesh, hw::TreeKind::kd, false, "test").order.size()) /
           static_cast<double>(mesh.triangle_count());
  };
  EXPECT_LE(times(soup(20000, 0.05f)), 3);
  for (const auto& mesh : {sphere(100, 60), heights(80), slivers(5000), soup(5000, 1)}) EXPECT_LE(times(mesh), 4);
}

TEST(Tree, LargeLeavesOfKdTreesBecomeBalancedTrees) {
  for (int count = 16; count < 300; count += 7) {
    const Tree tree = checked_tree(coincident(1, count), hw::TreeKind::kd);
    ASSERT_EQ(tree.order.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(tree.nodes.size() / sizeof(hw::KdNodeRecord), static_cast<std::size_t>(count - 1) / 4);
    EXPECT_LE(tree.stack, 7u);
  }
}

TEST(Tree, BuildingTwiceGivesTheSameBytes) {
  for (const hw::TreeKind kind : kinds) {
    for (const auto& mesh : {soup(5000, 0.1f), slivers(2000), sphere(60, 40), heights(40), all_sizes(3000)}) {
      const Tree a = build_tree(mesh, kind, true, "test"), b = build_tree(mesh, kind, true, "test");
      EXPECT_EQ(a.root, b.root);
      EXPECT_EQ(a.nodes, b.nodes);
      EXPECT_EQ(a.order, b.order);
      EXPECT_EQ(a.stack, b.stack);
    }
  }
}

/// Boxes of all sizes and places.
template <int Width>
void quantise_anything(std::uint32_t seed) {
  Random random(seed);
  for (int round = 0; round < 20000; ++round) {
    const int count = 1 + static_cast<int>(random.below(Width));
    const float offset = random.one_in(3) ? 0 : std::ldexp(random.in(-1, 1), static_cast<int>(random.below(210)) - 149);
    const float extent = random.one_in(8) ? 0 : std::ldexp(random.in(-1, 1), static_cast<int>(random.below(210)) - 149);
    Box boxes[Width];
    for (int i = 0; i < count; ++i) {
      const auto corner = [&] {
        return hw::Vector{offset + extent * random.in(-1, 1), offset - extent * random.in(0, 1),
                          extent * random.in(0, 1)};
      };
      boxes[i].lo = boxes[i].hi = corner();
      const hw::Vector other = corner();
      if (!random.one_in(4)) grow(boxes[i], {other, other});
    }
    hw::WideNodeRecord<Width> node{};
    quantise(boxes, count, node);
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_GE(node.exponent[axis], 1);
      ASSERT_LE(node.exponent[axis], 254);
      const double step = hw::float_of(std::uint32_t{node.exponent[axis]} << 23);
      for (int i = 0; i < count; ++i) {
        const float lo = decoded_lo(node, axis, i), hi = decoded_hi(node, axis, i);
        ASSERT_LE(lo, boxes[i].lo[axis]);
        ASSERT_GE(hi, boxes[i].hi[axis]);
        // Not wider than needed: within a step, or the rounding of the decoder.
        const double slack = step + std::fabs(double{boxes[i].hi[axis]}) * 0x1p-22 + step * 255 * 0x1p-22;
        ASSERT_LE(double{boxes[i].lo[axis]} - lo, slack + std::fabs(double{boxes[i].lo[axis]}) * 0x1p-22);
        ASSERT_LE(double{hi} - boxes[i].hi[axis], slack);
      }
    }
  }
}

TEST(Tree, QuantisedBoxesContainTheExactOnes) {
  quantise_anything<4>(1);
  quantise_anything<8>(2);
}

}  // namespace

}  // namespace artu::sim::test
