#include "sim/explain/accounting.h"

#include <algorithm>

#include "hw/memory/build_plan.h"
#include "hw/ray_core/pipelines.h"
#include "sim/explain/needs.h"

namespace artu::sim {

const char* name_of(Resource resource) {
  static const char* const names[] = {
      "box testers", "traversal steps", "triangle testers",    "hit points",   "shading",
      "node caches", "triangle caches", "texture caches",      "L2 banks",     "DRAM buses",
      "DRAM rows",   "dispatcher",      "candidate extractor", "frame writer", "pixels in flight"};
  return names[static_cast<std::size_t>(resource)];
}

const char* name_of(Place place) {
  static const char* const names[] = {
      "contexts",   "node caches' MSHRs", "triangle caches' MSHRs", "texture caches' MSHRs", "pixel cache's MSHRs",
      "L2's MSHRs", "DRAM read queues"};
  return names[static_cast<std::size_t>(place)];
}

namespace {

/// Of an L1's miss that the L2 has: there and back, and the L2's own time.
double l2_cycles(const hw::UnitConfig& unit) {
  return 2.0 * unit.memory.interconnect_latency + unit.memory.l2.hit_latency + 2;
}

void account_dram_times(const WorkCounts& work, const hw::UnitConfig& unit, Accounting& a) {
  const hw::DramConfig& dram = unit.memory.dram;
  const double ratio = static_cast<double>(unit.clock_mhz) / dram.clock_mhz;
  const double reads = work.of("dram", "reads") + work.of("dram", "forwarded");
  const double accesses = work.of("dram", "reads") + work.of("dram", "writes");
  if (reads == 0 || accesses == 0) return;
  a.row_hits = work.of("dram", "row_hits") / accesses;
  const double misses = work.of("dram", "row_misses") / accesses, empty = work.of("dram", "row_empty") / accesses;
  const double data = work.of("dram", "bus_clocks") / accesses;
  const bool all_banks = dram.refresh == hw::RefreshPolicy::all_bank;
  const double lost = work.of("dram", "turns") / 2 * (dram.t_wtr_l + dram.t_cl + dram.t_turn) +
                      (all_banks ? work.of("dram", "refreshes") * dram.t_rfc : 0);
  a.dram_lost = lost * ratio / dram.channels * a.passes() / a.cycles;
  a.dram_read_cycles = work.of("dram", "read_clocks") / reads * ratio;
  // Rows are counted of reads and writes together: where writes find others' rows, reads alone would not be slower.
  a.dram_idle_cycles =
      std::min((dram.t_cl + data + misses * (dram.t_rp + dram.t_rcd) + empty * dram.t_rcd) * ratio, a.dram_read_cycles);
  // In the queue from its arrival to its column command.
  const double queued = std::max(work.of("dram", "read_clocks") - reads * (dram.t_cl + data), 0.0);
  const double clocks = a.cycles / ratio;
  a.taken[static_cast<std::size_t>(Place::dram_reads)] =
      std::min(queued / clocks / (static_cast<double>(dram.channels) * dram.queue_depth), 1.0);
}

/// Little's law: lines fetched, each for as long as a miss takes.
void account_places(const WorkCounts& work, const hw::UnitConfig& unit, Accounting& a) {
  const double passes = a.passes();
  if (passes == 0) return;
  const double l2_reads = work.of("l2", "reads");
  const double l2_misses =
      l2_reads == 0 ? 0 : std::min((work.of("l2", "fills") + work.of("l2", "merged_misses")) / l2_reads, 1.0);
  const double to_dram = a.dram_read_cycles + 4, miss = l2_cycles(unit) + l2_misses * to_dram;
  const auto set = [&](Place place, double taken, double places) {
    a.taken[static_cast<std::size_t>(place)] = std::min(taken / passes / places, 1.0);
  };
  const double cores = unit.core.count;
  a.resident = work.of("core.ray_generator", "context_cycles");
  set(Place::contexts, a.resident, cores * unit.core.contexts);
  double waits = 0;
  const auto cache = [&](Place place, const char* block, const hw::CacheConfig& config, double copies) {
    set(place, work.of(block, "fills") * miss, copies * config.mshrs);
    return work.of(block, "fills") + work.of(block, "merged_misses");
  };
  waits += cache(Place::node_misses, "core.node_cache", unit.core.node_cache, cores);
  waits += cache(Place::triangle_misses, "core.triangle_cache", unit.core.triangle_cache, cores);
  waits += cache(Place::texture_misses, "core.texture_cache", unit.core.texture_cache, cores);
  cache(Place::pixel_misses, "pixel_cache", unit.selective.pixel_cache, 1);
  // The builder's lines are fetched before the passes.
  const double builder = a.builder_overlaps ? 0 : work.of("tree_builder", "lines_read");
  set(Place::l2_misses, std::max(work.of("l2", "fills") - builder, 0.0) * to_dram, unit.memory.l2.mshrs);
  a.to_l2 = waits * l2_cycles(unit);
  a.to_dram = waits * l2_misses * to_dram;
}

void account_builder(const WorkCounts& work, const Totals& totals, const hw::UnitConfig& unit, Accounting& a) {
  for (const char* stage : hw::stage_counters) a.builder += work.of("tree_builder", stage);
  a.builder_triangles = work.of("tree_builder", "triangles");
  a.tree_waits = work.of("core.traversal", "tree_waits");
  a.builder_overlaps = unit.tree_builder.overlap;
  a.builder_computes = std::max(a.builder - work.of("tree_builder", "stall_mem"), 0.0);
  // A binary tree has one split less than leaves; the largest tree of any frame stands for all of them.
  const double splits = totals.dynamic_tree.leaves * work.of("tree_builder", "builds");
  if (unit.tree_builder.algorithm == hw::BuildAlgorithm::sah) {
    a.builder_sweeps = std::min(splits * unit.tree_builder.bins * unit.tree_builder.cycles_per_bin, a.builder_computes);
  }
}

}  // namespace

Accounting account(const Totals& totals, const hw::UnitConfig& unit) {
  const WorkCounts work(totals.statistics);
  Accounting a;
  a.cycles = static_cast<double>(totals.cycles);
  a.start = work.of("control_unit", "cycles_start");
  a.build = work.of("control_unit", "cycles_build");
  a.first = work.of("control_unit", "cycles_first");
  a.selective = work.of("control_unit", "cycles_selective");
  a.flush = work.of("control_unit", "cycles_flush");
  a.pixels = work.of("dispatcher", "pixels");
  a.rays = work.rays();
  account_builder(work, totals, unit, a);
  account_dram_times(work, unit, a);
  account_places(work, unit, a);
  a.in_pipelines = pipeline_cycles(work, unit);
  a.needs = needs_of(work, unit, a);
  a.unevenness = work.unevenness("shading", "pixels");
  if (a.passes() != 0) {
    a.extractor_waits = work.of("candidate_pixel_extractor", "stall_mem") / a.passes();
  }
  return a;
}

}  // namespace artu::sim
