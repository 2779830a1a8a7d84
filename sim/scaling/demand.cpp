#include "sim/scaling/demand.h"

#include <algorithm>

#include "hw/memory/build_plan.h"
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
  // A miss takes the port when it comes and when it is answered.
  const auto cache = [&](const char* name) { return count(name, "reads") + count(name, "misses"); };
  const double l2 = count("l2", "reads") + count("l2", "writes") + count("l2", "fills") + count("l2", "merged_misses");
  double rays = 0;  // each begins with the box of the scene
  for (const char* kind : {"primary_rays", "shadow_rays", "reflection_rays", "refraction_rays"}) {
    rays += count("core.ray_generator", kind);
  }
  const double nodes = std::max((count("core.traversal", "node_visits") + rays) * unit.core.node_interval,
                                count("core.traversal", "box_tests") / unit.core.box_testers);
  const double dram_clocks = cycles * unit.memory.dram.clock_mhz / unit.clock_mhz;
  // With overlap the build is no phase of its own, but no frame ends before it.
  double build = count("control_unit", "cycles_build");
  if (unit.tree_builder.overlap) {
    for (const char* stage : hw::stage_counters) build += count("tree_builder", stage);
  }
  const double serial = count("control_unit", "cycles_start") + build + count("control_unit", "cycles_flush");
  return {
      {"box testers", nodes / of_cores},
      {"triangle testers", count("core.intersection", "triangle_tests") * unit.core.triangle_interval / of_cores},
      {"node caches", cache("core.node_cache") / of_cores},
      {"triangle caches", cache("core.triangle_cache") / of_cores},
      {"texture caches", cache("core.texture_cache") / of_cores},
      {"L2", l2 / (cycles * unit.memory.l2_banks)},
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
