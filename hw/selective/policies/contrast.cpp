// Lowers the threshold by what interpolating would have been wrong by a row or a column beside, and for attention
// (docs/selective-rendering.md, "contrast").  Our own: a candidate beside a traced edge has one itself, more often
// than not, whatever its pair's colours say.
#include <algorithm>
#include <cstdlib>

#include "hw/selective/attentive.h"
#include "hw/selective/policy.h"

namespace artu::hw::policies {

namespace {

/// Twice the error of the middle one, had it been interpolated; 0 where a pixel is not finished.
int bend(const Neighbour& a, const Neighbour& m, const Neighbour& b) {
  if (!a.finished || !m.finished || !b.finished) return 0;
  const auto of = [](int end, int middle, int other) { return std::abs(2 * middle - end - other); };
  return std::max(
      {of(a.color.r, m.color.r, b.color.r), of(a.color.g, m.color.g, b.color.g), of(a.color.b, m.color.b, b.color.b)});
}

std::uint8_t threshold(const Evidence& evidence, const SelectiveConfig& config) {
  const Ring& ring = evidence.ring;
  const int largest = std::max({bend(ring[0], ring[1], ring[2]), bend(ring[5], ring[6], ring[7]),
                                bend(ring[0], ring[3], ring[5]), bend(ring[2], ring[4], ring[7])});
  const auto weight = static_cast<int>(or_default(config.policy_registers[0], 8));
  return attentive(std::max(static_cast<int>(config.reference) - (largest * weight >> 4), 0), evidence, config);
}

}  // namespace

// Twelve second differences of three operations and their maximum, the weight, the tail.
Policy contrast() { return {4, 52, threshold}; }

}  // namespace artu::hw::policies
