// The triangles of a stress case: both classes, and a flat view of them by global id.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hw/datapath/vector.h"
#include "traces/frame.h"

namespace artu::sim {

using Corners = std::array<hw::Vector, 3>;

struct StressGeometry {
  traces::Mesh fixed, dynamic;
  bool closed = false;  // every edge has two triangles: no ray may leave
  bool convex = false;  // and no ray that leaves the surface outwards may hit it again

  std::size_t triangle_count() const { return fixed.triangle_count() + dynamic.triangle_count(); }
};

void add_vertex(traces::Mesh& mesh, hw::Vector position);
/// A triangle with vertices of its own.
void add_triangle(traces::Mesh& mesh, hw::Vector a, hw::Vector b, hw::Vector c);

/// All triangles by global id: static, then dynamic.
std::vector<Corners> corners_of(const StressGeometry& geometry);

/// Whether every edge belongs to exactly two triangles, of both classes together; vertices are told by their place.
bool is_closed(const StressGeometry& geometry);

/// How often the surface goes round a point: 1 or -1 inside, 0 outside, in between on it.
double winding_number(const std::vector<Corners>& triangles, hw::Vector point);

struct Bounds {
  hw::Vector lo, hi, center;
  float size = 1;  // the largest side; 1 where there is none
};
Bounds bounds_of(const std::vector<Corners>& triangles);

}  // namespace artu::sim
