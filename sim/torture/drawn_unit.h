// Configurations drawn from everything that can be configured.
#pragma once

#include <string>
#include <vector>

#include "hw/unit_config.h"
#include "sim/stress/random.h"

namespace artu::sim {

/// Some of the parameters, as `path=value` for Configuration::set; each value within its parameter's range, numbers
/// even over their logarithm.  Together they may still break a rule that ties parameters together.
/// Left alone: unit.watchdog, which would call a slow unit dead, and sizes above 1 MiB, which only cost memory.
std::vector<std::string> draw_assignments(Random& random);

/// The same until Configuration accepts them: a drawn assignment that it refuses is left out.
std::vector<std::string> draw_unit(Random& random);

}  // namespace artu::sim
