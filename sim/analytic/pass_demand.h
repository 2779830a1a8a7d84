// What passes ask of every resource of the unit, in cycles.
#pragma once

#include <array>
#include <vector>

#include "sim/analytic/closed_network.h"
#include "sim/analytic/cycle_model.h"
#include "sim/analytic/dram_service.h"

namespace artu::sim {

struct PassDemand {
  double cores = 1;
  double traced = 0, written = 0, candidates = 0;  // pixels
  std::vector<Station> stations;                   // without the memory behind the L1 caches' misses; always the same
  double delay = 0;                                // of all pixels, each as if it were alone and nothing missed
  std::array<double, 3> fetched{};                 // lines of the node, triangle and texture caches, all cores'
  double fills = 0;                                // lines that the L2 fetches
  DramLoad dram;

  PassDemand() = default;
  /// `cores`: as many as are busy, where not all get the same share.
  PassDemand(const hw::UnitConfig& config, const Load& load, double cores);
  PassDemand& operator-=(const PassDemand& part);
};

/// Cycles of a request that misses in an L1 and hits in the L2.
double l2_latency(const hw::UnitConfig& config);

}  // namespace artu::sim
