// The unit's configuration as JSON: an object for each group, as `--dump-config` has them.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "hw/unit_config.h"

namespace artu::sim {

nlohmann::ordered_json json_of(const hw::UnitConfig& config);

}  // namespace artu::sim
