// How fast the DRAM serves the lines that the L2 asks for, by how many of them wait at a time.
//
// The DRAM and its queues are a network of their own, of banks and buses, with as many customers as the L2 has MSHRs;
// to the rest of the unit it is one server whose rate depends on its load (flow-equivalent server: Chandy, Herzog and
// Woo, IBM J. R&D 1975).
#pragma once

#include <vector>

#include "hw/unit_config.h"

namespace artu::sim {

/// Lines between L2 and DRAM.
struct DramLoad {
  double reads = 0, writes = 0;
  double row_misses = 0;  // of both
};

class DramService {
 public:
  DramService(const hw::UnitConfig& config, const DramLoad& load);

  /// Reads a cycle with all of the L2's MSHRs waiting, at most.
  double most() const { return curve_.back().rate; }
  /// Cycles from asking for a line to having it: alone, and with so many reads a cycle.
  double alone() const { return 1 / curve_.front().rate; }
  double response(double rate) const;

 private:
  struct Point {
    double customers, rate;
  };
  std::vector<Point> curve_;  // by rising numbers
};

/// Cycles of the unit's clock that a line occupies one channel's data bus, over the channels: the DRAM's peak.
double bus_cycles(const hw::UnitConfig& config);

}  // namespace artu::sim
