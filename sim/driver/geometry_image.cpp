#include "sim/driver/geometry_image.h"

#include <cstring>
#include <vector>

namespace artu::sim {

namespace {

hw::Vector vector(traces::Vec3 v) { return {v.x, v.y, v.z}; }

hw::TriangleRecord triangle_record(const traces::Mesh& mesh, std::size_t triangle, std::uint32_t id,
                                   std::uint32_t attributes) {
  const std::uint32_t* index = &mesh.indices[3 * triangle];
  hw::TriangleRecord record{};
  record.a = vector(mesh.positions[index[0]]);
  record.b = vector(mesh.positions[index[1]]);
  record.c = vector(mesh.positions[index[2]]);
  record.primitive = id;
  record.material = mesh.materials[triangle];
  record.attributes = attributes;
  for (int i = 0; i < 3; ++i) record.color[i] = mesh.colors[index[i]];
  return record;
}

hw::AttributeRecord attribute_record(const traces::Mesh& mesh, std::size_t triangle) {
  hw::AttributeRecord record{};
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t index = mesh.indices[3 * triangle + static_cast<std::size_t>(i)];
    record.normal[i] = vector(mesh.normals[index]);
    record.uv[i][0] = mesh.uvs[index].x;
    record.uv[i][1] = mesh.uvs[index].y;
  }
  return record;
}

}  // namespace

LaidGeometry lay_geometry(const traces::Mesh& mesh, const Tree& tree, std::uint32_t first_id, hw::MemoryImage& image) {
  LaidGeometry geometry;
  geometry.kind = tree.kind;
  geometry.root = tree.root;
  geometry.lo = tree.lo;
  geometry.hi = tree.hi;
  geometry.stack = tree.stack;
  geometry.nodes = image.allocate(tree.nodes.size());
  if (!tree.nodes.empty()) std::memcpy(&image.at<std::uint8_t>(geometry.nodes), tree.nodes.data(), tree.nodes.size());
  geometry.triangles = image.allocate(tree.order.size() * sizeof(hw::TriangleRecord));
  geometry.attributes = image.allocate(mesh.triangle_count() * sizeof(hw::AttributeRecord));
  // Attributes lie in the order in which the leaves first name their triangles: a BVH's have the same index as these.
  constexpr std::uint32_t unplaced = ~std::uint32_t{0};
  std::vector<std::uint32_t> place(mesh.triangle_count(), unplaced);
  std::uint32_t placed = 0;
  for (std::size_t i = 0; i < tree.order.size(); ++i) {
    const std::uint32_t triangle = tree.order[i];
    if (place[triangle] == unplaced) {
      place[triangle] = placed++;
      image.at<hw::AttributeRecord>(geometry.attributes + place[triangle] * sizeof(hw::AttributeRecord)) =
          attribute_record(mesh, triangle);
    }
    image.at<hw::TriangleRecord>(geometry.triangles + i * sizeof(hw::TriangleRecord)) =
        triangle_record(mesh, triangle, first_id + triangle, place[triangle]);
  }
  geometry.node_lines = static_cast<std::uint32_t>((tree.nodes.size() + 63) / 64);
  geometry.references = static_cast<std::uint32_t>(tree.order.size());
  return geometry;
}

void describe(const LaidGeometry& fixed, const LaidGeometry& dynamic, hw::FrameDescriptor& frame) {
  frame.static_kind = fixed.kind;
  frame.dynamic_kind = dynamic.kind;
  frame.static_root = fixed.root;
  frame.dynamic_root = dynamic.root;
  frame.static_lo = fixed.lo;
  frame.static_hi = fixed.hi;
  frame.dynamic_lo = dynamic.lo;
  frame.dynamic_hi = dynamic.hi;
  frame.static_nodes = fixed.nodes;
  frame.dynamic_nodes = dynamic.nodes;
  frame.static_triangles = fixed.triangles;
  frame.dynamic_triangles = dynamic.triangles;
  frame.static_attributes = fixed.attributes;
  frame.dynamic_attributes = dynamic.attributes;
}

}  // namespace artu::sim
