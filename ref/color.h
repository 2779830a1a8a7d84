// The sRGB curve as two tables (docs/arithmetic.md sections 6 and 8).
#pragma once

#include <array>
#include <cstdint>

namespace artu::ref {

struct Srgb {
  std::array<float, 256> linear;     // by code: the binary32 nearest to the curve
  std::array<float, 256> threshold;  // by code 1 ... 255: the smallest value that is coded so; [0] is not used

  Srgb();
  float decode(std::uint8_t code) const { return linear[code]; }
  /// Nearest code of a linear value; 0 below 0 and for a NaN, 255 above 1.
  std::uint8_t encode(float x) const;
};

/// The tables, computed on first use.
const Srgb& srgb();

}  // namespace artu::ref
