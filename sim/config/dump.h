// A configuration as a TOML file that loads again to the same.
#pragma once

#include <string>

#include "hw/unit_config.h"

namespace artu::sim {

/// Every parameter, with its text, unit and range as a comment.
std::string dump_config(const hw::UnitConfig& config);

}  // namespace artu::sim
