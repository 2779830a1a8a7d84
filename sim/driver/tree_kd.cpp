#include "sim/driver/tree_kd.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "sim/driver/tree_kd_split.h"

namespace artu::sim {

namespace {

using hw::KdNodeRecord;
using hw::NodeReference;
using Ids = std::vector<std::uint32_t>;

constexpr std::uint64_t most_references = 4;  // for each triangle; no tree has more

/// How many levels halve `count` to one.
std::uint32_t levels(std::size_t count) {
  std::uint32_t result = 0;
  while ((std::size_t{1} << result) < count) ++result;
  return result;
}

float& component(hw::Vector& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

class KdBuilder {
 public:
  KdBuilder(const std::vector<Box>& boxes, const TreeRecipe& recipe, bool dynamic, Tree& tree)
      : boxes_(boxes),
        leaf_size_(recipe.leaf_size),
        on_chip_(recipe.builder.triangles_per_pass),
        dynamic_(dynamic),
        tree_(tree),
        splitter_(boxes, {tree.lo, tree.hi}, recipe.leaf_size),
        depth_limit_(8 + 13 * levels(boxes.size()) / 10) {}

  void build() {
    Ids ids(boxes_.size());
    for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<std::uint32_t>(i);
    const std::uint64_t budget =
        std::min<std::uint64_t>(most_references * ids.size(), NodeReference::maximum_triangles);
    tree_.root = node(std::move(ids), {tree_.lo, tree_.hi}, 0, budget, 0, true);
  }

 private:
  /// `below_upper`: all nodes above have more references than fit on chip.
  std::uint32_t node(Ids ids, const Box& cell, std::uint32_t depth, std::uint64_t budget, std::uint32_t stacked,
                     bool below_upper) {
    if (ids.empty()) return NodeReference::none;
    const KdSplit best = depth < depth_limit_ ? splitter_.best(ids, cell, budget) : KdSplit{};
    const bool streamed = best.axis >= 0 && ids.size() > on_chip_;
    if (below_upper && !streamed) tree_.work.lower_references += static_cast<std::uint32_t>(ids.size());
    if (best.axis < 0) return leaf(ids.data(), ids.size(), stacked);
    count_split(ids.size(), depth, streamed);

    Ids below, above;
    for (const std::uint32_t id : ids) {
      if (boxes_[id].lo[best.axis] <= best.at) below.push_back(id);
      if (boxes_[id].hi[best.axis] >= best.at) above.push_back(id);
    }
    Ids().swap(ids);
    const std::uint64_t below_budget = budget * below.size() / (below.size() + above.size());
    if (!below.empty() && !above.empty()) ++stacked;
    Box lower = cell, upper = cell;
    component(lower.hi, best.axis) = component(upper.lo, best.axis) = best.at;
    const std::size_t at = allocate();
    KdNodeRecord record{best.at, static_cast<std::uint32_t>(best.axis), {}};
    record.child[0] = node(std::move(below), lower, depth + 1, below_budget, stacked, streamed);
    record.child[1] = node(std::move(above), upper, depth + 1, budget - below_budget, stacked, streamed);
    return store(at, record);
  }

  void count_split(std::size_t references, std::uint32_t depth, bool upper) {
    hw::BuildWork& work = tree_.work;
    ++work.splits;
    work.references += references;
    if (!upper) return;
    ++work.upper_splits;
    work.upper_references += references;
    work.upper_levels = std::max(work.upper_levels, depth + 1);
  }

  /// A run of references, or a balanced tree of runs that share the cell.
  std::uint32_t leaf(const std::uint32_t* ids, std::size_t count, std::uint32_t stacked) {
    const std::size_t most = leaf_size_;
    if (count <= most) {
      tree_.stack = std::max(tree_.stack, stacked);
      const auto first = static_cast<std::uint32_t>(tree_.order.size());
      tree_.order.insert(tree_.order.end(), ids, ids + count);
      return NodeReference::leaf(first, static_cast<std::uint32_t>(count), dynamic_);
    }
    const std::size_t half = ((count + most - 1) / most + 1) / 2 * most;
    const std::size_t at = allocate();
    KdNodeRecord record{0, KdNodeRecord::both, {}};
    record.child[0] = leaf(ids, half, stacked + 1);
    record.child[1] = leaf(ids + half, count - half, stacked + 1);
    return store(at, record);
  }

  std::size_t allocate() {
    const std::size_t at = tree_.nodes.size();
    if (at / sizeof(KdNodeRecord) >= NodeReference::maximum_nodes - 1)
      throw std::length_error("kd-tree: too many nodes");
    tree_.nodes.resize(at + sizeof(KdNodeRecord));
    return at;
  }

  std::uint32_t store(std::size_t at, const KdNodeRecord& record) {
    std::memcpy(tree_.nodes.data() + at, &record, sizeof record);
    return NodeReference::inner(static_cast<std::uint32_t>(at / sizeof record), dynamic_);
  }

  const std::vector<Box>& boxes_;
  const std::uint32_t leaf_size_, on_chip_;
  const bool dynamic_;
  Tree& tree_;
  KdSplitter splitter_;
  const std::uint32_t depth_limit_;
};

}  // namespace

void lay_out_kd(const std::vector<Box>& boxes, const TreeRecipe& recipe, bool dynamic, Tree& tree) {
  KdBuilder(boxes, recipe, dynamic, tree).build();
}

}  // namespace artu::sim
