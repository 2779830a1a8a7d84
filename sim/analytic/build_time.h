// How long a tree's build takes, step by step: its computing, or its traffic.
#pragma once

#include <array>

#include "hw/memory/build_plan.h"
#include "sim/analytic/memory_model.h"

namespace artu::sim {

struct BuildTime {
  std::uint64_t cycles = 0;                              // of the unit's clock
  std::uint64_t lines = 0;                               // read and written
  std::uint64_t dram = 0;                                // lines between L2 and DRAM
  std::array<std::uint64_t, hw::build_stages> stages{};  // of `cycles`
};

/// Of a frame whose dynamic geometry has triangles; its lines go through `memory`, which keeps the last of them.
BuildTime build_time(const hw::UnitConfig& config, const hw::FrameDescriptor& frame, MemoryModel& memory);

}  // namespace artu::sim
