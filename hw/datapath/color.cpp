#include "hw/datapath/color.h"

namespace artu::hw {

namespace {
#include "hw/datapath/srgb_tables.inc"
}

float decode(std::uint32_t code) { return decode_table[code]; }

std::uint8_t encode(float linear) {
  // Binary search: the largest code whose threshold is not above the value.  Code 0 has none.
  unsigned low = 0, high = 256;
  while (high - low > 1) {
    const unsigned middle = (low + high) / 2;
    if (linear >= threshold_table[middle]) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return static_cast<std::uint8_t>(low);
}

}  // namespace artu::hw
