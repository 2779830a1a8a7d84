#include "sim/analytic/cycle_model.h"

#include <algorithm>
#include <cmath>

#include "sim/analytic/constants.h"
#include "sim/analytic/pass_demand.h"

namespace artu::sim {
namespace {

double joined(double a, double b) {
  if (a + b <= 0) return 0;
  return std::pow(std::pow(a, calibrated.norm) + std::pow(b, calibrated.norm), 1 / calibrated.norm);
}

std::array<std::uint32_t, 3> l1_mshrs(const hw::UnitConfig& config) {
  return {config.core.node_cache.mshrs, config.core.triangle_cache.mshrs, config.core.texture_cache.mshrs};
}

/// Cycles in which the cores trace their pixels, whatever becomes of them.
double tracing_time(const hw::UnitConfig& config, const PassDemand& demand) {
  if (demand.traced <= 0) return 0;
  const double customers = demand.cores * config.core.contexts;
  const DramService dram(config, demand.dram);
  const double dram_time = demand.fills / dram.most(), hit = l2_latency(config);
  double fetched = 0;
  for (const double lines : demand.fetched) fetched += lines;
  const double l2_misses = fetched == 0 ? 0 : std::min(demand.fills / fetched, 1.0);

  double time = std::max(calibrated.delay * demand.delay / customers, dram_time);
  for (const Station& station : demand.stations) time = std::max(time, station.demand);
  // How long a miss takes depends on the load of the DRAM, and that on the time: a few rounds are enough.
  for (int round = 0; round < 6; ++round) {
    const double miss = hit + l2_misses * dram.response(std::min(demand.fills / time, dram.most()));
    std::vector<Station> stations = demand.stations;
    double delay = calibrated.delay * demand.delay;
    // A fetch holds an MSHR until its line is there: several servers, each as slow as a miss (Seidmann, Schweitzer and
    // Shalev-Oren 1987).
    const std::array<std::uint32_t, 3> mshrs = l1_mshrs(config);
    for (std::size_t i = 0; i < mshrs.size(); ++i) {
      stations.push_back({"misses", demand.fetched[i] / demand.cores * miss / mshrs[i], demand.cores});
      delay += demand.fetched[i] * hit * (mshrs[i] - 1) / mshrs[i];
    }
    stations.push_back({"DRAM", dram_time, 1});
    delay += demand.fills * std::max(dram.alone() - 1 / dram.most(), 0.0);
    const double next = closed_network(stations, delay, customers, demand.traced, calibrated.queueing);
    time = round == 0 ? next : (time + next) / 2;
  }
  return time;
}

/// What each resource needs for the passes on its own.
std::vector<CycleBound> bounds_of(const hw::UnitConfig& config, const PassDemand& demand) {
  std::vector<CycleBound> bounds;
  for (const Station& station : demand.stations) bounds.push_back({station.name, station.demand});
  const DramService dram(config, demand.dram);
  bounds.push_back({"DRAM buses", (demand.dram.reads + demand.dram.writes) * bus_cycles(config)});
  bounds.push_back({"L2 misses", demand.fills / dram.most()});
  double fetched = 0;
  for (const double lines : demand.fetched) fetched += lines;
  const double l2_misses = fetched == 0 ? 0 : std::min(demand.fills / fetched, 1.0);
  const double miss = l2_latency(config) + l2_misses * dram.alone();
  static const char* const names[] = {"node cache misses", "triangle cache misses", "texture cache misses"};
  for (std::size_t i = 0; i < demand.fetched.size(); ++i) {
    bounds.push_back({names[i], demand.fetched[i] / demand.cores * miss / l1_mshrs(config)[i]});
  }
  bounds.push_back({"candidate extractor", demand.candidates});
  bounds.push_back({"frame writer", demand.written});
  const double contexts = demand.cores * config.core.contexts;
  bounds.push_back({"latency", (calibrated.delay * demand.delay + fetched * miss) / contexts});
  return bounds;
}

}  // namespace

CycleEstimate estimate_cycles(const hw::UnitConfig& config, const FrameLoad& load) {
  CycleEstimate estimate;
  estimate.start = 25 + 5.0 * static_cast<double>(load.descriptor_lines);
  estimate.build = static_cast<double>(load.build.cycles);
  const double cores = config.core.count / load.imbalance;
  const PassDemand all(config, load.all, cores), first(config, load.first, cores);
  PassDemand rest = all;
  rest -= first;
  const auto time_of = [&](const PassDemand& demand, double& tracing) {
    tracing = tracing_time(config, demand);
    return joined(tracing, demand.written);
  };
  const double contexts = cores * config.core.contexts;
  const double latency = all.traced == 0 ? 0 : all.delay / all.traced;
  const double filled = all.traced / (all.traced + contexts);  // a frame of few pixels never fills them
  const double tail = (calibrated.tail + calibrated.tail_latencies * latency) * filled;
  double first_tracing = 0, rest_tracing = 0;
  const double first_time = time_of(first, first_tracing);
  if (config.selective.overlaps() || rest.written == 0) {
    const double passes = time_of(all, estimate.tracing) + tail;
    estimate.first = rest.written == 0 ? passes : std::min(first_time, passes);
    estimate.selective = passes - estimate.first;
  } else {
    estimate.first = first_time + tail;
    estimate.selective = time_of(rest, rest_tracing) + calibrated.apart_latencies * latency;
    estimate.tracing = first_tracing + rest_tracing;
  }
  // Rays that need the tree wait for it, with their contexts: what else could begin is little.
  if (config.tree_builder.overlap) {
    estimate.first += estimate.build;
    estimate.build = 0;
  }
  estimate.bounds = bounds_of(config, all);
  // A line leaves in the time of its data, as long as nothing else is under way.
  estimate.flush = static_cast<double>(load.dirty_lines) * bus_cycles(config) * calibrated.bus + l2_latency(config);
  return estimate;
}

}  // namespace artu::sim
