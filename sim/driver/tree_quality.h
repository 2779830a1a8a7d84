// How good a tree is: what a ray that meets its root box is expected to cost.
//
// By the surface-area heuristic such a ray meets a box inside with the chance surface / surface of the root's; in a
// kd-tree the boxes are the cells.  Boxes are those that the unit decodes.
#pragma once

#include "sim/driver/tree.h"

namespace artu::sim {

struct TreeQuality {
  std::uint64_t nodes = 0, leaves = 0, depth = 0;  // depth: inner nodes on the longest path down
  std::uint64_t references = 0;                    // triangles of the leaves
  double box_tests = 0, triangle_tests = 0;        // expected; of a kd-tree: planes
  double sah_cost() const;
};

/// Cost of a test, in box or plane tests.
inline constexpr double box_test_cost = 1, triangle_test_cost = 2;

TreeQuality quality_of(const Tree& tree);

}  // namespace artu::sim
