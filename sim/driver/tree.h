// The tree over one class of geometry, in the unit's format (hw/memory/layout.h, docs/trees.md).
//
// Which tree it is cannot change a pixel (docs/arithmetic.md section 4), only cycles.  The same triangles give the same
// tree on any machine: binary BVHs are built by Embree's rtcBuildBVH (binned SAH) with one thread, wide ones are
// collapsed from those, kd-trees are built here.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hw/memory/layout.h"
#include "traces/frame.h"

namespace artu::sim {

struct Tree {
  hw::TreeKind kind = hw::TreeKind::bvh2;
  std::uint32_t root = hw::NodeReference::none;
  hw::Vector lo, hi;                 // root box
  std::vector<std::uint8_t> nodes;   // records of hw::node_bytes(kind) each, depth first, node 0 is the root
  std::vector<std::uint32_t> order;  // for each triangle record, in the order of the leaves' runs: its triangle of the
                                     // mesh; each triangle once, in a kd-tree at least once
  std::uint32_t stack = 0;           // entries that a traversal needs at most, the other tree's root not included
};

/// Largest leaf that is aimed at, in triangles.
inline constexpr std::uint32_t leaf_size = 4;

/// Throws InputError if the mesh has more triangles than the format can address.
Tree build_tree(const traces::Mesh& mesh, hw::TreeKind kind, bool dynamic, const std::string& where);

}  // namespace artu::sim
