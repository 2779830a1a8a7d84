// The sRGB curve as two tables (docs/arithmetic.md sections 6 and 8).
#pragma once

#include <array>
#include <cstdint>

namespace artu::ref {

/// F is float or double.
template <class F>
struct SrgbIn {
  std::array<F, 256> linear;     // by code: the F nearest to the curve
  std::array<F, 256> threshold;  // by code 1 ... 255: the smallest value that is coded so; [0] is not used

  SrgbIn();
  F decode(std::uint8_t code) const { return linear[code]; }
  /// Nearest code of a linear value; 0 below 0 and for a NaN, 255 above 1.
  std::uint8_t encode(F x) const;
};
using Srgb = SrgbIn<float>;

/// The tables, computed on first use.
template <class F = float>
const SrgbIn<F>& srgb();

}  // namespace artu::ref
