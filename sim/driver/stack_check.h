// Whether the trees of a frame fit the stacks of a unit's traversals.
#pragma once

#include <cstdint>
#include <string>

#include "hw/unit_config.h"

namespace artu::sim {

/// Throws InputError where a traversal may need more entries than the unit can hold, spill or find again.
void check_stack(const std::string& scene, std::uint32_t frame, std::uint32_t needed, const hw::RayCoreConfig& core);

}  // namespace artu::sim
