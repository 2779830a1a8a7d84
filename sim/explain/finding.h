// What binds a run: one of these.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/explain/accounting.h"

namespace artu::sim {

/// In the words of the report.
enum class Bound : std::uint8_t {
  traversal,
  intersection,
  hit_points,
  shading,
  l1,
  l2,
  dram_bandwidth,
  dram_latency,
  l2_latency,
  pipeline_latency,
  queue_depth,
  candidate_extraction,
  frame_writer,
  dispatcher,
  uneven_cores,
  too_few_pixels,
  tree_build,
  start,
  write_back,
};
const char* name_of(Bound bound);

struct Finding {
  Bound bound{};
  double cycles = 0;     // of the run that it accounts for
  std::string evidence;  // "the box testers of 6 cores are needed in 93 % of the passes' cycles"
  Resource resource{};   // where it is one's throughput
  bool throughput = false;
  Place place{};  // where the places for what is under way are taken
};

/// From the decision list of docs/explain.md: first what binds most, then what ties with it, if anything does.  Never
/// empty.
std::vector<Finding> findings(const Accounting& account, const hw::UnitConfig& unit);

}  // namespace artu::sim
