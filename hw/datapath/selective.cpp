#include "hw/datapath/selective.h"

#include <algorithm>
#include <cstdlib>

namespace artu::hw {

HitCounts count_hits(const std::array<HitClass, 8>& neighbours) {
  HitCounts counts;
  for (HitClass hit_class : neighbours) {
    counts.n_static += hit_class == HitClass::static_geometry;
    counts.n_dynamic += hit_class == HitClass::dynamic_geometry;
  }
  return counts;
}

std::uint8_t adjusted_threshold(const SelectiveConfig& config, HitCounts counts) {
  const int excess = static_cast<int>(counts.n_dynamic) - static_cast<int>(counts.n_static);
  const int difference = std::abs(excess);
  int move = 0;
  if (config.adaptive && difference > 0) {
    switch (config.magnitude) {
      case Magnitude::fixed:
        move = static_cast<int>(config.step);
        break;
      case Magnitude::proportional:
        move = static_cast<int>(config.step) * difference;
        break;
      case Magnitude::progressive:
        move = static_cast<int>(config.table[static_cast<std::size_t>(difference - 1)]);
        break;
    }
  }
  const int threshold = static_cast<int>(config.reference) + (excess > 0 ? -move : move);
  return static_cast<std::uint8_t>(
      std::clamp(threshold, static_cast<int>(config.minimum), static_cast<int>(config.maximum)));
}

std::uint8_t color_difference(Rgb a, Rgb b) {
  const int r = std::abs(a.r - b.r), g = std::abs(a.g - b.g), blue = std::abs(a.b - b.b);
  return static_cast<std::uint8_t>(std::max({r, g, blue}));
}

Rgb interpolate(Rgb a, Rgb b) {
  const auto mean = [](unsigned p, unsigned q) { return static_cast<std::uint8_t>((p + q + 1) >> 1); };
  return {mean(a.r, b.r), mean(a.g, b.g), mean(a.b, b.b)};
}

}  // namespace artu::hw
