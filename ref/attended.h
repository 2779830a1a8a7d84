// What the policies of our own end with (docs/selective-rendering.md, "Policies of our own").  A header is no policy.
#pragma once

#include <algorithm>
#include <cstddef>

#include "ref/policy.h"

namespace artu::ref::policies {

/// Of `policy_registers`; 0, which is what nobody has set, means `usual`.
inline int register_of(const Settings& settings, std::size_t i, int usual) {
  return settings.policy_registers[i] != 0 ? settings.policy_registers[i] : usual;
}

/// The threshold that the neighbours' `evidence` leads to, lower still where the viewer looks.
inline int attended(int evidence, const Candidate& candidate, const Settings& settings) {
  if (candidate.n_dynamic > 0) {
    evidence = std::max((evidence * register_of(settings, 1, 12) >> 4) - 4 * settings.step, 0);
  }
  return clamped(evidence, settings);
}

}  // namespace artu::ref::policies
