// The unit without time: every pixel, decision and count that its blocks come to, one pixel after another.
//
// No SystemC and no blocks: what they compute is hw/datapath, hw/selective's rules and hw/functional's walk.  The
// counts are the blocks' own where those do not depend on time (docs/fidelity.md).
#pragma once

#include "hw/functional/counts.h"
#include "hw/functional/tap.h"
#include "hw/memory/image.h"
#include "hw/pixel_record.h"
#include "hw/unit_config.h"

namespace artu::hw {

class FunctionalUnit {
 public:
  /// `portable`: without SSE2, as on a machine that has none; the same bits.
  FunctionalUnit(const UnitConfig& config, MemoryImage& image, bool portable = false)
      : config_(config), image_(image), portable_(portable) {}

  /// Renders the frame whose descriptor lies there into the image; `records` has width * height entries as they begin.
  /// `stack_needed`: entries of a traversal's stack that the frame's trees need at most, no more than maximum_stack.
  FunctionalCounts run(Address descriptor, std::uint32_t stack_needed, PixelRecords& records) const;
  /// The same, and `tap` hears it: see NoTap.  Defined in render.h, for a listener of one's own.
  template <class Tap>
  FunctionalCounts run(Address descriptor, std::uint32_t stack_needed, PixelRecords& records, Tap& tap) const;

 private:
  const UnitConfig config_;
  MemoryImage& image_;
  const bool portable_;
};

}  // namespace artu::hw
