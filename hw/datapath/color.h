// 8-bit sRGB codes and linear light (docs/arithmetic.md sections 6 and 8), by tables.
#pragma once

#include <cstdint>

namespace artu::hw {

/// Linear light of an 8-bit code.
float decode(std::uint32_t code);

/// The nearest code; below 0 and NaN give 0, above 1 gives 255.
std::uint8_t encode(float linear);

}  // namespace artu::hw
