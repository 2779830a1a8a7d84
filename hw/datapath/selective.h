// Integer arithmetic of selective rendering (docs/selective-rendering.md): counts, differences, means.
#pragma once

#include <array>
#include <cstdint>

#include "hw/pixel_record.h"
#include "hw/unit_config.h"

namespace artu::hw {

struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
};

/// A pixel at distance h from a candidate. Not finished in an earlier pass, or outside the image: black, class none.
struct Neighbour {
  bool finished = false;
  HitClass hit_class = HitClass::none;  // none as well where it was interpolated
  Rgb color;
};

/// Row by row from the upper left, without the candidate itself.
using Ring = std::array<Neighbour, 8>;

/// The pairs that are compared: none where one is incomplete, which is at the border; of a centre two, the horizontal
/// one first.
struct Pairs {
  std::uint8_t count = 0;
  std::array<std::array<Rgb, 2>, 2> color{};
};

struct HitCounts {
  std::uint8_t n_static = 0, n_dynamic = 0;
};

/// What a pass of a level compares.
enum class PassKind : std::uint8_t { horizontal, vertical, centre };

/// What is known of a candidate before its decision.
struct Evidence {
  std::uint16_t x = 0, y = 0;
  std::uint8_t h = 1;
  PassKind kind = PassKind::horizontal;
  Pairs pairs;
  Ring ring;
  HitCounts counts;
};

/// Of the eight neighbours; none and miss count nothing.
HitCounts count_hits(const Ring& ring);

/// 0 ... 255, with `sum` 0 ... 765.
std::uint16_t color_difference(Metric metric, Rgb a, Rgb b);
/// The sum over the pairs; -1 without a pair.
int color_difference(Metric metric, const Pairs& pairs);

/// The rounded mean of each channel, of two or four colours.
Rgb interpolate(const Pairs& pairs);

}  // namespace artu::hw
