// Where the cycles go: each block's five cycle classes in percent.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "hw/fabric/statistics.h"

namespace artu::sim {

struct CycleShares {
  std::string block;                // "core.traversal" stands for that block of every core
  std::array<double, 5> percent{};  // busy, stall_in, stall_out, stall_mem, idle; their sum is 100
};

/// Blocks without any of the five counters are left out.
std::vector<CycleShares> cycle_shares(const hw::Statistics& statistics);

std::string format_cycle_table(const hw::Statistics& statistics);

/// "core3.traversal" -> "core.traversal", "l2_bank1" -> "l2"; other names stay.
std::string without_number(const std::string& block);

}  // namespace artu::sim
