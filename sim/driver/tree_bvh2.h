// Binary BVHs: the layout of a binary tree as NodeRecords.
#pragma once

#include "sim/driver/tree_binary.h"

namespace artu::sim {

/// Appends the leaf's run to the order; returns the reference to it.
std::uint32_t lay_out_leaf(const BinaryNode& leaf, bool dynamic, Tree& tree);

/// Fills root, nodes, order and stack.
void lay_out_bvh2(const BinaryTree& binary, bool dynamic, Tree& tree);

}  // namespace artu::sim
