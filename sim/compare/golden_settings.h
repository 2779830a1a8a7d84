// What of the unit's configuration changes pixels, as the golden model takes it.
#pragma once

#include "hw/unit_config.h"
#include "ref/golden.h"

namespace artu::sim {

ref::Settings golden_settings(const hw::UnitConfig& unit);

}  // namespace artu::sim
