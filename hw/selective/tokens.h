// What the selective blocks hand on.
#pragma once

#include "hw/datapath/selective.h"

namespace artu::hw {

/// From the control unit: a pass to be worked through.
struct PassCommand {
  std::uint8_t pass = 0;    // 0 first rendering, 1 horizontal, 2 vertical
  std::uint8_t stride = 1;  // pass 0: distance of the sampling pixels, 1 = every pixel
};

/// A candidate pixel on its way; 32 bits position, 16 neighbours, 48 pair, then 8 counts, then 8 threshold.
struct Candidate {
  std::uint16_t x = 0, y = 0;
  std::uint8_t pass = 0;
  bool pair = false;  // both pixels of the pair are inside the image
  Rgb a, b;           // their colours
  std::array<HitClass, 8> neighbours{};
  HitCounts counts;
  std::uint8_t threshold = 0;
};

}  // namespace artu::hw
