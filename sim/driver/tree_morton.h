// Binary trees from sorted Morton codes (LBVH): the radix tree of Karras, Maximizing Parallelism in the Construction of
// BVHs, Octrees, and k-d Trees (2012), with small subtrees made leaves.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/driver/tree_binary.h"

namespace artu::sim {

/// The bits of the three cells, x first, from the highest down; `bits` of each.
std::uint64_t interleave(std::uint32_t x, std::uint32_t y, std::uint32_t z, unsigned bits);

/// The code of each box's centre on a grid of 2^bits cells each way over `grid`.
std::vector<std::uint64_t> morton_codes(const std::vector<Box>& boxes, const Box& grid, unsigned bits);

/// The box of all centres.
Box centre_box(const std::vector<Box>& boxes);

/// Bounds and heights are not set.  Triangles of one code are in the order of their ids.
BinaryNode* build_morton(const std::vector<Box>& boxes, const TreeRecipe& recipe, const BinaryNodes& made);

}  // namespace artu::sim
