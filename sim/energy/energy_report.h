// An energy as the reports print it.
#pragma once

#include <string>
#include <vector>

#include "sim/energy/energy.h"

namespace artu::sim {

/// Of all frames together: the sum, and what a frame, a ray and a ray-traced pixel take; the mean power at the clock.
std::vector<Number> energy_numbers(const Energy& energy);
/// Shares of a frame, named after the blocks and the events.
std::vector<Number> energy_blocks(const Energy& energy);
std::vector<Number> energy_events(const Energy& energy);

/// For stats.txt: a row a block.
std::string format_energy_table(const Energy& energy);

}  // namespace artu::sim
