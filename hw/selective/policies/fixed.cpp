// The reference, clamped: plain selective rendering, the baseline of every comparison.
#include <algorithm>

#include "hw/selective/policy.h"

namespace artu::hw::policies {

Policy fixed() {
  return {1, 2, [](const Evidence&, const SelectiveConfig& config) {
            return static_cast<std::uint8_t>(std::clamp(config.reference, config.minimum, config.maximum));
          }};
}

}  // namespace artu::hw::policies
