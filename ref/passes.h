// Which pass renders a pixel (docs/selective-rendering.md, "Passes").
#pragma once

#include <cstdint>

#include "ref/golden.h"

namespace artu::ref {

enum class PassKind : std::uint8_t { sampling, horizontal, vertical, centre };

/// Where a pixel stands in the order of passes.
struct Place {
  std::uint8_t pass = 0;  // numbered through all levels
  PassKind kind = PassKind::sampling;
  std::uint32_t h = 0;  // distance of its pair and its neighbours; 0 of a sampling pixel
};

inline int passes_of_a_level(const Settings& settings) { return settings.passes == Passes::average ? 3 : 2; }

/// Of all levels, the sampling pass included.
inline int pass_count(const Settings& settings) {
  int count = 1;
  if (!settings.selective) return count;
  for (int s = settings.stride; s > 1; s /= 2) count += passes_of_a_level(settings);
  return count;
}

inline Place place_of(const Settings& settings, std::uint32_t x, std::uint32_t y) {
  auto s = static_cast<std::uint32_t>(settings.stride);
  if (!settings.selective || (x % s == 0 && y % s == 0)) return {};
  int before = 1;  // passes before this level
  while (x % (s / 2) != 0 || y % (s / 2) != 0) {
    s /= 2;
    before += passes_of_a_level(settings);
  }
  const PassKind kind = y % s == 0                                         ? PassKind::horizontal
                        : settings.passes == Passes::average && x % s != 0 ? PassKind::centre
                                                                           : PassKind::vertical;
  const int step = kind == PassKind::horizontal ? 0 : kind == PassKind::vertical ? 1 : 2;
  return {static_cast<std::uint8_t>(before + step), kind, s / 2};
}

}  // namespace artu::ref
