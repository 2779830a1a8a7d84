// The binary tree from which the BVHs of all widths are made.
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
  const std::uint32_t* triangle = nullptr;  // of a leaf
  std::uint32_t count = 0;                  // of them; 0: inner
  std::uint32_t height = 0;                 // inner nodes on the longest path down, this one included
  bool is_leaf() const { return count != 0; }
};

class BinaryTree {
 public:
  /// At least one box.
  BinaryTree(const std::vector<Box>& boxes, const TreeRecipe& recipe);
  ~BinaryTree();
  BinaryTree(const BinaryTree&) = delete;
  BinaryTree& operator=(const BinaryTree&) = delete;

  const BinaryNode& root() const { return *root_; }

 private:
  RTCDeviceTy* device_ = nullptr;
  RTCBVHTy* bvh_ = nullptr;         // owns the nodes that Embree's builder makes
  std::deque<BinaryNode> nodes_;    // those that are made here
  std::vector<std::uint32_t> ids_;  // their leaves' triangles
  BinaryNode* root_ = nullptr;
};

/// Where nodes are made that are not Embree's: `ids` holds every triangle once, a leaf a run of it.
struct BinaryNodes {
  std::deque<BinaryNode>& nodes;
  std::vector<std::uint32_t>& ids;

  /// A leaf of the triangles first ... first + count - 1 of `ids`, which it sorts.
  BinaryNode* leaf(std::size_t first, std::size_t count) const;
  BinaryNode* inner(BinaryNode* a, BinaryNode* b) const;
};

/// What it takes to split the triangles into this tree from the top, if `on_chip` of them fit on chip.
hw::BuildWork work_of(const BinaryNode& root, std::uint32_t on_chip);

}  // namespace artu::sim
