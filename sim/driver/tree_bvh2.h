// Binary BVHs: what Embree's builder makes, and its layout as NodeRecords.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "sim/driver/tree.h"
#include "sim/driver/tree_box.h"

struct RTCDeviceTy;
struct RTCBVHTy;

namespace artu::sim {

/// An inner node with two children, or a leaf with its triangles, by rising id.
struct BinaryNode {
  Box bounds[2];  // of the children
  BinaryNode* child[2] = {nullptr, nullptr};
  std::uint32_t count = 0;  // of a leaf; 0: inner
  std::uint32_t triangle[leaf_size] = {};
  std::uint32_t height = 0;  // inner nodes on the longest path down, this one included
  bool is_leaf() const { return count != 0; }
};

/// The binary tree from which the BVHs of all widths are made.
class BinaryTree {
 public:
  /// At least one box.
  explicit BinaryTree(const std::vector<Box>& boxes);
  ~BinaryTree();
  BinaryTree(const BinaryTree&) = delete;
  BinaryTree& operator=(const BinaryTree&) = delete;

  const BinaryNode& root() const { return *root_; }

 private:
  RTCDeviceTy* device_ = nullptr;
  RTCBVHTy* bvh_ = nullptr;        // owns the nodes that Embree's builder makes
  std::deque<BinaryNode> halved_;  // the nodes, if Embree's builder would not
  BinaryNode* root_ = nullptr;
};

/// Appends the leaf's run to the order; returns the reference to it.
std::uint32_t lay_out_leaf(const BinaryNode& leaf, bool dynamic, Tree& tree);

/// Fills root, nodes, order and stack.
void lay_out_bvh2(const BinaryTree& binary, bool dynamic, Tree& tree);

}  // namespace artu::sim
