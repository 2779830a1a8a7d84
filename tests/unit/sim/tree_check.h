// Whether a tree is what the format promises: a second reading of its bytes.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "sim/driver/tree_box.h"
#include "tree_support.h"

namespace artu::sim::test {

inline bool contains(const Box& outer, const Box& inner) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(outer.lo[axis] <= inner.lo[axis] && inner.hi[axis] <= outer.hi[axis])) return false;
  }
  return true;
}

inline bool touches(const Box& a, const Box& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(a.lo[axis] <= b.hi[axis] && b.lo[axis] <= a.hi[axis])) return false;
  }
  return true;
}

class TreeCheck {
 public:
  using Ids = std::vector<std::uint32_t>;

  TreeCheck(const traces::Mesh& mesh, const Tree& tree, bool dynamic,
            std::uint32_t leaf_size = hw::AccelConfig().leaf_size)
      : tree_(tree), dynamic_(dynamic), leaf_size_(leaf_size) {
    for (std::size_t i = 0; i < mesh.triangle_count(); ++i) boxes_.push_back(triangle_box(mesh, i));
  }

  /// Also collects, by axis, all planes that the tree has.
  void run() {
    if (boxes_.empty()) {
      EXPECT_EQ(tree_.root, hw::NodeReference::none);
      EXPECT_TRUE(tree_.nodes.empty());
      EXPECT_TRUE(tree_.order.empty());
      return;
    }
    const Box root{tree_.lo, tree_.hi};
    Ids all;
    for (std::uint32_t i = 0; i < boxes_.size(); ++i) all.push_back(i);
    for (const Box& box : boxes_) ASSERT_TRUE(contains(root, box));
    const Ids below = visit(tree_.root, root, all, 0);
    EXPECT_EQ(next_node_ * hw::node_bytes(tree_.kind), tree_.nodes.size());
    EXPECT_EQ(next_record_, tree_.order.size());
    EXPECT_EQ(stack_, tree_.stack);
    EXPECT_EQ(below, all);
    EXPECT_LE(tree_.order.size(), (tree_.kind == hw::TreeKind::kd ? 4 : 1) * boxes_.size());
    EXPECT_EQ(bad_, 0) << first_bad_;
  }

  std::vector<float> planes[3];
  std::uint32_t depth = 0;

 private:
  void expect(bool good, const char* what) {
    if (!good && bad_++ == 0) first_bad_ = std::string(what) + " at node " + std::to_string(next_node_);
  }

  /// All triangles below `reference`, by rising id.  `box` must contain them in a BVH; in a kd-tree it is the cell, and
  /// `expected` are the triangles that touch it.
  Ids visit(std::uint32_t reference, const Box& box, const Ids& expected, std::uint32_t stacked,
            std::uint32_t level = 0) {
    Ids found;
    const bool kd = tree_.kind == hw::TreeKind::kd;
    if (reference == hw::NodeReference::none) {
      expect(kd, "no child");
    } else if (expect(hw::NodeReference::is_dynamic(reference) == dynamic_, "class");
               hw::NodeReference::is_leaf(reference)) {
      expect(hw::NodeReference::first(reference) == next_record_, "run not in order");
      next_record_ += hw::NodeReference::count(reference);
      for (std::uint32_t i = 0; i < hw::NodeReference::count(reference); ++i) {
        found.push_back(tree_.order.at(hw::NodeReference::first(reference) + i));
      }
      expect(found.size() <= leaf_size_, "leaf too large");
      expect(std::is_sorted(found.begin(), found.end()), "leaf not sorted");
      stack_ = std::max(stack_, stacked);
    } else {
      expect(hw::NodeReference::index(reference) == next_node_, "node not in order");
      depth = std::max(depth, level + 1);
      const std::uint8_t* record =
          tree_.nodes.data() + std::size_t{hw::NodeReference::index(reference)} * hw::node_bytes(tree_.kind);
      ++next_node_;
      if (kd) {
        found = visit_kd(record, box, expected, stacked, level);
      } else if (tree_.kind == hw::TreeKind::bvh2) {
        hw::NodeRecord node;
        std::memcpy(&node, record, sizeof node);
        visit_children(node.child, {{node.lo[0], node.hi[0]}, {node.lo[1], node.hi[1]}}, stacked, level, found);
      } else if (tree_.kind == hw::TreeKind::bvh4) {
        visit_wide<4>(record, stacked, level, found);
      } else {
        visit_wide<8>(record, stacked, level, found);
      }
    }
    std::sort(found.begin(), found.end());
    if (kd) {
      found.erase(std::unique(found.begin(), found.end()), found.end());
    } else {
      for (const std::uint32_t id : found) expect(contains(box, boxes_[id]), "triangle outside of a box");
    }
    return found;
  }

