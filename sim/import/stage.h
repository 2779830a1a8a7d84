// Stages: several files in one scene, placed, moved and lit, from a TOML file.
#pragma once

#include "sim/import/load.h"

namespace artu::sim {

/// Throws InputError("FILE:LINE", ...).
LoadedScene load_stage(const std::string& path, std::vector<std::string>& log);

}  // namespace artu::sim
