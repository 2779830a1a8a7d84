// The tree over one class of geometry, in the unit's format (hw/memory/layout.h, docs/trees.md).
//
// Which tree it is cannot change a pixel (docs/arithmetic.md section 4), only cycles.  The same triangles give the same
// tree on any machine.  Binary BVHs are built by Embree's rtcBuildBVH (binned SAH) with one thread, or here from sorted
// Morton codes; wide ones are collapsed from those; kd-trees are built here.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hw/memory/layout.h"
#include "traces/frame.h"

namespace artu::sim {

/// How a tree is built.
struct TreeRecipe {
  /// The rest as by default.
  TreeRecipe(hw::TreeKind kind) : kind(kind) {}
  /// Of the geometry that the unit's tree builder rebuilds.
  TreeRecipe(hw::TreeKind kind, std::uint32_t leaf_size, const hw::TreeBuilderConfig& builder)
      : kind(kind), leaf_size(leaf_size), builder(builder) {}

  hw::TreeKind kind;
  std::uint32_t leaf_size = hw::AccelConfig().leaf_size;  // triangles, at most
  hw::TreeBuilderConfig builder;                          // algorithm, codes; what is split on chip
};

struct Tree {
  hw::TreeKind kind = hw::TreeKind::bvh2;
  std::uint32_t root = hw::NodeReference::none;
  hw::Vector lo, hi;                 // root box
  std::vector<std::uint8_t> nodes;   // records of hw::node_bytes(kind) each, depth first, node 0 is the root
  std::vector<std::uint32_t> order;  // for each triangle record, in the order of the leaves' runs: its triangle of the
                                     // mesh; each triangle once, in a kd-tree at least once
  std::uint32_t stack = 0;           // entries that a traversal needs at most, the other tree's root not included
  hw::BuildWork work{};              // what it takes to build it from the top
};

/// Throws InputError if the mesh has more triangles than the format can address, std::invalid_argument for a kd-tree by
/// another algorithm than SAH.
Tree build_tree(const traces::Mesh& mesh, const TreeRecipe& recipe, bool dynamic, const std::string& where);

}  // namespace artu::sim
