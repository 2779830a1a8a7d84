#include "sim/driver/tree_kd_split.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace artu::sim {

namespace {

constexpr double node_cost = 1, triangle_cost = 2;
constexpr double empty_bonus = 0.8;      // on the cost of a split that cuts empty space off
constexpr std::size_t sweep_limit = 32;  // up to here all of the triangles' bounds are tried, then even steps
constexpr int bins = 32;

constexpr float infinity = std::numeric_limits<float>::infinity();

}  // namespace

KdSplitter::KdSplitter(const std::vector<Box>& boxes, const Box& all, std::uint32_t leaf_size)
    : boxes_(boxes), leaf_size_(leaf_size) {
  const hw::Vector e = all.hi - all.lo;
  flat_ = 0x1p-20 * std::max({double{e.x}, double{e.y}, double{e.z}});
}

/// Of a cell that is not split: more triangles than a leaf may have are leaves below nodes that share the cell.
double KdSplitter::leaf_cost(std::size_t count) const {
  if (count == 0) return 0;
  const std::size_t leaves = (count + leaf_size_ - 1) / leaf_size_;
  return triangle_cost * static_cast<double>(count) + node_cost * static_cast<double>(leaves - 1);
}

/// Takes the plane on the axis if it is the best so far.
void KdSplitter::consider(const Axis& on, float at, std::size_t below, std::size_t above) {
  if (!(on.lo < at && at < on.hi) || below + above > on.budget) return;
  const double lower = on.face + on.girth * (double{at} - on.lo), upper = on.face + on.girth * (double{on.hi} - at);
  double cost = (lower * leaf_cost(below) + upper * leaf_cost(above)) / on.whole;
  if (below == 0 || above == 0) cost *= empty_bonus;
  cost += node_cost;
  if (cost < best_.cost) best_ = {cost, on.axis, at};
}

/// Tries planes just outside of every triangle's box: a plane in its face would leave the triangle on both sides.
void KdSplitter::sweep(const Axis& on, const std::vector<std::uint32_t>& ids) {
  const std::size_t count = ids.size();
  los_.clear();
  his_.clear();
  for (const std::uint32_t id : ids) {
    los_.push_back(boxes_[id].lo[on.axis]);
    his_.push_back(boxes_[id].hi[on.axis]);
  }
  std::sort(los_.begin(), los_.end());
  std::sort(his_.begin(), his_.end());
  for (std::size_t below = 0, ended = 0; below < count; ++below) {
    if (below != 0 && los_[below] == los_[below - 1]) continue;
    const float at = std::nextafter(los_[below], -infinity);
    while (his_[ended] < at) ++ended;
    consider(on, at, below, count - ended);
  }
  for (std::size_t ended = 1, below = 0; ended <= count; ++ended) {
    if (ended != count && his_[ended] == his_[ended - 1]) continue;
    const float at = std::nextafter(his_[ended - 1], infinity);
    while (below < count && los_[below] <= at) ++below;
    consider(on, at, below, count - ended);
  }
}

/// Tries planes at even steps and at both ends of what the cell holds.
void KdSplitter::bin(const Axis& on, const std::vector<std::uint32_t>& ids) {
  float lowest = infinity, highest = -infinity;
  for (const std::uint32_t id : ids) {
    lowest = std::min(lowest, boxes_[id].lo[on.axis]);
    highest = std::max(highest, boxes_[id].hi[on.axis]);
  }
  const double lo = std::max(on.lo, lowest), hi = std::min(on.hi, highest);
  std::array<float, bins + 1> planes;
  planes[0] = std::nextafter(lowest, -infinity);
  planes[bins] = std::nextafter(highest, infinity);
  for (int i = 1; i < bins; ++i) planes[static_cast<std::size_t>(i)] = static_cast<float>(lo + (hi - lo) * i / bins);
  // Where a bound lies among the planes is guessed, then put right.
  const double scale = hi > lo ? bins / (hi - lo) : 0;
  const auto guess = [&](float bound) {
    return static_cast<std::size_t>(std::clamp((bound - lo) * scale, 0.0, double{bins}));
  };
  std::array<std::size_t, bins + 2> first{}, last{};
  for (const std::uint32_t id : ids) {
    const float from = boxes_[id].lo[on.axis], to = boxes_[id].hi[on.axis];
    std::size_t i = guess(from);  // the first plane that has the triangle below it
    while (i > 0 && planes[i - 1] >= from) --i;
    while (i <= bins && planes[i] < from) ++i;
    ++first[i];
    i = guess(to);  // the first plane that does not have it above
    while (i > 0 && planes[i - 1] > to) --i;
    while (i <= bins && planes[i] <= to) ++i;
    ++last[i];
  }
  std::size_t below = 0, above = ids.size();
  for (std::size_t i = 0; i < planes.size(); ++i) {
    below += first[i];
    above -= last[i];
    consider(on, planes[i], below, above);
  }
}

KdSplit KdSplitter::best(const std::vector<std::uint32_t>& ids, const Box& cell, std::uint64_t budget) {
  best_ = {};
  best_.cost = leaf_cost(ids.size());
  double extent[3];
  for (int axis = 0; axis < 3; ++axis) extent[axis] = double{cell.hi[axis]} - cell.lo[axis];
  for (int axis = 0; axis < 3; ++axis) {
    const double u = extent[(axis + 1) % 3], v = extent[(axis + 2) % 3];
    Axis on{axis, cell.lo[axis], cell.hi[axis], u + v + flat_, u * v + flat_ * (u + v), 0, budget};
    on.whole = on.face + on.girth * extent[axis];
    if (!(on.whole > 0)) continue;
    if (ids.size() <= sweep_limit) {
      sweep(on, ids);
    } else {
      bin(on, ids);
    }
  }
  return best_;
}

}  // namespace artu::sim