  template <int Width>
  void visit_wide(const std::uint8_t* record, std::uint32_t stacked, std::uint32_t level, Ids& found) {
    hw::WideNodeRecord<Width> node;
    std::memcpy(&node, record, sizeof node);
    expect(node.count >= 1 && node.count <= Width, "count");
    std::vector<Box> boxes;
    for (int i = 0; i < node.count; ++i) {
      boxes.push_back({{decoded_lo(node, 0, i), decoded_lo(node, 1, i), decoded_lo(node, 2, i)},
                       {decoded_hi(node, 0, i), decoded_hi(node, 1, i), decoded_hi(node, 2, i)}});
      for (int axis = 0; axis < 3; ++axis) expect(node.exponent[axis] >= 1 && node.exponent[axis] <= 254, "exponent");
    }
    visit_children(node.child, boxes, stacked, level, found);
  }

  void visit_children(const std::uint32_t* child, const std::vector<Box>& boxes, std::uint32_t stacked,
                      std::uint32_t level, Ids& found) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        planes[axis].push_back(boxes[i].lo[axis]);
        planes[axis].push_back(boxes[i].hi[axis]);
      }
      const Ids below =
          visit(child[i], boxes[i], {}, stacked + static_cast<std::uint32_t>(boxes.size()) - 1, level + 1);
      found.insert(found.end(), below.begin(), below.end());
    }
  }

  Ids visit_kd(const std::uint8_t* record, const Box& cell, const Ids& expected, std::uint32_t stacked,
               std::uint32_t level) {
    hw::KdNodeRecord node;
    std::memcpy(&node, record, sizeof node);
    if (node.child[0] != hw::NodeReference::none && node.child[1] != hw::NodeReference::none) ++stacked;
    Ids found;
    Box cells[2] = {cell, cell};
    Ids touching[2];
    const bool both = node.axis == hw::KdNodeRecord::both;
    if (!both) {
      const int axis = static_cast<int>(node.axis);
      expect(axis < 3 && std::isfinite(node.split), "plane");
      expect(cell.lo[axis] < node.split && node.split < cell.hi[axis], "plane outside of its cell");
      planes[axis].push_back(node.split);
      (axis == 0 ? cells[0].hi.x : axis == 1 ? cells[0].hi.y : cells[0].hi.z) = node.split;
      (axis == 0 ? cells[1].lo.x : axis == 1 ? cells[1].lo.y : cells[1].lo.z) = node.split;
    }
    for (int i = 0; i < 2; ++i) {
      for (std::size_t k = 0; k < expected.size() && !both; ++k) {
        const std::uint32_t id = expected[k];
        if (touches(cells[i], boxes_[id])) touching[i].push_back(id);
      }
      const Ids below = visit(node.child[i], cells[i], touching[i], stacked, level + 1);
      if (!both) expect(below == touching[i], "cell without one of its triangles");
      found.insert(found.end(), below.begin(), below.end());
    }
    return found;
  }

  const Tree& tree_;
  const bool dynamic_;
  const std::uint32_t leaf_size_;
  std::vector<Box> boxes_;
  std::uint32_t next_node_ = 0, next_record_ = 0, stack_ = 0;
  int bad_ = 0;
  std::string first_bad_;
};

/// Builds and checks.
inline Tree checked_tree(const traces::Mesh& mesh, const TreeRecipe& recipe, bool dynamic = false) {
  Tree tree = build_tree(mesh, recipe, dynamic, "test");
  SCOPED_TRACE(name(recipe.kind));
  TreeCheck(mesh, tree, dynamic, recipe.leaf_size).run();
  return tree;
}

}  // namespace artu::sim::test
