// Where a kd-tree's cell is divided: the plane with the least expected cost (surface-area heuristic) over the
// triangles' boxes.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/driver/tree_box.h"

namespace artu::sim {

struct KdSplit {
  double cost = 0;
  int axis = -1;  // -1: none
  float at = 0;
};

class KdSplitter {
 public:
  KdSplitter(const std::vector<Box>& boxes, const Box& all, std::uint32_t leaf_size);

  /// The best split of the cell among those that cost less than leaves of its triangles and make no more than `budget`
  /// references, if there is one.  A plane lies strictly inside the cell.
  KdSplit best(const std::vector<std::uint32_t>& ids, const Box& cell, std::uint64_t budget);

 private:
  /// One axis of a cell.  The chance that a ray meets a slab of the cell is proportional to face + girth * thickness:
  /// half its surface, and a little of its extents, so that flat and linear cells differ.
  struct Axis {
    int axis;
    float lo, hi;
    double girth, face, whole;
    std::uint64_t budget;
  };

  double leaf_cost(std::size_t count) const;
  void consider(const Axis& on, float at, std::size_t below, std::size_t above);
  void sweep(const Axis& on, const std::vector<std::uint32_t>& ids);
  void bin(const Axis& on, const std::vector<std::uint32_t>& ids);

  const std::vector<Box>& boxes_;
  const std::uint32_t leaf_size_;
  double flat_;
  KdSplit best_;
  std::vector<float> los_, his_;  // of sweep
};

}  // namespace artu::sim
