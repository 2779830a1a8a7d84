#include "sim/driver/tree_sah.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace artu::sim {

namespace {

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
  auto* run = static_cast<std::uint32_t*>(
      rtcThreadLocalAlloc(allocator, count * sizeof(std::uint32_t), alignof(std::uint32_t)));
  for (size_t i = 0; i < count; ++i) run[i] = primitives[i].primID;
  // Embree may have partitioned in any order: the leaf's own order is by id.
  std::sort(run, run + count);
  leaf->triangle = run;
  leaf->count = static_cast<std::uint32_t>(count);
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

/// Halves a run of `made.ids`.
BinaryNode* halve_run(const std::vector<Box>& boxes, std::uint32_t leaf_size, const BinaryNodes& made,
                      std::size_t first, std::size_t count) {
  if (count <= leaf_size) return made.leaf(first, count);
  std::uint32_t* ids = made.ids.data() + first;
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
  BinaryNode* below = halve_run(boxes, leaf_size, made, first, half);
  return made.inner(below, halve_run(boxes, leaf_size, made, first + half, count - half));
}

}  // namespace

BinaryNode* build_sah(RTCBVH bvh, const std::vector<Box>& boxes, std::uint32_t leaf_size) {
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

BinaryNode* halve(const std::vector<Box>& boxes, std::uint32_t leaf_size, const BinaryNodes& made) {
  return halve_run(boxes, leaf_size, made, 0, made.ids.size());
}

}  // namespace artu::sim
