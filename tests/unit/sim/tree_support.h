// Meshes and checks for the tests of the tree builders.
#pragma once

#include <cmath>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "hw/datapath/walk.h"
#include "sim/driver/tree.h"

namespace artu::sim::test {

inline constexpr hw::TreeKind kinds[] = {hw::TreeKind::bvh2, hw::TreeKind::bvh4, hw::TreeKind::bvh8, hw::TreeKind::kd};

inline std::string name(hw::TreeKind kind) {
  const char* names[] = {"bvh2", "bvh4", "bvh8", "kd"};
  return names[static_cast<std::size_t>(kind)];
}

/// The same numbers with every standard library.
class Random {
 public:
  explicit Random(std::uint32_t seed) : generator_(seed) {}
  std::uint32_t below(std::size_t n) { return static_cast<std::uint32_t>(generator_() % n); }
  bool one_in(std::uint32_t n) { return below(n) == 0; }
  float in(float a, float b) { return a + (b - a) * (static_cast<float>(generator_() >> 8) * 0x1p-24f); }
  hw::Vector in_cube(float side) { return {in(-side, side), in(-side, side), in(-side, side)}; }

 private:
  std::mt19937 generator_;
};

inline void add(traces::Mesh& mesh, hw::Vector a, hw::Vector b, hw::Vector c) {
  for (const hw::Vector v : {a, b, c}) {
    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.push_back({v.x, v.y, v.z});
  }
  mesh.materials.push_back(0);
}

inline hw::Vector vertex(const traces::Mesh& mesh, std::size_t triangle, std::size_t i) {
  const traces::Vec3 v = mesh.positions[mesh.indices[3 * triangle + i]];
  return {v.x, v.y, v.z};
}

inline traces::Mesh soup(int count, float size, std::uint32_t seed = 1) {
  Random random(seed);
  traces::Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const hw::Vector at = random.in_cube(1);
    add(mesh, at + random.in_cube(size), at + random.in_cube(size), at + random.in_cube(size));
  }
  return mesh;
}

/// A million times longer than wide.
inline traces::Mesh slivers(int count) {
  Random random(2);
  traces::Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const hw::Vector a = random.in_cube(1), b = a + random.in_cube(0.5f);
    add(mesh, a, b, (a + b) * 0.5f + random.in_cube(1e-6f));
  }
  return mesh;
}

inline traces::Mesh sphere(int columns, int rows) {
  traces::Mesh mesh;
  const auto point = [&](int column, int row) {
    const double longitude = 2 * M_PI * (column % columns) / columns, latitude = M_PI * row / rows;
    return hw::Vector{static_cast<float>(std::sin(latitude) * std::cos(longitude)),
                      static_cast<float>(std::cos(latitude)),
                      static_cast<float>(std::sin(latitude) * std::sin(longitude))};
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const hw::Vector a = point(column, row), b = point(column + 1, row), c = point(column, row + 1),
                       d = point(column + 1, row + 1);
      if (row > 0) add(mesh, a, b, c);
      if (row + 1 < rows) add(mesh, b, d, c);
    }
  }
  return mesh;
}

/// Vertices on a grid, so that edges lie in planes across the whole mesh; some of it is flat.
inline traces::Mesh heights(int side) {
  Random random(3);
  std::vector<float> height;
  for (int i = 0; i <= side * (side + 2); ++i) height.push_back(random.one_in(3) ? 0.0f : random.in(0, 0.2f));
  traces::Mesh mesh;
  const auto point = [&](int x, int z) {
    const float scale = 2.0f / static_cast<float>(side);
    return hw::Vector{static_cast<float>(x) * scale - 1, height[static_cast<std::size_t>(z) * (side + 1) + x],
                      static_cast<float>(z) * scale - 1};
  };
  for (int z = 0; z < side; ++z) {
    for (int x = 0; x < side; ++x) {
      add(mesh, point(x, z), point(x + 1, z), point(x, z + 1));
      add(mesh, point(x + 1, z), point(x + 1, z + 1), point(x, z + 1));
    }
  }
  return mesh;
}

/// Every triangle `copies` times; axis-aligned walls among them.
inline traces::Mesh coincident(int count, int copies) {
  Random random(4);
  traces::Mesh mesh;
  for (int i = 0; i < count; ++i) {
    hw::Vector v[3] = {random.in_cube(1), random.in_cube(1), random.in_cube(1)};
    const float wall = static_cast<float>(random.below(5)) * 0.5f - 1;
    for (hw::Vector& each : v) {
      if (i % 4 == 0) each.x = wall;
      if (i % 4 == 1) each.y = wall;
      if (i % 4 == 2) each.z = wall;
    }
    for (int copy = 0; copy < copies; ++copy) add(mesh, v[copy % 3], v[(copy + 1) % 3], v[(copy + 2) % 3]);
  }
  return mesh;
}

/// Triangles of all sizes that a trace may have, around the origin and elsewhere.
inline traces::Mesh all_sizes(int count) {
  Random random(5);
  traces::Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const float size = std::ldexp(1.0f, 60 - i % 205), away = std::ldexp(1.0f, 60 - i % 23);
    const hw::Vector at = i % 2 == 0 ? hw::Vector{} : random.in_cube(away);
    add(mesh, at + random.in_cube(size), at + random.in_cube(size), at + random.in_cube(size));
  }
  return mesh;
}

inline traces::Mesh transformed(traces::Mesh mesh, float scale, float move) {
  for (traces::Vec3& v : mesh.positions) v = {v.x * scale + move, v.y * scale + move, v.z * scale + move};
  return mesh;
}

/// Puts a tree and its triangles into memory as a frame's geometry of its class; ids count from `first_id`.
inline void place(const traces::Mesh& mesh, const Tree& tree, bool dynamic, std::uint32_t first_id,
                  hw::MemoryImage& image, hw::FrameDescriptor& frame) {
  const hw::Address nodes = image.allocate(tree.nodes.size());
  if (!tree.nodes.empty()) std::memcpy(&image.at<std::uint8_t>(nodes), tree.nodes.data(), tree.nodes.size());
  const hw::Address triangles = image.allocate(tree.order.size() * sizeof(hw::TriangleRecord));
  for (std::size_t i = 0; i < tree.order.size(); ++i) {
    auto& record = image.at<hw::TriangleRecord>(triangles + i * sizeof(hw::TriangleRecord));
    record.a = vertex(mesh, tree.order[i], 0);
    record.b = vertex(mesh, tree.order[i], 1);
    record.c = vertex(mesh, tree.order[i], 2);
    record.primitive = first_id + tree.order[i];
    record.attributes = tree.order[i];
  }
  (dynamic ? frame.dynamic_kind : frame.static_kind) = tree.kind;
  (dynamic ? frame.dynamic_root : frame.static_root) = tree.root;
  (dynamic ? frame.dynamic_lo : frame.static_lo) = tree.lo;
  (dynamic ? frame.dynamic_hi : frame.static_hi) = tree.hi;
  (dynamic ? frame.dynamic_nodes : frame.static_nodes) = nodes;
  (dynamic ? frame.dynamic_triangles : frame.static_triangles) = triangles;
}

}  // namespace artu::sim::test
