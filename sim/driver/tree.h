// Binary BVH of one class of geometry, in the unit's format.
//
// Built by Embree's rtcBuildBVH (binned SAH) with one thread, so that the same triangles give the same tree on any
// machine.  Which tree it is cannot change a pixel (docs/arithmetic.md section 4), only cycles.
#pragma once

#include <cstdint>
#include <vector>

#include "hw/memory/layout.h"
#include "traces/frame.h"

namespace artu::sim {

struct Tree {
  std::uint32_t root = hw::NodeReference::none;
  hw::Vector lo, hi;                   // root box
  std::vector<hw::NodeRecord> nodes;   // depth first, node 0 is the root unless the root is a leaf
  std::vector<std::uint32_t> order;    // triangle of the mesh at each place of the leaves' runs
  std::uint32_t depth = 0;             // inner nodes on the longest path
};

/// Largest leaf, in triangles.
inline constexpr std::uint32_t leaf_size = 4;

/// Throws InputError if the mesh has more triangles than the format can address.
Tree build_tree(const traces::Mesh& mesh, bool dynamic, const std::string& where);

}  // namespace artu::sim
