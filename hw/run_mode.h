// How the unit is run, and falsified on purpose: no part of the chip.
#pragma once

#include <cstdint>

namespace artu::hw {

/// How the unit is run: no part of the chip.
struct RunMode {
  bool clocked = false;        // tick every block in every cycle
  bool shuffle = false;        // random order of blocks within a cycle
  bool random_stall = false;   // random latency on every channel
  std::uint64_t seed = 1;
};

/// Datapaths whose result can be falsified, to show that the golden comparison sees it; and the DRAM, an answer of
/// which can be lost, to show that the dead-lock is.
enum class Datapath : std::uint8_t { none, box, triangle, shading, interpolation, threshold, dram };

/// The bit of the datapath's result that is inverted in every operation; the number of the DRAM's answer that is lost.
struct Fault {
  Datapath datapath = Datapath::none;
  std::uint32_t bit = 0;
};

}  // namespace artu::hw
