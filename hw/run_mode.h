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

/// Datapaths whose result can be falsified, to show that the golden comparison sees it.
enum class Datapath : std::uint8_t { none, box, triangle, shading, interpolation, threshold };

/// A bit of the datapath's result that is inverted in every operation.
struct Fault {
  Datapath datapath = Datapath::none;
  std::uint32_t bit = 0;
};

}  // namespace artu::hw
