// stats.txt and the lists made from the same numbers.
#pragma once

#include <string>

#include "sim/report/numbers.h"

namespace artu::sim {

/// A short summary, the table of cycles, then every number as `name value unit # text`.
std::string format_stats(const Totals& sum, std::uint32_t clock_mhz, double golden_seconds);

/// `--list-stats`: the names that a run reports, with units and texts; of the cores only core0.
std::string format_stats_list(const Totals& sum, std::uint32_t clock_mhz);

}  // namespace artu::sim
