// A hand-made scene in memory and rays in contexts, for the blocks of a ray core.
//
// All rays go down the z axis from z = 10; all triangles are right ones in planes of constant z, over [0, 4] x [0, 4].
#pragma once

#include "hw/ray_core/pipelines.h"
#include "hw/ray_core/traversal.h"
#include "unit/hw/support.h"

namespace artu::hw::test {

struct CoreScene {
  explicit CoreScene(std::size_t context_count) : contexts(context_count) {
    FrameDescriptor& frame = registers.descriptor;
    frame.width = frame.height = 64;
    frame.static_root = frame.dynamic_root = NodeReference::none;
    frame.static_nodes = image.allocate(64 * sizeof(NodeRecord));
    frame.dynamic_nodes = image.allocate(64 * sizeof(NodeRecord));
    frame.static_triangles = image.allocate(64 * sizeof(TriangleRecord));
    frame.dynamic_triangles = image.allocate(64 * sizeof(TriangleRecord));
    frame.static_attributes = image.allocate(64 * sizeof(AttributeRecord));
    frame.dynamic_attributes = image.allocate(64 * sizeof(AttributeRecord));
    frame.materials = image.allocate(8 * sizeof(MaterialRecord));
  }

  /// Triangle `index` of a tree in the plane z, moved by x.
  void triangle(bool dynamic, std::uint32_t index, float z, std::uint32_t primitive, float x = 0) {
    const FrameDescriptor& frame = registers.descriptor;
    auto& record = image.at<TriangleRecord>((dynamic ? frame.dynamic_triangles : frame.static_triangles) + index * 64);
    record = {};
    record.a = {x, 0, z};
    record.b = {x + 4, 0, z};
    record.c = {x, 4, z};
    record.primitive = primitive;
    record.color[0] = record.color[1] = record.color[2] = 0xffffffffu;
    auto& attributes =
        image.at<AttributeRecord>((dynamic ? frame.dynamic_attributes : frame.static_attributes) + index * 64);
    for (Vector& normal : attributes.normal) normal = {0, 0, 1};
  }

  /// Node `index` with two children, each over [x, x + 4] x [0, 4] and a range of z.
  struct Child {
    std::uint32_t reference;
    float low_z, high_z;
    float x = 0;
  };
  void node(bool dynamic, std::uint32_t index, const Child& first, const Child& second) {
    const FrameDescriptor& frame = registers.descriptor;
    auto& record = image.at<NodeRecord>((dynamic ? frame.dynamic_nodes : frame.static_nodes) + index * 64);
    int i = 0;
    for (const Child& child : {first, second}) {
      record.child[i] = child.reference;
      record.lo[i] = {child.x, 0, child.low_z};
      record.hi[i] = {child.x + 4, 4, child.high_z};
      ++i;
    }
  }
  void root(bool dynamic, std::uint32_t reference, float low_x = -100, float high_x = 100) {
    FrameDescriptor& frame = registers.descriptor;
    (dynamic ? frame.dynamic_root : frame.static_root) = reference;
    (dynamic ? frame.dynamic_lo : frame.static_lo) = {low_x, -100, -100};
    (dynamic ? frame.dynamic_hi : frame.static_hi) = {high_x, 100, 9};
  }

  void ray(Slot slot, float x, float y, RayKind kind = RayKind::primary) {
    RayContext& context = contexts[slot];
    context = {};
    context.kind = kind;
    context.weight = {1, 1, 1};
    context.ray.origin = {x, y, 10};
    context.ray.direction = {0, 0, -1};
    set_up(context.ray);
  }

  MemoryImage image;
  FrameRegisters registers;
  RayContexts contexts;
  const Pipelines pipelines{OperatorConfig{}};
};

inline std::vector<Slot> slots(std::size_t count) {
  std::vector<Slot> result;
  for (std::size_t i = 0; i < count; ++i) result.push_back(static_cast<Slot>(i));
  return result;
}

}  // namespace artu::hw::test
