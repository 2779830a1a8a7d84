// Binary trees by the surface-area heuristic: Embree's builder, and what takes its place where it gives up.
#pragma once

#include "sim/driver/tree_binary.h"

namespace artu::sim {

/// Bounds and heights are not set.  Null if the tree would be too deep.  `bvh` owns the nodes.
BinaryNode* build_sah(RTCBVHTy* bvh, const std::vector<Box>& boxes, std::uint32_t leaf_size);

/// Halves the triangles by the widest axis of their centres: never deeper than the logarithm of their number.
BinaryNode* halve(const std::vector<Box>& boxes, std::uint32_t leaf_size, const BinaryNodes& made);

}  // namespace artu::sim
