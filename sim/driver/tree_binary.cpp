#include "sim/driver/tree_binary.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>

#include "sim/driver/tree_morton.h"
#include "sim/driver/tree_sah.h"

namespace artu::sim {

namespace {

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

/// Adds the node's splits to `work`; returns its triangles.  `level` counts from the root, which is 1.
std::uint32_t add_work(const BinaryNode& node, std::uint32_t on_chip, std::uint32_t level, hw::BuildWork& work) {
  if (node.is_leaf()) return node.count;
  const std::uint32_t count =
      add_work(*node.child[0], on_chip, level + 1, work) + add_work(*node.child[1], on_chip, level + 1, work);
  ++work.splits;
  work.references += count;
  if (count > on_chip) {
    ++work.upper_splits;
    work.upper_references += count;
    work.upper_levels = std::max(work.upper_levels, level);
  }
  return count;
}

[[noreturn]] void embree_failed(const char* what, RTCError error) {
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  throw std::runtime_error(std::string("Embree: ") + what + ", error " + std::to_string(error));
}

}  // namespace

BinaryNode* BinaryNodes::leaf(std::size_t first, std::size_t count) const {
  BinaryNode& node = nodes.emplace_back();
  std::uint32_t* run = ids.data() + first;
  std::sort(run, run + count);
  node.triangle = run;
  node.count = static_cast<std::uint32_t>(count);
  return &node;
}

BinaryNode* BinaryNodes::inner(BinaryNode* a, BinaryNode* b) const {
  BinaryNode& node = nodes.emplace_back();
  node.child[0] = a;
  node.child[1] = b;
  return &node;
}

hw::BuildWork work_of(const BinaryNode& root, std::uint32_t on_chip) {
  hw::BuildWork work{};
  work.lower_references = add_work(root, on_chip, 1, work);
  return work;
}

BinaryTree::BinaryTree(const std::vector<Box>& boxes, const TreeRecipe& recipe) {
  ids_.resize(boxes.size());
  std::iota(ids_.begin(), ids_.end(), 0);
  const BinaryNodes made{nodes_, ids_};
  if (recipe.builder.algorithm == hw::BuildAlgorithm::morton) {
    root_ = build_morton(boxes, recipe, made);
  } else {
    // The lowest instruction set and one thread: no machine-dependent choices.
    device_ = rtcNewDevice("threads=1,isa=sse2");
    if (device_ == nullptr) embree_failed("no device for the tree builder", rtcGetDeviceError(nullptr));
    bvh_ = rtcNewBVH(device_);
    root_ = build_sah(bvh_, boxes, recipe.leaf_size);
    // Halving is for what the builder cannot split, not another tree for who has less memory.
    if (root_ == nullptr && rtcGetDeviceError(device_) == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    if (root_ == nullptr) root_ = halve(boxes, recipe.leaf_size, made);
  }
  finish(*root_, boxes);
}

BinaryTree::~BinaryTree() {
  if (bvh_ != nullptr) rtcReleaseBVH(bvh_);
  if (device_ != nullptr) rtcReleaseDevice(device_);
}

}  // namespace artu::sim
