#include "sim/stress/geometry.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace artu::sim {
namespace {

using hw::Vector;

Vector vector(const traces::Vec3& v) { return {v.x, v.y, v.z}; }

void append(const traces::Mesh& mesh, std::vector<Corners>& out) {
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    out.push_back({vector(mesh.positions[mesh.indices[i]]), vector(mesh.positions[mesh.indices[i + 1]]),
                   vector(mesh.positions[mesh.indices[i + 2]])});
  }
}

using Place = std::tuple<float, float, float>;
Place place(Vector v) { return {v.x, v.y, v.z}; }

struct Double3 {
  double x, y, z;
};
Double3 between(Vector from, Vector to) {
  return {double(to.x) - double(from.x), double(to.y) - double(from.y), double(to.z) - double(from.z)};
}
double dot(const Double3& a, const Double3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

}  // namespace

void add_vertex(traces::Mesh& mesh, Vector position) {
  mesh.positions.push_back({position.x, position.y, position.z});
  mesh.normals.emplace_back();
  mesh.uvs.emplace_back();
  mesh.colors.push_back(0xffffffffu);
}

void add_triangle(traces::Mesh& mesh, Vector a, Vector b, Vector c) {
  for (const Vector v : {a, b, c}) {
    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    add_vertex(mesh, v);
  }
  mesh.materials.push_back(0);
}

std::vector<Corners> corners_of(const StressGeometry& geometry) {
  std::vector<Corners> out;
  out.reserve(geometry.triangle_count());
  append(geometry.fixed, out);
  append(geometry.dynamic, out);
  return out;
}

bool is_closed(const StressGeometry& geometry) {
  std::map<std::pair<Place, Place>, int> edges;
  for (const Corners& t : corners_of(geometry)) {
    for (int i = 0; i < 3; ++i) {
      const Place a = place(t[i]), b = place(t[(i + 1) % 3]);
      ++edges[std::minmax(a, b)];
    }
  }
  return !edges.empty() && std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 2; });
}

double winding_number(const std::vector<Corners>& triangles, Vector point) {
  // The sum of the solid angles (Van Oosterom and Strackee, 1983).
  double sum = 0;
  for (const Corners& t : triangles) {
    const Double3 a = between(point, t[0]), b = between(point, t[1]), c = between(point, t[2]);
    const double la = std::sqrt(dot(a, a)), lb = std::sqrt(dot(b, b)), lc = std::sqrt(dot(c, c));
    const double triple = a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
    sum += 2 * std::atan2(triple, la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return sum / 12.566370614359172;
}

Bounds bounds_of(const std::vector<Corners>& triangles) {
  Bounds bounds;
  if (triangles.empty()) return bounds;
  bounds.lo = bounds.hi = triangles[0][0];
  for (const Corners& t : triangles) {
    for (const Vector v : t) {
      bounds.lo = {std::min(bounds.lo.x, v.x), std::min(bounds.lo.y, v.y), std::min(bounds.lo.z, v.z)};
      bounds.hi = {std::max(bounds.hi.x, v.x), std::max(bounds.hi.y, v.y), std::max(bounds.hi.z, v.z)};
    }
  }
  bounds.center = bounds.lo * 0.5f + bounds.hi * 0.5f;
  bounds.size = hw::largest(bounds.hi - bounds.lo);
  if (!(bounds.size > 0)) bounds.size = 1;
  return bounds;
}

}  // namespace artu::sim
