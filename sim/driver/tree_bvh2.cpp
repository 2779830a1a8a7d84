#include "sim/driver/tree_bvh2.h"

#include <algorithm>
#include <cstring>

namespace artu::sim {

namespace {

using hw::NodeReference;

/// Lays the nodes down depth first; returns the reference to `node`.  `stacked` entries lie on the stack above it.
std::uint32_t lay_out(const BinaryNode& node, bool dynamic, std::uint32_t stacked, Tree& tree) {
  tree.stack = std::max(tree.stack, stacked);
  if (node.is_leaf()) return lay_out_leaf(node, dynamic, tree);
  const std::size_t at = tree.nodes.size();
  tree.nodes.resize(at + sizeof(hw::NodeRecord));
  hw::NodeRecord record{};
  for (int i = 0; i < 2; ++i) {
    record.lo[i] = node.bounds[i].lo;
    record.hi[i] = node.bounds[i].hi;
    record.child[i] = lay_out(*node.child[i], dynamic, stacked + 1, tree);
  }
  std::memcpy(tree.nodes.data() + at, &record, sizeof record);
  return NodeReference::inner(static_cast<std::uint32_t>(at / sizeof record), dynamic);
}

}  // namespace

std::uint32_t lay_out_leaf(const BinaryNode& leaf, bool dynamic, Tree& tree) {
  const auto first = static_cast<std::uint32_t>(tree.order.size());
  tree.order.insert(tree.order.end(), leaf.triangle, leaf.triangle + leaf.count);
  return NodeReference::leaf(first, leaf.count, dynamic);
}

void lay_out_bvh2(const BinaryTree& binary, bool dynamic, Tree& tree) {
  tree.root = lay_out(binary.root(), dynamic, 0, tree);
}

}  // namespace artu::sim
