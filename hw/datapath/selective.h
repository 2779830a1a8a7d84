// Integer arithmetic of selective rendering (docs/selective-rendering.md): counts, threshold, difference, mean.
#pragma once

#include <array>
#include <cstdint>

#include "hw/pixel_record.h"
#include "hw/unit_config.h"

namespace artu::hw {

struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
};

struct HitCounts {
  std::uint8_t n_static = 0, n_dynamic = 0;
};

/// Of the eight neighbours; none and miss count nothing.
HitCounts count_hits(const std::array<HitClass, 8>& neighbours);

/// The reference threshold moved by the counts and clamped, 0 ... 255.
std::uint8_t adjusted_threshold(const SelectiveConfig& config, HitCounts counts);

/// The largest of the channels' absolute differences.
std::uint8_t color_difference(Rgb a, Rgb b);

/// The rounded mean of each channel.
Rgb interpolate(Rgb a, Rgb b);

}  // namespace artu::hw
