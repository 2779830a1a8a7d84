// stats.txt and the lists made from the same numbers.
#pragma once

#include <string>

#include "sim/energy/energy.h"
#include "sim/report/numbers.h"

namespace artu::sim {

/// A short summary, the tables of cycles and energy, then every number as `name value unit # text`.  `energy` is null
/// where it was not computed.
std::string format_stats(const Totals& sum, std::uint32_t clock_mhz, double golden_seconds,
                         const Energy* energy = nullptr);

/// `--list-stats`: the names that a run reports, with units and texts; of the cores only core0.
std::string format_stats_list(const Totals& sum, std::uint32_t clock_mhz, const Energy* energy = nullptr);

}  // namespace artu::sim
