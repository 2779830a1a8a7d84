#include "sim/driver/tree_bvh2.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <stdexcept>

namespace artu::sim {

namespace {

using hw::NodeReference;

// Depth at which splitting by cost ends: the last levels are halved without a look.  The builder fails if too many
// triangles are left there, as where their sizes span many powers of two.
constexpr unsigned maximum_depth = 60;

void* create_node(RTCThreadLocalAllocator allocator, unsigned, void*) {
  return new (rtcThreadLocalAlloc(allocator, sizeof(BinaryNode), alignof(BinaryNode))) BinaryNode;
}

void set_children(void* node, void** children, unsigned count, void*) {
  for (unsigned i = 0; i < count; ++i) static_cast<BinaryNode*>(node)->child[i] = static_cast<BinaryNode*>(children[i]);
}

/// Bounds are computed afterwards, from boxes that were not scaled.
void set_bounds(void*, const RTCBounds**, unsigned, void*) {}

void* create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, size_t count, void*) {
  auto* leaf = new (rtcThreadLocalAlloc(allocator, sizeof(BinaryNode), alignof(BinaryNode))) BinaryNode;
  leaf->count = static_cast<std::uint32_t>(count);
  for (size_t i = 0; i < count; ++i) leaf->triangle[i] = primitives[i].primID;
  // Embree may have partitioned in any order: the leaf's own order is by id.
  std::sort(leaf->triangle, leaf->triangle + count);
  return leaf;
}

/// Power of two that brings very large or small coordinates to where surfaces are numbers in the builder's binary32.
float scale_for(const std::vector<Box>& boxes) {
  float largest = 0;
  for (const Box& box : boxes) {
    for (int axis = 0; axis < 3; ++axis) {
      largest = std::max({largest, std::fabs(box.lo[axis]), std::fabs(box.hi[axis])});
    }
  }
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;
  return std::abs(exponent) <= 40 ? 1.0f : std::ldexp(1.0f, std::clamp(-exponent, -126, 126));
}

/// Null if the tree would be too deep.
BinaryNode* build(RTCBVH bvh, const std::vector<Box>& boxes) {
  const float scale = scale_for(boxes);
  std::vector<RTCBuildPrimitive> primitives;
  primitives.reserve(boxes.size());
  for (const Box& box : boxes) {
    const hw::Vector lo = box.lo * scale, hi = box.hi * scale;
    primitives.push_back({lo.x, lo.y, lo.z, 0, hi.x, hi.y, hi.z, static_cast<std::uint32_t>(primitives.size())});
  }
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
  arguments.maxBranchingFactor = 2;
  arguments.maxDepth = maximum_depth;
  arguments.sahBlockSize = 1;
  arguments.minLeafSize = 1;
  arguments.maxLeafSize = leaf_size;
  arguments.bvh = bvh;
  arguments.primitives = primitives.data();
  arguments.primitiveCount = primitives.size();
  arguments.primitiveArrayCapacity = primitives.size();
  arguments.createNode = create_node;
  arguments.setNodeChildren = set_children;
  arguments.setNodeBounds = set_bounds;
  arguments.createLeaf = create_leaf;
  return static_cast<BinaryNode*>(rtcBuildBVH(&arguments));
}

/// Halves the triangles by the widest axis of their centres: never deeper than the logarithm of their number.
BinaryNode* halve(std::deque<BinaryNode>& nodes, const std::vector<Box>& boxes, std::uint32_t* ids, std::size_t count) {
  BinaryNode& node = nodes.emplace_back();
  if (count <= leaf_size) {
    node.count = static_cast<std::uint32_t>(count);
    std::copy(ids, ids + count, node.triangle);
    std::sort(node.triangle, node.triangle + count);
    return &node;
  }
  const auto centre = [&](std::uint32_t id) { return boxes[id].lo * 0.5f + boxes[id].hi * 0.5f; };
  Box all{centre(ids[0]), centre(ids[0])};
  for (std::size_t i = 1; i < count; ++i) grow(all, {centre(ids[i]), centre(ids[i])});
  const hw::Vector extent = all.hi - all.lo;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const std::size_t half = count / 2;
  std::nth_element(ids, ids + half, ids + count, [&](std::uint32_t a, std::uint32_t b) {
    const float at = centre(a)[axis], bt = centre(b)[axis];
    return at != bt ? at < bt : a < b;
  });
  node.child[0] = halve(nodes, boxes, ids, half);
  node.child[1] = halve(nodes, boxes, ids + half, count - half);
  return &node;
}

/// Sets the bounds and heights of all nodes; returns the node's own box.
Box finish(BinaryNode& node, const std::vector<Box>& boxes) {
  if (node.is_leaf()) {
    Box box = boxes[node.triangle[0]];
    for (std::uint32_t i = 1; i < node.count; ++i) grow(box, boxes[node.triangle[i]]);
    return box;
  }
  for (int i = 0; i < 2; ++i) node.bounds[i] = finish(*node.child[i], boxes);
  node.height = 1 + std::max(node.child[0]->height, node.child[1]->height);
  Box box = node.bounds[0];
  grow(box, node.bounds[1]);
  return box;
}

/// Lays the nodes down depth first; returns the reference to `node`.  `stacked` entries lie on the stack above it.
std::uint32_t lay_out(const BinaryNode& node, bool dynamic, std::uint32_t stacked, Tree& tree) {
  tree.stack = std::max(tree.stack, stacked);
  if (node.is_leaf()) return lay_out_leaf(node, dynamic, tree);
  const std::size_t at = tree.nodes.size();
  tree.nodes.resize(at + sizeof(hw::NodeRecord));
  hw::NodeRecord record{};
  for (int i = 0; i < 2; ++i) {
    record.lo[i] = node.bounds[i].lo;
    record.hi[i] = node.bounds[i].hi;
    record.child[i] = lay_out(*node.child[i], dynamic, stacked + 1, tree);
  }
  std::memcpy(tree.nodes.data() + at, &record, sizeof record);
  return NodeReference::inner(static_cast<std::uint32_t>(at / sizeof record), dynamic);
}

}  // namespace

BinaryTree::BinaryTree(const std::vector<Box>& boxes) {
  // The lowest instruction set and one thread: no machine-dependent choices.
  device_ = rtcNewDevice("threads=1,isa=sse2");
  if (device_ == nullptr) throw std::runtime_error("Embree: no device for the tree builder");
  bvh_ = rtcNewBVH(device_);
  root_ = build(bvh_, boxes);
  if (root_ == nullptr) {
    std::vector<std::uint32_t> ids(boxes.size());
    std::iota(ids.begin(), ids.end(), 0);
    root_ = halve(halved_, boxes, ids.data(), ids.size());
  }
  finish(*root_, boxes);
}

BinaryTree::~BinaryTree() {
  rtcReleaseBVH(bvh_);
  rtcReleaseDevice(device_);
}

std::uint32_t lay_out_leaf(const BinaryNode& leaf, bool dynamic, Tree& tree) {
  const auto first = static_cast<std::uint32_t>(tree.order.size());
  tree.order.insert(tree.order.end(), leaf.triangle, leaf.triangle + leaf.count);
  return NodeReference::leaf(first, leaf.count, dynamic);
}

void lay_out_bvh2(const BinaryTree& binary, bool dynamic, Tree& tree) {
  tree.root = lay_out(binary.root(), dynamic, 0, tree);
}

}  // namespace artu::sim
