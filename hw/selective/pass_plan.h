// The passes of a frame (docs/selective-rendering.md): which pixels each visits, how far its candidates look, and what
// they compare. Wires and shifters: it follows from the configuration alone.
#pragma once

#include "hw/datapath/selective.h"
#include "hw/selective/tile_walk.h"

namespace artu::hw {

struct Pass {
  std::uint32_t x0, dx, y0, dy;  // pixels x0, x0 + dx, ... of rows y0, y0 + dy, ...
  std::uint32_t h;               // distance of the neighbours; 0 in pass 0
  PassKind kind;                 // not of pass 0

  bool compares_rows() const { return kind != PassKind::vertical; }       // the pair left and right
  bool compares_columns() const { return kind != PassKind::horizontal; }  // the pair above and below
  /// Which of the ring's pixels earlier passes have finished, wherever in the pass: bit i for neighbour i.
  unsigned finished_neighbours() const {
    switch (kind) {
      case PassKind::horizontal:
        return 0x18;  // its row
      case PassKind::vertical:
        return 0xe7;  // the rows above and below
      case PassKind::centre:
        break;
    }
    return 0xff;
  }
};

class PassPlan {
 public:
  explicit PassPlan(const SelectiveConfig& config)
      : stride_(config.enabled ? config.stride : 1), a_level_(config.passes == Passes::average ? 3 : 2) {
    while (stride_ >> levels_ > 1) ++levels_;
  }

  /// Of the sampling pixels.
  std::uint32_t stride() const { return stride_; }
  /// Pass 0 among them.
  std::uint32_t passes() const { return 1 + levels_ * a_level_; }

  Pass pass(std::uint32_t number) const {
    if (number == 0) return {0, stride_, 0, stride_, 0, PassKind::horizontal};
    const std::uint32_t s = stride_ >> ((number - 1) / a_level_), h = s / 2;
    switch ((number - 1) % a_level_) {
      case 0:
        return {h, s, 0, s, h, PassKind::horizontal};
      case 1:
        return {0, a_level_ == 2 ? h : s, h, s, h, PassKind::vertical};
      default:
        return {h, s, h, s, h, PassKind::centre};
    }
  }

  /// The pass that finishes a pixel.
  std::uint32_t pass_of(std::uint32_t x, std::uint32_t y) const {
    for (std::uint32_t level = 0, s = stride_; s > 1; ++level, s /= 2) {
      if (x % s == 0 && y % s == 0) return level == 0 ? 0 : in_level(level, x, y, 2 * s);
    }
    return stride_ == 1 ? 0 : in_level(levels_, x, y, 2);
  }

  TileWalk walk(std::uint32_t number, std::uint32_t width, std::uint32_t height, std::uint32_t tile) const {
    const Pass p = pass(number);
    return {width, height, tile, p.x0, p.dx, p.y0, p.dy};
  }

 private:
  /// Of a pixel that the level with this number, from 1, finishes; `s` is its stride.
  std::uint32_t in_level(std::uint32_t level, std::uint32_t x, std::uint32_t y, std::uint32_t s) const {
    const bool between_columns = x % s != 0, between_rows = y % s != 0;
    const std::uint32_t first = 1 + (level - 1) * a_level_;
    if (!between_rows) return first;
    return first + (between_columns && a_level_ == 3 ? 2 : 1);
  }

  std::uint32_t stride_, a_level_, levels_ = 0;
};

}  // namespace artu::hw
