// Geometry in a pose, as world-space triangles.
#pragma once

#include "sim/import/pose.h"

namespace artu::sim {

/// Appends the triangles of one node.  Throws InputError(where, ...) where a vertex leaves the numbers.
void emit_node(const Model& model, const Pose& pose, int node, const std::string& where, traces::Mesh& out);

struct WorldBox {
  glm::dvec3 low{1e300}, high{-1e300};

  bool empty() const { return !(low.x <= high.x); }
  void add(const glm::dvec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  glm::dvec3 center() const { return 0.5 * (low + high); }
  double radius() const { return 0.5 * glm::length(high - low); }
};

void grow(WorldBox& box, const traces::Mesh& mesh);

}  // namespace artu::sim
