// Lowers the threshold where earlier passes of the level had to trace, where hit classes meet, and for attention
// (docs/selective-rendering.md, "decisions").  Our own; it reads the hit classes alone.
#include "hw/selective/attentive.h"
#include "hw/selective/policy.h"

namespace artu::hw::policies {

namespace {

/// Traced neighbours that were candidates of the level, at most 4.
int traced_candidates(const Evidence& evidence) {
  const int h = evidence.h, stride = 2 * h;
  int traced = 0, i = 0;
  for (int dy = -h; dy <= h; dy += h) {
    for (int dx = -h; dx <= h; dx += h) {
      if (dx == 0 && dy == 0) continue;
      const Neighbour& neighbour = evidence.ring[static_cast<std::size_t>(i++)];
      const bool sample = (evidence.x + dx) % stride == 0 && (evidence.y + dy) % stride == 0;
      traced += neighbour.finished && neighbour.hit_class != HitClass::none && !sample;
    }
  }
  // Those above and below alone: the other two of the four would be left and right, in this very pass.
  return evidence.kind == PassKind::vertical && evidence.x % stride != 0 ? 2 * traced : traced;
}

bool classes_meet(const Ring& ring) {
  unsigned seen = 0;
  for (const Neighbour& neighbour : ring) {
    if (neighbour.finished && neighbour.hit_class != HitClass::none) {
      seen |= 1u << static_cast<unsigned>(neighbour.hit_class);
    }
  }
  return (seen & (seen - 1)) != 0;
}

std::uint8_t threshold(const Evidence& evidence, const SelectiveConfig& config) {
  const int traced = traced_candidates(evidence);
  int lowered = static_cast<int>(config.reference) >> (traced == 0 ? 0 : traced == 1 ? 1 : 3);
  if (classes_meet(evidence.ring))
    lowered = lowered * static_cast<int>(or_default(config.policy_registers[0], 12)) >> 4;
  return attentive(lowered, evidence, config);
}

}  // namespace

// Eight neighbours counted and their classes gathered, a shift, a product, the tail.
Policy decisions() { return {2, 24, threshold}; }

}  // namespace artu::hw::policies
