// Which pixels are finished, for passes that overlap: a counter a tile.
//
// A pixel is finished when the L2 has its colour and its hit class; each counts one.  A single counter for all passes
// is enough: a span of a pass opens only when its own tile has finished all passes before, so that the counter goes
// through the passes of a tile in their order.  Hardware: an SRAM of `bytes`, whose words hold the counters of a line's
// tiles.
#pragma once

#include <array>
#include <vector>

#include "hw/memory/cache.h"
#include "hw/memory/layout.h"
#include "hw/selective/pass_plan.h"

namespace artu::hw {

/// Pixels that are looked at, corners included.
struct Area {
  std::uint32_t left, right, top, bottom;
};

class Scoreboard {
 public:
  Scoreboard(const PassPlan& plan, std::uint32_t tile) : plan_(plan), tile_(tile) {}

  void begin(const FrameDescriptor& frame);
  /// Pixels of a line that have arrived in the L2.
  void count(const LineWritten& written);
  /// Whether all passes before this one are finished in all tiles that the area touches.
  bool finished_before(std::uint32_t pass, const Area& area) const;
  /// Of the counters that this frame needs.
  std::uint64_t bytes() const;
  /// Changes with every count.
  std::uint64_t version() const { return version_; }

 private:
  void add(std::uint32_t x, std::uint32_t y) { ++counts_[y / tile_ * columns_ + x / tile_]; }

  const PassPlan plan_;
  const std::uint32_t tile_;
  FrameDescriptor frame_{};
  std::uint32_t columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> counts_;
  // For each pass, the count that all passes before it make: of whole tiles, and of those of the last column and row.
  std::vector<std::array<std::uint32_t, 4>> full_;
  std::uint64_t version_ = 0;
};

}  // namespace artu::hw
