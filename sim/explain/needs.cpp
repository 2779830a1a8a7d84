#include "sim/explain/needs.h"

#include <algorithm>
#include <map>

#include "hw/ray_core/pipelines.h"

namespace artu::sim {

double WorkCounts::rays() const {
  double rays = 0;
  for (const char* kind : {"primary_rays", "shadow_rays", "reflection_rays", "refraction_rays"}) {
    rays += of("core.ray_generator", kind);
  }
  return rays;
}

double WorkCounts::unevenness(const std::string& block_of_core, const std::string& name) const {
  double sum = 0, most = 0, copies = 0;
  for (const hw::Statistic& s : statistics_) {
    if (s.name != name || s.block.compare(0, 4, "core") != 0) continue;
    const std::size_t dot = s.block.find('.');
    if (dot == std::string::npos || s.block.substr(dot + 1) != block_of_core) continue;
    sum += static_cast<double>(s.value);
    most = std::max(most, static_cast<double>(s.value));
    ++copies;
  }
  return sum == 0 ? 1 : most * copies / sum;
}

std::vector<double> WorkCounts::l2_banks() const {
  std::map<std::string, double> banks;
  for (const hw::Statistic& s : statistics_) {
    if (s.block != "l2" && s.block.compare(0, 7, "l2_bank") != 0) continue;
    // A miss takes the port when it comes and when it is answered.
    for (const char* name : {"reads", "writes", "fills", "merged_misses"}) {
      if (s.name == name) banks[s.block] += static_cast<double>(s.value);
    }
  }
  std::vector<double> cycles;
  for (const auto& [name, of_bank] : banks) cycles.push_back(of_bank);
  return cycles;
}

namespace {

double port(const WorkCounts& work, const char* block) {
  return work.of(block, "reads") + work.of(block, "fills") + work.of(block, "merged_misses");
}

/// Cycles of the passes in which the DRAM cannot but work: less what it may have done in the other phases.
void need_dram(const WorkCounts& work, const hw::UnitConfig& unit, const Accounting& a, double& buses, double& rows) {
  const hw::DramConfig& dram = unit.memory.dram;
  const double ratio = static_cast<double>(unit.clock_mhz) / dram.clock_mhz, channels = dram.channels;
  const double accesses = work.of("dram", "reads") + work.of("dram", "writes");
  if (accesses == 0) return;
  const double all = work.of("dram", "bus_clocks") * ratio / channels, line = all / accesses;
  const double built = work.of("tree_builder", "lines_read") + work.of("tree_builder", "lines_written");
  const double elsewhere = std::min(a.flush, all) + (a.builder_overlaps ? 0 : std::min(a.build, built * line));
  buses = std::max(all - elsewhere, 0.0);
  // Rows are opened t_rrd apart and four in t_faw; a bank is taken for t_ras and t_rp.
  const double activates = work.of("dram", "activates") * ratio / channels * (buses / all);
  rows = activates * std::max({dram.t_faw / 4.0, static_cast<double>(dram.t_rrd),
                               static_cast<double>(dram.t_ras + dram.t_rp) / dram.banks});
}

double need_box_testers(const WorkCounts& work, const hw::UnitConfig& unit) {
  const hw::RayCoreConfig& core = unit.core;
  return std::max((work.of("core.traversal", "node_visits") + work.rays()) * core.node_interval,
                  work.of("core.traversal", "box_tests") / core.box_testers);
}

/// A candidate a cycle, a line a cycle, and four spans that wait for theirs at a time.
double need_extractor(const WorkCounts& work, const hw::UnitConfig& unit) {
  const double wait = 2 + unit.selective.pixel_cache.hit_latency;
  return std::max({work.of("candidate_pixel_extractor", "candidates"), port(work, "pixel_cache"),
                   work.of("candidate_pixel_extractor", "spans") * wait / 4});
}

}  // namespace

std::array<double, resource_count> needs_of(const WorkCounts& work, const hw::UnitConfig& unit, const Accounting& a) {
  std::array<double, resource_count> needs{};
  const auto set = [&](Resource resource, double cycles) { needs[static_cast<std::size_t>(resource)] = cycles; };
  const hw::RayCoreConfig& core = unit.core;
  const double cores = core.count, rays = work.rays();
  const double visits = work.of("core.traversal", "node_visits");
  set(Resource::box_testers, need_box_testers(work, unit) / cores);
  set(Resource::traversal_steps,
      (visits + work.of("core.traversal", "leaves") + work.of("core.traversal", "dropped") + rays) / cores);
  set(Resource::triangle_testers, work.of("core.intersection", "triangle_tests") * core.triangle_interval / cores);
  set(Resource::hit_points, 2 * work.of("core.hit_point", "hit_points") / cores);
  // A light a cycle, and a cycle at least for each hit and each shadow ray that is back.
  const double shadows = work.of("core.ray_generator", "shadow_rays");
  set(Resource::shading,
      (std::max(work.of("core.shading", "lights"), work.of("core.shading", "hits_shaded") + shadows) +
       work.of("core.shading", "sky")) /
          cores);
  set(Resource::node_caches, port(work, "core.node_cache") / cores);
  set(Resource::triangle_caches, port(work, "core.triangle_cache") / cores);
  set(Resource::texture_caches, port(work, "core.texture_cache") / cores);
  // What the builder asks of the L2 is asked before the passes, what the write-back does passes its ports by.
  const double built =
      a.builder_overlaps ? 0 : 2 * work.of("tree_builder", "lines_read") + work.of("tree_builder", "lines_written");
  const double all_banks = port(work, "l2") + work.of("l2", "writes");
  if (all_banks != 0) {
    const std::vector<double> banks = work.l2_banks();
    // How evenly other banks than the run's would share it, nobody knows.
    const double busiest = banks.size() == unit.memory.l2_banks
                               ? *std::max_element(banks.begin(), banks.end()) / all_banks
                               : 1.0 / unit.memory.l2_banks;
    set(Resource::l2_banks, std::max(all_banks - built, 0.0) * busiest);
  }
  double buses = 0, rows = 0;
  need_dram(work, unit, a, buses, rows);
  set(Resource::dram_buses, buses);
  set(Resource::dram_rows, rows);
  set(Resource::dispatcher, work.of("dispatcher", "pixels"));
  set(Resource::extractor, need_extractor(work, unit));
  set(Resource::frame_writer, work.of("frame_writer", "pixels"));
  set(Resource::in_flight, pipeline_cycles(work, unit) / (cores * core.contexts));
  return needs;
}

double pipeline_cycles(const WorkCounts& work, const hw::UnitConfig& unit) {
  const hw::Pipelines p(unit.operators);
  const hw::RayCoreConfig& core = unit.core;
  // Of two kinds of trees the faster one.
  const std::uint32_t node = std::min(p.node(unit.accel.static_kind), p.node(unit.accel.dynamic_kind));
  const double triangle = core.triangle_cache.hit_latency, texture = core.texture_cache.hit_latency;
  const double hits = work.of("core.hit_point", "hit_points");
  double cycles = work.of("core.ray_generator", "primary_rays") * p.generate + work.rays() * (p.set_up + p.box);
  cycles += work.of("core.traversal", "node_visits") * (1 + core.node_cache.hit_latency + node);
  cycles += work.of("core.traversal", "leaves") * (2 + triangle + p.triangle);
  cycles += hits * (2 + triangle + p.hit_point + 2 + texture + p.texture + p.accumulate + p.light);
  cycles += work.of("core.shading", "textured") * (1 + texture);
  cycles += work.of("core.ray_generator", "shadow_rays") * (1 + p.accumulate + p.light);
  cycles += work.of("core.shading", "sky") * (1 + p.accumulate);
  return cycles;
}

}  // namespace artu::sim
