// What `artu run` prints when it is done: the answer in about ten lines.
#pragma once

#include <cstdint>
#include <string>

#include "sim/energy/energy.h"
#include "sim/report/numbers.h"
#include "sim/scaling/demand.h"

namespace artu::sim {

struct SummaryHeading {
  std::string scene;  // name or file
  std::uint32_t width = 0, height = 0;
  std::uint32_t first_frame = 0, last_frame = 0;  // half-open
  std::uint32_t clock_mhz = 0;
};

/// `energy` is null where it was not computed.
/// Says what limits the frame where `demands` are given.
std::string format_summary(const SummaryHeading& heading, const Totals& sum, const Energy* energy = nullptr,
                           const std::vector<Demand>& demands = {});

}  // namespace artu::sim
