#include "sim/driver/tree_refit.h"

#include <cstring>
#include <stdexcept>

#include "sim/driver/tree_wide.h"

namespace artu::sim {

namespace {

using hw::NodeReference;

void set_boxes(const Box* boxes, hw::NodeRecord& node) {
  for (int i = 0; i < 2; ++i) {
    node.lo[i] = boxes[i].lo;
    node.hi[i] = boxes[i].hi;
  }
}
template <int Width>
void set_boxes(const Box* boxes, hw::WideNodeRecord<Width>& node) {
  quantise(boxes, node.count, node);
}

int children(const hw::NodeRecord&) { return 2; }
template <int Width>
int children(const hw::WideNodeRecord<Width>& node) {
  return node.count;
}

/// From the last node to the first: a node's children come after it.
template <class Node, int Width>
void refit_nodes(const std::vector<Box>& triangles, Tree& tree) {
  std::vector<Box> boxes(tree.nodes.size() / sizeof(Node));
  const auto box_of = [&](std::uint32_t reference) {
    if (!NodeReference::is_leaf(reference)) return boxes[NodeReference::index(reference)];
    const std::uint32_t* run = &tree.order[NodeReference::first(reference)];
    Box box = triangles[run[0]];
    for (std::uint32_t i = 1; i < NodeReference::count(reference); ++i) grow(box, triangles[run[i]]);
    return box;
  };
  for (std::size_t index = boxes.size(); index-- > 0;) {
    Node node;
    std::memcpy(&node, tree.nodes.data() + index * sizeof node, sizeof node);
    Box own[Width];
    for (int i = 0; i < children(node); ++i) own[i] = box_of(node.child[i]);
    set_boxes(own, node);
    std::memcpy(tree.nodes.data() + index * sizeof node, &node, sizeof node);
    boxes[index] = own[0];
    for (int i = 1; i < children(node); ++i) grow(boxes[index], own[i]);
  }
}

}  // namespace

void refit(const traces::Mesh& mesh, Tree& tree) {
  if (tree.order.size() != mesh.triangle_count()) throw std::invalid_argument("refit: another number of triangles");
  if (tree.order.empty()) return;
  const std::vector<Box> triangles = triangle_boxes(mesh);
  Box all = triangles[0];
  for (const Box& box : triangles) grow(all, box);
  tree.lo = all.lo;
  tree.hi = all.hi;
  switch (tree.kind) {
    case hw::TreeKind::bvh2:
      return refit_nodes<hw::NodeRecord, 2>(triangles, tree);
    case hw::TreeKind::bvh4:
      return refit_nodes<hw::WideNodeRecord<4>, 4>(triangles, tree);
    case hw::TreeKind::bvh8:
      return refit_nodes<hw::WideNodeRecord<8>, 8>(triangles, tree);
    case hw::TreeKind::kd:
      break;
  }
  throw std::invalid_argument("refit: a kd-tree has no boxes");
}

}  // namespace artu::sim
