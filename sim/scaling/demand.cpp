#include "sim/scaling/demand.h"

#include <algorithm>

#include "sim/report/counters.h"

namespace artu::sim {

namespace {
constexpr double full = 0.75;  // from here on a resource is said to be the limit
}

std::vector<Demand> demands(const Totals& totals, const hw::UnitConfig& unit) {
  const Counters counters(totals.statistics);
  const auto count = [&](const char* block, const char* name) { return static_cast<double>(counters.of(block, name)); };
  const auto cycles = static_cast<double>(totals.cycles);
  const double of_cores = cycles * unit.core.count;
  const auto cache = [&](const char* name) { return count(name, "reads") + count(name, "writes"); };
  const double nodes = std::max(count("core.traversal", "node_visits") * unit.core.node_interval,
                                count("core.traversal", "box_tests") / unit.core.box_testers);
  const double dram_clocks = cycles * unit.memory.dram.clock_mhz / unit.clock_mhz;
  const double serial = count("control_unit", "cycles_start") + count("control_unit", "cycles_build") +
                        count("control_unit", "cycles_flush");
  return {
      {"box testers", nodes / of_cores},
      {"triangle testers", count("core.intersection", "triangle_tests") * unit.core.triangle_interval / of_cores},
      {"node caches", cache("core.node_cache") / of_cores},
      {"triangle caches", cache("core.triangle_cache") / of_cores},
      {"texture caches", cache("core.texture_cache") / of_cores},
      {"L2", cache("l2") / (cycles * unit.memory.l2_banks)},
      {"DRAM buses", count("dram", "bus_clocks") / (dram_clocks * unit.memory.dram.channels)},
      {"candidate extractor", count("candidate_pixel_extractor", "candidates") / cycles},
      {"build, start and write-back", serial / cycles},
  };
}

std::vector<Demand> demands_if_known(const Totals& totals, const hw::UnitConfig& unit) {
  const bool known = totals.fidelity == Fidelity::analytic || is_exact(totals.fidelity);
  return known ? demands(totals, unit) : std::vector<Demand>();
}

Demand bottleneck(const std::vector<Demand>& demands) {
  return *std::max_element(demands.begin(), demands.end(),
                           [](const Demand& a, const Demand& b) { return a.share < b.share; });
}

double contexts_filled(const Totals& totals, const hw::UnitConfig& unit) {
  const Counters counters(totals.statistics);
  return static_cast<double>(counters.of("core.ray_generator", "context_cycles")) /
         (static_cast<double>(totals.cycles) * unit.core.count * unit.core.contexts);
}

std::string limit_of(const Totals& totals, const hw::UnitConfig& unit) {
  const Demand largest = bottleneck(demands(totals, unit));
  if (largest.share >= full) return largest.resource;
  return contexts_filled(totals, unit) >= full ? "latency" : "too few pixels in flight";
}

}  // namespace artu::sim
