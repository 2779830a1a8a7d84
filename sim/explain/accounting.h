// What the counters of a run say of where its cycles went: the phases, what was asked of every resource, how many of
// the places for what is under way were taken, and what the pixels waited for.
//
// Needs are lower bounds in the sense of Amdahl and of Roofline (Williams, Waterman and Patterson, CACM 2009): the
// passes cannot take fewer cycles than any of them.  What is under way follows from Little's law (Oper. Res. 1961):
// mean number = rate x time.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "hw/unit_config.h"
#include "sim/report/numbers.h"

namespace artu::sim {

/// What can be busy; `in_flight` is not a unit: as many pixels as there are contexts, each as long as its pipelines.
enum class Resource : std::uint8_t {
  box_testers,
  traversal_steps,
  triangle_testers,
  hit_points,
  shading,
  node_caches,
  triangle_caches,
  texture_caches,
  l2_banks,
  dram_buses,
  dram_rows,
  dispatcher,
  extractor,
  frame_writer,
  in_flight,
};
inline constexpr std::size_t resource_count = 15;
const char* name_of(Resource resource);

/// Places for what is under way.
enum class Place : std::uint8_t {
  contexts,
  node_misses,
  triangle_misses,
  texture_misses,
  pixel_misses,
  l2_misses,
  dram_reads,
};
inline constexpr std::size_t place_count = 7;
const char* name_of(Place place);

/// All in cycles of the unit's clock, summed over the frames.
struct Accounting {
  double cycles = 0;
  double start = 0, build = 0, first = 0, selective = 0, flush = 0;  // they add up to `cycles`
  double passes() const { return first + selective; }

  std::array<double, resource_count> needs{};  // of the passes
  double need(Resource resource) const { return needs[static_cast<std::size_t>(resource)]; }
  /// Share of the passes in which it works or, of the DRAM's buses, cannot: they turn round, or wait for a refresh.
  double share(Resource resource) const {
    const double lost = resource == Resource::dram_buses ? dram_lost : 0;
    return passes() == 0 ? 0 : (need(resource) + lost) / passes();
  }

  std::array<double, place_count> taken{};  // mean share of the places, 0 ... 1; of misses estimated
  double taken_of(Place place) const { return taken[static_cast<std::size_t>(place)]; }

  // The tree builder: its own time, which with tree_builder.overlap is more than the phase; of it the computing, and of
  // that what a split's sweep takes.
  double builder = 0, builder_computes = 0, builder_sweeps = 0;
  double builder_triangles = 0;
  bool builder_overlaps = false;
  double tree_waits = 0;  // rays that waited for the tree, with their contexts

  // Cycles that pixels were in the cores, summed over them, and of these: in pipelines at least, and on the way to the
  // L2 and to the DRAM and back about.
  double resident = 0, in_pipelines = 0, to_l2 = 0, to_dram = 0;
  double pixels = 0, rays = 0;

  double dram_lost = 0;         // between reads and writes, and for refreshes; of a channel, in the passes
  double dram_read_cycles = 0;  // of a read, in the controller and the part; mean
  double dram_idle_cycles = 0;  // the same if no other were there
  double row_hits = 0;          // share of the accesses
  double unevenness = 1;        // pixels of the core with the most over the mean

  double extractor_waits = 0;  // share of the passes in which the candidate extractor waits for the pixel cache
};

/// The counters of `event` or `clocked`.  With another `unit` than the run's: the needs of the same work there.
Accounting account(const Totals& totals, const hw::UnitConfig& unit);

}  // namespace artu::sim
