#include "sim/driver/tree.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "traces/error.h"

namespace artu::sim {

namespace {

using hw::NodeReference;
using hw::Vector;

struct Box {
  Vector lo, hi;
};

/// What Embree's callbacks make: an inner node with two children, or a leaf with its triangles.
struct BuildNode {
  Box bounds[2];
  BuildNode* child[2] = {nullptr, nullptr};
  std::uint32_t count = 0;  // leaf
  std::uint32_t triangle[leaf_size] = {};
};

struct Handles {
  RTCDevice device = nullptr;
  RTCBVH bvh = nullptr;
  ~Handles() {
    if (bvh != nullptr) rtcReleaseBVH(bvh);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

void* create_node(RTCThreadLocalAllocator allocator, unsigned, void*) {
  return new (rtcThreadLocalAlloc(allocator, sizeof(BuildNode), alignof(BuildNode))) BuildNode;
}

void set_children(void* node, void** children, unsigned count, void*) {
  for (unsigned i = 0; i < count; ++i) static_cast<BuildNode*>(node)->child[i] = static_cast<BuildNode*>(children[i]);
}

void set_bounds(void* node, const RTCBounds** bounds, unsigned count, void*) {
  for (unsigned i = 0; i < count; ++i) {
    const RTCBounds& b = *bounds[i];
    static_cast<BuildNode*>(node)->bounds[i] = {{b.lower_x, b.lower_y, b.lower_z}, {b.upper_x, b.upper_y, b.upper_z}};
  }
}

void* create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, size_t count, void*) {
  auto* leaf = new (rtcThreadLocalAlloc(allocator, sizeof(BuildNode), alignof(BuildNode))) BuildNode;
  leaf->count = static_cast<std::uint32_t>(count);
  for (size_t i = 0; i < count; ++i) leaf->triangle[i] = primitives[i].primID;
  // Embree may have partitioned in any order: the leaf's own order is by id.
  std::sort(leaf->triangle, leaf->triangle + count);
  return leaf;
}

Vector to_vector(traces::Vec3 v) { return {v.x, v.y, v.z}; }

void grow(Box& box, Vector p) {
  box.lo = {std::min(box.lo.x, p.x), std::min(box.lo.y, p.y), std::min(box.lo.z, p.z)};
  box.hi = {std::max(box.hi.x, p.x), std::max(box.hi.y, p.y), std::max(box.hi.z, p.z)};
}

RTCBuildPrimitive primitive(const Box& box, std::uint32_t id) {
  return {box.lo.x, box.lo.y, box.lo.z, 0, box.hi.x, box.hi.y, box.hi.z, id};
}

/// Lays the nodes down depth first; returns the reference to `node`.
std::uint32_t flatten(const BuildNode& node, bool dynamic, std::uint32_t depth, Tree& tree) {
  if (node.count != 0) {
    const auto first = static_cast<std::uint32_t>(tree.order.size());
    tree.order.insert(tree.order.end(), node.triangle, node.triangle + node.count);
    return NodeReference::leaf(first, node.count, dynamic);
  }
  tree.depth = std::max(tree.depth, depth + 1);
  const auto index = static_cast<std::uint32_t>(tree.nodes.size());
  tree.nodes.emplace_back();
  hw::NodeRecord record{};
  for (int i = 0; i < 2; ++i) {
    record.lo[i] = node.bounds[i].lo;
    record.hi[i] = node.bounds[i].hi;
    record.child[i] = flatten(*node.child[i], dynamic, depth + 1, tree);
  }
  tree.nodes[index] = record;
  return NodeReference::inner(index, dynamic);
}

}  // namespace

Tree build_tree(const traces::Mesh& mesh, bool dynamic, const std::string& where) {
  Tree tree;
  const std::size_t count = mesh.triangle_count();
  if (count == 0) return tree;
  if (count > NodeReference::maximum_triangles) {
    throw InputError(where, std::to_string(count) + " triangles; the unit can address " +
                                std::to_string(NodeReference::maximum_triangles) + " of a class");
  }
  std::vector<RTCBuildPrimitive> primitives;
  primitives.reserve(count);
  Box all{};
  for (std::size_t i = 0; i < count; ++i) {
    const Vector a = to_vector(mesh.positions[mesh.indices[3 * i]]);
    Box box{a, a};
    grow(box, to_vector(mesh.positions[mesh.indices[3 * i + 1]]));
    grow(box, to_vector(mesh.positions[mesh.indices[3 * i + 2]]));
    if (i == 0) all = box;
    grow(all, box.lo);
    grow(all, box.hi);
    primitives.push_back(primitive(box, static_cast<std::uint32_t>(i)));
  }
  tree.lo = all.lo;
  tree.hi = all.hi;

  Handles handles;
  // The lowest instruction set and one thread: no machine-dependent choices.
  handles.device = rtcNewDevice("threads=1,isa=sse2");
  if (handles.device == nullptr) throw std::runtime_error("Embree: no device for the tree builder");
  handles.bvh = rtcNewBVH(handles.device);
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
  arguments.maxBranchingFactor = 2;
  arguments.maxDepth = 1024;
  arguments.sahBlockSize = 1;
  arguments.minLeafSize = 1;
  arguments.maxLeafSize = leaf_size;
  arguments.bvh = handles.bvh;
  arguments.primitives = primitives.data();
  arguments.primitiveCount = primitives.size();
  arguments.primitiveArrayCapacity = primitives.size();
  arguments.createNode = create_node;
  arguments.setNodeChildren = set_children;
  arguments.setNodeBounds = set_bounds;
  arguments.createLeaf = create_leaf;
  const auto* root = static_cast<const BuildNode*>(rtcBuildBVH(&arguments));
  if (root == nullptr) throw std::runtime_error("Embree: the tree builder failed");
  tree.order.reserve(count);
  tree.root = flatten(*root, dynamic, 0, tree);
  return tree;
}

}  // namespace artu::sim
