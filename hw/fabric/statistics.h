// A named number of a block, as reports print it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace artu::hw {

/// `block` is the instance ("core0.traversal", "l2", "dram"), `name` the counter, e.g. "busy" or "hits".
/// The five cycle classes of every block are named busy, stall_in, stall_out, stall_mem, idle.
struct Statistic {
  std::string block;
  std::string name;
  std::uint64_t value = 0;
  std::string unit;  // "cycles", "bytes", "rays", "" ...
  std::string text;  // one line for the reader
};

using Statistics = std::vector<Statistic>;

}  // namespace artu::hw
