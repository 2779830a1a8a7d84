// Boxes of triangles, for the tree builders.
#pragma once

#include <algorithm>
#include <vector>

#include "hw/datapath/vector.h"
#include "traces/frame.h"

namespace artu::sim {

struct Box {
  hw::Vector lo, hi;
};

inline void grow(Box& box, const Box& other) {
  box.lo = {std::min(box.lo.x, other.lo.x), std::min(box.lo.y, other.lo.y), std::min(box.lo.z, other.lo.z)};
  box.hi = {std::max(box.hi.x, other.hi.x), std::max(box.hi.y, other.hi.y), std::max(box.hi.z, other.hi.z)};
}

/// Half the surface.  In binary64, where no coordinate that a trace may have overflows or vanishes.
inline double half_area(const Box& box) {
  const double x = double{box.hi.x} - box.lo.x, y = double{box.hi.y} - box.lo.y, z = double{box.hi.z} - box.lo.z;
  return x * y + y * z + z * x;
}

inline Box triangle_box(const traces::Mesh& mesh, std::size_t triangle) {
  const auto vertex = [&](std::size_t i) {
    const traces::Vec3 v = mesh.positions[mesh.indices[3 * triangle + i]];
    return Box{{v.x, v.y, v.z}, {v.x, v.y, v.z}};
  };
  Box box = vertex(0);
  grow(box, vertex(1));
  grow(box, vertex(2));
  return box;
}

inline std::vector<Box> triangle_boxes(const traces::Mesh& mesh) {
  std::vector<Box> boxes;
  boxes.reserve(mesh.triangle_count());
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) boxes.push_back(triangle_box(mesh, i));
  return boxes;
}

}  // namespace artu::sim
