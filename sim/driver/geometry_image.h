// The triangles of a class and their tree, laid down in the unit's memory.
#pragma once

#include "hw/memory/image.h"
#include "sim/driver/tree.h"
#include "traces/frame.h"

namespace artu::sim {

/// Where a class lies, and what the frame descriptor says of it.
struct LaidGeometry {
  hw::TreeKind kind = hw::TreeKind::bvh2;
  std::uint32_t root = hw::NodeReference::none;
  hw::Vector lo, hi;
  hw::Address nodes = 0, triangles = 0, attributes = 0;
  std::uint32_t node_lines = 0;
  std::uint32_t references = 0;  // triangle records: more than triangles in a kd-tree
  std::uint32_t stack = 0;       // entries that a traversal needs at most
};

/// Lays the mesh and its tree down at the image's end.  Triangles have the global ids from `first_id` on.
LaidGeometry lay_geometry(const traces::Mesh& mesh, const Tree& tree, std::uint32_t first_id, hw::MemoryImage& image);

/// Fills in what a frame's descriptor has of both classes' trees, triangles and attributes.
void describe(const LaidGeometry& fixed, const LaidGeometry& dynamic, hw::FrameDescriptor& frame);

}  // namespace artu::sim
