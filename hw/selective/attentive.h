// The end of a policy that looks at the picture first: lower where dynamic geometry is near, then clamped.
#pragma once

#include <algorithm>

#include "hw/datapath/selective.h"

namespace artu::hw::policies {

inline std::uint32_t or_default(std::uint32_t policy_register, std::uint32_t value) {
  return policy_register == 0 ? value : policy_register;
}

/// `threshold` is not negative.
inline std::uint8_t attentive(int threshold, const Evidence& evidence, const SelectiveConfig& config) {
  if (evidence.counts.n_dynamic > 0) {
    const auto weight = static_cast<int>(or_default(config.policy_registers[1], 12));
    threshold = std::max((threshold * weight >> 4) - 4 * static_cast<int>(config.step), 0);
  }
  return static_cast<std::uint8_t>(
      std::clamp(threshold, static_cast<int>(config.minimum), static_cast<int>(config.maximum)));
}

}  // namespace artu::hw::policies
