// What the selective blocks hand on.
#pragma once

#include "hw/datapath/selective.h"

namespace artu::hw {

/// From the control unit: a pass to be worked through, or with overlap all selective passes.
struct PassCommand {
  std::uint8_t pass = 0;    // 0 first rendering, then the selective passes (hw/selective/pass_plan.h)
  std::uint8_t stride = 1;  // pass 0: distance of the sampling pixels, 1 = every pixel
  std::uint8_t last = 0;    // with overlap the last of the passes; otherwise 0
};

/// A candidate pixel on its way: 32 bits position, 6 pass, 8 x 27 ring (the pairs are four of its colours), then 8
/// counts, then 8 threshold.
struct Candidate : Evidence {
  std::uint8_t pass = 0;
  std::uint8_t threshold = 0;
};

}  // namespace artu::hw
