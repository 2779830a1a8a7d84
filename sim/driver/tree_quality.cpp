#include "sim/driver/tree_quality.h"

#include <algorithm>
#include <cstring>

#include "hw/datapath/node_visit.h"
#include "sim/driver/tree_box.h"

namespace artu::sim {

namespace {

using hw::NodeReference;

class Survey {
 public:
  explicit Survey(const Tree& tree) : tree_(tree), whole_(half_area({tree.lo, tree.hi})) {}

  TreeQuality run() {
    if (!tree_.order.empty()) visit(tree_.root, {tree_.lo, tree_.hi}, 0);
    return found_;
  }

 private:
  /// `depth` nodes are above.
  void visit(std::uint32_t reference, const Box& box, std::uint64_t depth) {
    if (reference == NodeReference::none) return;
    const double chance = whole_ > 0 ? std::min(1.0, half_area(box) / whole_) : 1;
    if (NodeReference::is_leaf(reference)) {
      const std::uint32_t count = NodeReference::count(reference);
      ++found_.leaves;
      found_.references += count;
      found_.triangle_tests += chance * count;
      return;
    }
    ++found_.nodes;
    found_.depth = std::max(found_.depth, depth + 1);
    const std::uint8_t* record =
        tree_.nodes.data() + std::size_t{NodeReference::index(reference)} * hw::node_bytes(tree_.kind);
    switch (tree_.kind) {
      case hw::TreeKind::bvh2:
        return visit_binary(record, chance, depth + 1);
      case hw::TreeKind::bvh4:
        return visit_wide<4>(record, chance, depth + 1);
      case hw::TreeKind::bvh8:
        return visit_wide<8>(record, chance, depth + 1);
      case hw::TreeKind::kd:
        return visit_kd(record, box, chance, depth + 1);
    }
  }

  void visit_binary(const std::uint8_t* record, double chance, std::uint64_t depth) {
    hw::NodeRecord node;
    std::memcpy(&node, record, sizeof node);
    found_.box_tests += chance * 2;
    for (int i = 0; i < 2; ++i) visit(node.child[i], {node.lo[i], node.hi[i]}, depth);
  }

  template <int Width>
  void visit_wide(const std::uint8_t* record, double chance, std::uint64_t depth) {
    hw::WideNodeRecord<Width> node;
    std::memcpy(&node, record, sizeof node);
    found_.box_tests += chance * node.count;
    for (int i = 0; i < node.count; ++i) {
      const Box box{{decoded_lo(node, 0, i), decoded_lo(node, 1, i), decoded_lo(node, 2, i)},
                    {decoded_hi(node, 0, i), decoded_hi(node, 1, i), decoded_hi(node, 2, i)}};
      visit(node.child[i], box, depth);
    }
  }

  void visit_kd(const std::uint8_t* record, const Box& cell, double chance, std::uint64_t depth) {
    hw::KdNodeRecord node;
    std::memcpy(&node, record, sizeof node);
    found_.box_tests += chance;
    Box cells[2] = {cell, cell};
    if (node.axis != hw::KdNodeRecord::both) {
      const auto component = [&](hw::Vector& v) -> float& { return node.axis == 0 ? v.x : node.axis == 1 ? v.y : v.z; };
      component(cells[0].hi) = component(cells[1].lo) = node.split;
    }
    for (int i = 0; i < 2; ++i) visit(node.child[i], cells[i], depth);
  }

  const Tree& tree_;
  const double whole_;
  TreeQuality found_;
};

}  // namespace

double TreeQuality::sah_cost() const { return box_test_cost * box_tests + triangle_test_cost * triangle_tests; }

TreeQuality quality_of(const Tree& tree) { return Survey(tree).run(); }

}  // namespace artu::sim
