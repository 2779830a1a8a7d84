// What of the unit's configuration changes pixels, as the golden model takes it.
#pragma once

#include <string>

#include "hw/unit_config.h"
#include "ref/golden.h"

namespace artu::sim {

/// Throws InputError where the unit's policy has no twin in the golden model.
ref::Settings golden_settings(const hw::UnitConfig& unit);

/// The policy's name, if the golden model has one of that name; otherwise throws as above.
std::string twin_of(const std::string& policy);

}  // namespace artu::sim
