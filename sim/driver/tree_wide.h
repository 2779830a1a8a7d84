// BVHs with four or eight children a node: the binary tree, collapsed, with boxes in 8-bit steps.
#pragma once

#include "sim/driver/tree_bvh2.h"

namespace artu::sim {

/// Fills root, nodes, order and stack; `Width` is 4 or 8.
template <int Width>
void lay_out_wide(const BinaryTree& binary, bool dynamic, Tree& tree);

/// Fills the node's origin, exponents and planes for `count` boxes: the decoded ones contain them.
template <int Width>
void quantise(const Box* boxes, int count, hw::WideNodeRecord<Width>& node);

}  // namespace artu::sim
