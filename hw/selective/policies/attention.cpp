// The patent's: the threshold falls where more rays hit dynamic geometry, so that more is traced where the viewer
// looks, and rises where fewer do (C5, C6, C11 to C13).
#include <algorithm>
#include <cstdlib>

#include "hw/selective/policy.h"

namespace artu::hw::policies {

namespace {

/// By how many hits the side that lowers the threshold is ahead, -8 ... 8.
int excess(HitCounts counts, const SelectiveConfig& config) {
  if (config.compare == Compare::dynamic_vs_static) return counts.n_dynamic - counts.n_static;
  const int count = counts.n_dynamic + (config.count == Count::merged ? counts.n_static : 0);
  return count - static_cast<int>(config.reference_count);
}

int move(int difference, const SelectiveConfig& config) {
  if (difference == 0) return 0;
  switch (config.magnitude) {
    case Magnitude::fixed:
      return static_cast<int>(config.step);
    case Magnitude::proportional:
      return static_cast<int>(config.step) * difference;
    case Magnitude::progressive:
      return static_cast<int>(config.table[static_cast<std::size_t>(difference - 1)]);
  }
  return 0;
}

std::uint8_t threshold(const Evidence& evidence, const SelectiveConfig& config) {
  const int ahead = config.adaptive ? excess(evidence.counts, config) : 0;
  const int by = move(std::abs(ahead), config);
  const int moved = static_cast<int>(config.reference) + (ahead > 0 ? -by : by);
  return static_cast<std::uint8_t>(
      std::clamp(moved, static_cast<int>(config.minimum), static_cast<int>(config.maximum)));
}

}  // namespace

Policy attention() { return {2, 5, threshold}; }  // operations: difference, its size, the move, two limits

}  // namespace artu::hw::policies
