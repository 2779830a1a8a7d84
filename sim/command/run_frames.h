// One run of `artu run`, for whoever makes several: from loaded frames to the folder of the report.
#pragma once

#include <vector>

#include "sim/command/frame_source.h"
#include "sim/command/options.h"
#include "sim/command/run_report.h"
#include "sim/driver/static_trees.h"
#include "sim/report/memory_use.h"

namespace artu::sim {

struct RunResult {
  Totals sum;
  std::vector<std::uint32_t> simulated;  // frames, with `sampled`
  std::uint32_t different_frames = 0;    // the same: of all, equal ones once
  CheckResult check;
  bool lawful = true;  // no accounting law is violated
};

/// Simulates the frames that the options ask for and finishes the report; without a report only checks that scene, unit
/// and options fit together.  `shared_trees`: of the source's scene, where there are several runs; else null.
RunResult run_frames(const RunOptions& options, const hw::UnitConfig& unit, const FrameSource& source,
                     StaticTrees* shared_trees, MemoryMeter& memory, RunReport* report);

}  // namespace artu::sim
