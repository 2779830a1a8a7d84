// The constants of `analytic` that are not the unit's: fitted to the cycles of `event` (docs/fidelity.md says on which
// scenes and units, and how far others are from it).
#pragma once

#include <cstdint>

namespace artu::sim {

struct Constants {
  // What closed_network takes.
  double queueing = 0.9;
  double dram_queueing = 1.1;
  // Of the latencies of a pixel's steps, which share that counts.
  double delay = 0.76;
  // Of the DRAM: bus time of a line over its data's, for turn-round and gaps; of a bank's time with another row what is
  // not hidden behind other banks; of the L2's MSHRs how many are filled where all wait, since a bank of it can run out
  // alone.
  double bus = 1.15, row_share = 0.3, l2_mshrs = 0.8;
  double build_bus = 1.15;  // the same as `bus`, of the tree builder's streams
  // Tracing and the pixels' own path (one pixel a cycle) join as a norm of this power.
  double norm = 1.7;
  // Cycles, and mean latencies of a pixel, from the first pixel to full contexts and from the last ones to the end;
  // where passes do not overlap so many more latencies.
  double tail = 300, tail_latencies = 3, apart_latencies = 6;
  // Between these times the estimate lie 95 % of the values of `event` that the rest was fitted to.
  double cycles_low = 0.88, cycles_high = 1.35;
  double read_low = 0.65, read_high = 1.15;
  double write_low = 0.65, write_high = 2.0;
};
inline constexpr Constants calibrated;
/// Of the pictures that they were fitted on: of smaller ones, more of the frame is what the model simplifies.
inline constexpr std::uint64_t calibrated_pixels = 320 * 180;

}  // namespace artu::sim
