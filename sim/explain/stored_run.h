// A run's folder, read back: what it counted, on which unit, and from what.
#pragma once

#include <string>

#include "hw/unit_config.h"
#include "sim/report/manifest.h"
#include "sim/report/numbers.h"

namespace artu::sim {

struct StoredRun {
  Totals totals;  // cycles, frames, the dynamic tree's leaves and the blocks' counters; nothing else
  hw::UnitConfig unit;
  Manifest manifest;  // the input, frames, size and rate; fidelity, random stalls and whether a fault was injected
  bool falsified = false;
};

/// Throws InputError for a folder that no run made, or that lacks anything.
StoredRun read_run(const std::string& folder);

}  // namespace artu::sim
