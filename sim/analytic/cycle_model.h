// From a frame's demand on every resource to its cycles.
#pragma once

#include <string>
#include <vector>

#include "hw/functional/counts.h"
#include "hw/unit_config.h"
#include "sim/analytic/build_time.h"
#include "sim/analytic/demand_tap.h"

namespace artu::sim {

/// What a stretch of the frame asks of the unit.
struct Load {
  hw::FunctionalCounts counts;
  RequestCounts requests;
  MemoryCounts memory;  // of the sample
};

/// What a frame asks, phase by phase.
struct FrameLoad {
  Load first, all;  // the first pass; all passes
  BuildTime build;
  std::uint64_t descriptor_lines = 0, dirty_lines = 0;
  double imbalance = 1;  // of the cores
};

/// The passes take no less cycles than this.
struct CycleBound {
  std::string resource;
  double cycles = 0;
};

struct CycleEstimate {
  double start = 0, build = 0, first = 0, selective = 0, flush = 0;
  double tracing = 0;              // of the cores alone, in the passes
  std::vector<CycleBound> bounds;  // of the passes, and "latency": as many pixels in flight as there are contexts
  double total() const { return start + build + first + selective + flush; }
};

CycleEstimate estimate_cycles(const hw::UnitConfig& config, const FrameLoad& load);

}  // namespace artu::sim
