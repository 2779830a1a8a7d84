// How much of what each resource of the unit could do a run has asked of it: what it cannot go faster than.
#pragma once

#include <string>
#include <vector>

#include "hw/unit_config.h"
#include "sim/report/numbers.h"

namespace artu::sim {

/// `share` is the demand over the capacity in the cycles that the run took, 0 ... 1: a frame cannot take less than this
/// share of its cycles as long as the resource stays as it is.
struct Demand {
  std::string resource;
  double share = 0;
};

/// In a fixed order: box testers, triangle testers, the L1 caches' ports, L2 banks, DRAM buses, the extractor of
/// candidates, and the phases in which the cores have nothing to do.
std::vector<Demand> demands(const Totals& totals, const hw::UnitConfig& unit);

/// Of the fidelities that have the counters for it; none for the others.
std::vector<Demand> demands_if_known(const Totals& totals, const hw::UnitConfig& unit);

/// The resource with the largest demand: what a frame would gain most from is more of it, or less asked of it.
Demand bottleneck(const std::vector<Demand>& demands);

/// Mean share of the cores' contexts that hold a pixel.
double contexts_filled(const Totals& totals, const hw::UnitConfig& unit);

/// What holds the run up: the resource with the largest demand where that is 0.75 or more; else "latency" where the
/// contexts are at least three quarters full (more of them would hide it), else "too few pixels in flight".
std::string limit_of(const Totals& totals, const hw::UnitConfig& unit);

}  // namespace artu::sim
