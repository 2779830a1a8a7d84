#include "hw/memory/replacement.h"

#include <algorithm>

namespace artu::hw {

Replacement::Replacement(ReplacementPolicy policy, std::size_t sets, std::uint32_t ways, std::uint32_t seed)
    : policy_(policy), ways_(ways), seed_(seed) {
  if (policy == ReplacementPolicy::lru) used_.resize(sets * ways);
  if (policy == ReplacementPolicy::plru) used_.resize(sets);
  reset();
}

void Replacement::reset() {
  std::fill(used_.begin(), used_.end(), 0);
  clock_ = 0;
  state_ = next(seed_ + 0x9e3779b97f4a7c15u);
}

/// SplitMix64's finaliser over a counter: every value once, and no short cycles.
std::uint64_t Replacement::next(std::uint64_t state) {
  std::uint64_t x = state + 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// From the root down, each node is pointed away from the way.  Node n has children 2n and 2n + 1; the root is 1.
void Replacement::point_away(std::size_t set, std::uint32_t way) {
  std::uint64_t& bits = used_[set];
  std::uint32_t node = 1;
  for (std::uint32_t half = ways_ / 2; half != 0; half /= 2) {
    const bool right = (way & half) != 0;
    bits = right ? bits & ~(std::uint64_t{1} << node) : bits | std::uint64_t{1} << node;
    node = 2 * node + (right ? 1 : 0);
  }
}

std::uint32_t Replacement::victim(std::size_t set) const {
  if (policy_ == ReplacementPolicy::random) return static_cast<std::uint32_t>(state_ >> 32) & (ways_ - 1);
  if (policy_ == ReplacementPolicy::lru) {
    const auto first = used_.begin() + static_cast<std::ptrdiff_t>(set * ways_);
    return static_cast<std::uint32_t>(std::min_element(first, first + ways_) - first);
  }
  std::uint32_t node = 1, way = 0;
  for (std::uint32_t half = ways_ / 2; half != 0; half /= 2) {
    const bool right = (used_[set] >> node & 1) != 0;
    way += right ? half : 0;
    node = 2 * node + (right ? 1 : 0);
  }
  return way;
}

}  // namespace artu::hw
