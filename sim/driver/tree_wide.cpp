#include "sim/driver/tree_wide.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "hw/datapath/node_visit.h"

namespace artu::sim {

namespace {

using hw::NodeReference;
using hw::WideNodeRecord;

constexpr int last_step = 255;
constexpr std::uint32_t usual_stack = 60;  // a tree that needs more is made again, with more care for its height

/// A child of the wide node in the making.
struct Child {
  const BinaryNode* node;
  Box box;
  int opened;  // binary nodes between the wide node and this one
};

/// Which child of a wide node is opened next.  By surface a ray visits the fewest nodes; by height the stack stays
/// small.
enum class Open { by_surface, by_height };

bool before(const Child& a, const Child& b, Open open) {
  if (open == Open::by_height && a.node->height != b.node->height) return a.node->height > b.node->height;
  const double a_area = half_area(a.box), b_area = half_area(b.box);
  if (a_area != b_area) return a_area > b_area;
  return a.opened < b.opened;  // coincident triangles would otherwise become a list
}

struct Policy {
  Open open;
  int width;  // children a node has at most
};

/// Opens inner children while there is room.
template <int Width>
int collapse(const BinaryNode& node, Policy policy, std::array<Child, Width>& children) {
  children[0] = {node.child[0], node.bounds[0], 0};
  children[1] = {node.child[1], node.bounds[1], 0};
  int count = 2;
  while (count < policy.width) {
    auto best = children.begin() + count;
    for (auto child = children.begin(); child != children.begin() + count; ++child) {
      if (child->node->is_leaf()) continue;
      if (best == children.begin() + count || before(*child, *best, policy.open)) best = child;
    }
    if (best == children.begin() + count) break;
    const Child opened = *best;
    std::move_backward(best + 1, children.begin() + count, children.begin() + count + 1);
    best[0] = {opened.node->child[0], opened.node->bounds[0], opened.opened + 1};
    best[1] = {opened.node->child[1], opened.node->bounds[1], opened.opened + 1};
    ++count;
  }
  return count;
}

/// The smallest exponent that can reach `extent` in 255 exact steps.
int first_exponent(double extent) {
  if (!(extent > 0)) return 1;
  int exponent = 0;
  std::frexp(extent / last_step, &exponent);  // below 2^exponent
  return std::clamp(exponent - 1 + 127, 1, 254);
}

/// Sets one axis.  The decoder rounds, so planes are found by asking it: it is monotone in the number of steps.
template <int Width>
void quantise_axis(const Box* boxes, int count, int axis, WideNodeRecord<Width>& node) {
  float lowest = boxes[0].lo[axis], highest = boxes[0].hi[axis];
  for (int i = 1; i < count; ++i) {
    lowest = std::min(lowest, boxes[i].lo[axis]);
    highest = std::max(highest, boxes[i].hi[axis]);
  }
  (axis == 0 ? node.origin.x : axis == 1 ? node.origin.y : node.origin.z) = lowest;
  const auto lo_at = [&](int i, int steps) {
    node.lo[axis][i] = static_cast<std::uint8_t>(steps);
    return hw::decoded_lo(node, axis, i);
  };
  const auto hi_at = [&](int i, int steps) {
    node.hi[axis][i] = static_cast<std::uint8_t>(steps);
    return hw::decoded_hi(node, axis, i);
  };
  int exponent = first_exponent(double{highest} - lowest);
  for (;; ++exponent) {
    if (exponent > 254) throw std::logic_error("wide node: boxes too large to quantise");
    node.exponent[axis] = static_cast<std::uint8_t>(exponent);
    if (hi_at(0, last_step) >= highest) break;
  }
  for (int i = 0; i < count; ++i) {
    int below = 0, above = last_step + 1;  // lo: decoded(below) <= lo, decoded(above) > lo
    while (above - below > 1) {
      const int middle = (below + above) / 2;
      (lo_at(i, middle) <= boxes[i].lo[axis] ? below : above) = middle;
    }
    lo_at(i, below);
    below = -1;
    above = last_step;  // hi: decoded(below) < hi, decoded(above) >= hi
    while (above - below > 1) {
      const int middle = (below + above) / 2;
      (hi_at(i, middle) >= boxes[i].hi[axis] ? above : below) = middle;
    }
    hi_at(i, above);
  }
}

template <int Width>
std::uint32_t lay_out(const BinaryNode& node, Policy policy, bool dynamic, std::uint32_t stacked, Tree& tree) {
  tree.stack = std::max(tree.stack, stacked);
  if (node.is_leaf()) return lay_out_leaf(node, dynamic, tree);
  const std::size_t at = tree.nodes.size();
  tree.nodes.resize(at + sizeof(WideNodeRecord<Width>));
  std::array<Child, Width> children{};
  const int count = collapse<Width>(node, policy, children);
  std::array<Box, Width> boxes;
  std::transform(children.begin(), children.end(), boxes.begin(), [](const Child& child) { return child.box; });
  WideNodeRecord<Width> record{};
  record.count = static_cast<std::uint8_t>(count);
  quantise(boxes.data(), count, record);
  std::fill(record.child, record.child + Width, NodeReference::none);
  for (int i = 0; i < count; ++i) {
    record.child[i] = lay_out<Width>(*children[static_cast<std::size_t>(i)].node, policy, dynamic,
                                     stacked + static_cast<std::uint32_t>(count) - 1, tree);
  }
  std::memcpy(tree.nodes.data() + at, &record, sizeof record);
  return NodeReference::inner(static_cast<std::uint32_t>(at / sizeof record), dynamic);
}

}  // namespace

template <int Width>
void quantise(const Box* boxes, int count, WideNodeRecord<Width>& node) {
  for (int axis = 0; axis < 3; ++axis) quantise_axis(boxes, count, axis, node);
}

template <int Width>
void lay_out_wide(const BinaryTree& binary, bool dynamic, Tree& tree) {
  Policy policy{Open::by_surface, Width};
  for (;;) {
    tree.nodes.clear();
    tree.order.clear();
    tree.stack = 0;
    tree.root = lay_out<Width>(binary.root(), policy, dynamic, 0, tree);
    if (tree.stack <= usual_stack || policy.width == 2) return;
    if (policy.open == Open::by_height) policy.width /= 2;  // with two children it is the binary tree
    policy.open = Open::by_height;
  }
}

template void quantise<4>(const Box*, int, WideNodeRecord<4>&);
template void quantise<8>(const Box*, int, WideNodeRecord<8>&);
template void lay_out_wide<4>(const BinaryTree&, bool, Tree&);
template void lay_out_wide<8>(const BinaryTree&, bool, Tree&);

}  // namespace artu::sim
