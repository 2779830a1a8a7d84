#include "sim/analytic/pass_demand.h"

#include <algorithm>

#include "hw/ray_core/pipelines.h"

namespace artu::sim {
namespace {

double number(std::uint64_t n) { return static_cast<double>(n); }
double all(std::uint64_t sampled) { return static_cast<double>(sampled * sample_factor); }

double rays_of(const hw::FunctionalCounts& counts) {
  double rays = 0;
  for (const std::uint64_t kind : counts.rays) rays += number(kind);
  return rays;
}

/// A shadow ray's leaf is fetched before its first hit is known.
double tests_of(const hw::FunctionalCounts& counts) { return number(counts.triangles + counts.left_out); }

/// Latencies of all steps of all pixels, as the blocks' headers have them.
double delay_of(const hw::UnitConfig& config, const hw::FunctionalCounts& c) {
  const hw::Pipelines p(config.operators);
  const hw::RayCoreConfig& core = config.core;
  const double leaves = number(c.leaves);
  // Of two kinds of trees the slower one.
  const std::uint32_t node = std::max(p.node(config.accel.static_kind), p.node(config.accel.dynamic_kind));
  double cycles = number(c.rays[0]) * p.generate + rays_of(c) * (p.set_up + p.box + 3);
  cycles += number(c.nodes) * (node + core.node_cache.hit_latency + 3);
  cycles += leaves * (core.triangle_cache.hit_latency + p.triangle + 4) + std::max(tests_of(c) - leaves, 0.0);
  cycles += number(c.hit_points) * (core.triangle_cache.hit_latency + p.hit_point + core.texture_cache.hit_latency +
                                    p.texture + p.accumulate + p.light + p.next_ray + 6);
  cycles += number(c.textured) * (core.texture_cache.hit_latency + 4);
  cycles += number(c.rays[1]) * (p.accumulate + p.light + 1) + number(c.sky) * (p.accumulate + 1);
  return cycles;
}

}  // namespace

double l2_latency(const hw::UnitConfig& config) {
  return 2.0 * config.memory.interconnect_latency + config.memory.l2.hit_latency + 2;
}

PassDemand::PassDemand(const hw::UnitConfig& config, const Load& load, double busy_cores) : cores(busy_cores) {
  const hw::FunctionalCounts& c = load.counts;
  const hw::RayCoreConfig& core = config.core;
  const double banks = config.memory.l2_banks;
  const double rays = rays_of(c), nodes = number(c.nodes);
  const double rounds = std::max(nodes * core.node_interval + rays, number(c.boxes) / core.box_testers);
  traced = number(c.sampled + c.traced);
  candidates = number(c.candidates);
  written = number(c.sampled + c.candidates);
  stations = {
      {"ray generators", rays / cores, cores},
      {"box testers", rounds / cores, cores},
      {"traversal steps", (nodes + number(c.leaves + c.dropped) + rays) / cores, cores},
      {"triangle testers", tests_of(c) * core.triangle_interval / cores, cores},
      {"hit points", 2 * number(c.hit_points) / cores, cores},
      {"shading", number(c.lights + c.sky + c.hit_points) / cores, cores},
      {"texture caches", number(load.requests.texture_lines) / cores, cores},
      {"dispatcher", traced, 1},
      {"L2 banks", all(load.memory.l2_reads + load.memory.l2_writes) / banks, banks},
  };
  delay = delay_of(config, c);
  for (std::size_t i = 0; i < fetched.size(); ++i) fetched[i] = all(load.memory.client[i].misses);
  fills = all(load.memory.l2_fills);
  dram = {fills, all(load.memory.l2_write_backs), all(load.memory.row_misses)};
}

PassDemand& PassDemand::operator-=(const PassDemand& part) {
  const auto take = [](double& from, double amount) { from = std::max(from - amount, 0.0); };
  take(traced, part.traced);
  take(written, part.written);
  take(candidates, part.candidates);
  for (std::size_t i = 0; i < stations.size(); ++i) take(stations[i].demand, part.stations[i].demand);
  take(delay, part.delay);
  for (std::size_t i = 0; i < fetched.size(); ++i) take(fetched[i], part.fetched[i]);
  take(fills, part.fills);
  take(dram.reads, part.dram.reads);
  take(dram.writes, part.dram.writes);
  take(dram.row_misses, part.dram.row_misses);
  return *this;
}

}  // namespace artu::sim
