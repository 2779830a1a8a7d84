// The rules that tie two parameters together.
#pragma once

#include <map>
#include <string>

#include "hw/unit_config.h"

namespace artu::sim {

/// Throws InputError with the place of a parameter that breaks a rule (`places`: parameter -> FILE:LINE).
void cross_check(const hw::UnitConfig& unit, const std::map<std::string, std::string>& places);

}  // namespace artu::sim
