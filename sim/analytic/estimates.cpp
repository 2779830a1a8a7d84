#include "sim/analytic/estimates.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "sim/analytic/constants.h"
#include "sim/analytic/dram_service.h"

namespace artu::sim {
namespace {

std::uint64_t all(std::uint64_t sampled) { return sampled * sample_factor; }
std::uint64_t whole(double cycles) { return static_cast<std::uint64_t>(std::llround(cycles)); }

/// "DRAM buses" -> "dram_buses"
std::string counter_name(const std::string& name) {
  std::string out;
  for (const char c : name) {
    out += c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return out;
}

}  // namespace

hw::Statistics statistics_of(const hw::UnitConfig& config, const FrameLoad& load, const MemoryCounts& built,
                             const MemoryCounts& memory, const CycleEstimate& estimate) {
  hw::Statistics out;
  load.all.counts.report(out);
  const auto add = [&out](const char* block, const std::string& name, std::uint64_t value, const char* unit,
                          const std::string& text) {
    out.push_back({block, name, value, unit, text});
  };
  const auto cache = [&](const char* block, Client client, std::uint64_t reads) {
    const MemoryCounts::OfClient& count = memory.client[static_cast<std::size_t>(client)];
    const std::uint64_t misses = std::min(reads, all(count.misses + count.merged));
    add(block, "reads", reads, "", "read requests");
    add(block, "writes", 0, "", "write requests");
    add(block, "hits", reads - misses, "", "requests whose line was there: estimated");
    add(block, "misses", misses, "", "requests whose line was not there: estimated");
    add(block, "fills", all(count.misses), "lines", "lines fetched from below: estimated");
  };
  const RequestCounts& requests = load.all.requests;
  cache("core.node_cache", Client::node, load.all.counts.nodes + requests.second_node_lines);
  cache("core.triangle_cache", Client::triangle, requests.triangles);
  cache("core.texture_cache", Client::texture, requests.texture_lines);
  cache("pixel_cache", Client::pixel, requests.pixel_lines);
  const std::uint64_t l2 = all(memory.l2_reads + memory.l2_writes);
  add("l2", "reads", all(memory.l2_reads), "", "read requests: estimated");
  add("l2", "writes", all(memory.l2_writes), "", "write requests: estimated");
  const std::uint64_t l2_misses = std::min(l2, all(memory.l2_fills + memory.l2_merged + memory.l2_unfetched));
  add("l2", "hits", l2 - l2_misses, "", "requests whose line was there: estimated");
  add("l2", "misses", l2_misses, "", "requests whose line was not there: estimated");
  add("l2", "merged_misses", all(memory.l2_merged), "", "misses on a line that was already on its way: estimated");
  add("l2", "fills", all(memory.l2_fills), "lines", "lines fetched from DRAM: estimated");
  const std::uint64_t written = all(memory.l2_write_backs) + load.dirty_lines;
  add("dram", "read_bytes", all(memory.l2_fills) * 64, "bytes", "read from DRAM: estimated");
  add("dram", "write_bytes", written * 64, "bytes", "written to DRAM: estimated");
  const double clocks_of_a_line =
      bus_cycles(config) * config.memory.dram.channels * config.memory.dram.clock_mhz / config.clock_mhz;
  add("dram", "bus_clocks", whole(static_cast<double>(all(memory.l2_fills) + written) * clocks_of_a_line),
      "DRAM clocks", "data buses occupied, all channels: estimated");
  add("dram", "row_misses", all(memory.row_misses), "", "accesses to a bank without their row open: estimated");
  add("control_unit", "cycles_start", whole(estimate.start), "cycles", "phase: descriptor and lights: estimated");
  add("control_unit", "cycles_build", whole(estimate.build), "cycles", "phase: the dynamic tree's build: estimated");
  add("control_unit", "cycles_first", whole(estimate.first), "cycles", "phase: sampling pixels: estimated");
  add("control_unit", "cycles_selective", whole(estimate.selective), "cycles", "phase: candidates: estimated");
  add("control_unit", "cycles_flush", whole(estimate.flush), "cycles", "phase: the write-back: estimated");
  for (std::size_t i = 0; i < hw::build_stages; ++i) {
    add("tree_builder", hw::stage_counters[i], load.build.stages[i], "cycles", "of a stage of the build: estimated");
  }
  const double passes = estimate.first + estimate.selective;
  const double contexts = static_cast<double>(config.core.count) * config.core.contexts;
  add("core.ray_generator", "context_cycles", whole(contexts * std::min(estimate.tracing, passes)), "cycles",
      "pixels were in flight, summed over them: estimated");
  for (const CycleBound& bound : estimate.bounds) {
    add("bound", counter_name(bound.resource), whole(bound.cycles), "cycles",
        "the passes cannot take fewer, by what they ask of: " + bound.resource);
  }
  return out;
}

std::vector<Estimate> intervals_of(const FrameOutcome& outcome) {
  const auto interval = [](const char* name, const char* unit, std::uint64_t value, double low, double high) {
    const auto v = static_cast<double>(value);
    return Estimate{"", name, unit, v, v * low, v * high};
  };
  return {interval("cycles", "cycles", outcome.cycles, calibrated.cycles_low, calibrated.cycles_high),
          interval("dram.read_bytes", "bytes", outcome.dram_read_bytes, calibrated.read_low, calibrated.read_high),
          interval("dram.write_bytes", "bytes", outcome.dram_write_bytes, calibrated.write_low, calibrated.write_high)};
}

}  // namespace artu::sim
