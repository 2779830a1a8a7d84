// The order in which pixels are visited: tile by tile, rows within a tile, from left to right.
#pragma once

#include <algorithm>
#include <cstdint>

namespace artu::hw {

/// Visits rows y0, y0 + dy, ... in tiles of the given edge; in each row a span of one tile's width.
class TileWalk {
 public:
  struct Span {
    std::uint32_t y, begin, end;  // pixels begin, begin + dx, ... < end
  };

  TileWalk() = default;
  TileWalk(std::uint32_t width, std::uint32_t height, std::uint32_t tile, std::uint32_t x0, std::uint32_t dx,
           std::uint32_t y0, std::uint32_t dy)
      : width_(width), height_(height), tile_(tile), x0_(x0), dx_(dx), y0_(y0), dy_(dy), y_(y0) {
    settle();
  }

  bool done() const { return done_; }
  Span span() const {
    // Tiles are even and dx divides them, so each tile's first pixel has the same phase.
    return {y_, tile_x_ + x0_, std::min(tile_x_ + tile_, width_)};
  }
  std::uint32_t dx() const { return dx_; }
  void next() {
    y_ += dy_;
    settle();
  }
  /// How many pixels the walk visits in all.
  std::uint64_t pixels() const {
    const std::uint64_t columns = width_ > x0_ ? (width_ - x0_ + dx_ - 1) / dx_ : 0;
    const std::uint64_t rows = height_ > y0_ ? (height_ - y0_ + dy_ - 1) / dy_ : 0;
    return columns * rows;
  }

 private:
  /// Moves on to a row and tile that have a pixel.
  void settle() {
    for (;;) {
      if (y_ < std::min(tile_y_ + tile_, height_) && tile_x_ + x0_ < width_) return;
      tile_x_ += tile_;
      if (tile_x_ + x0_ >= width_) {
        tile_x_ = 0;
        tile_y_ += tile_;
      }
      if (tile_y_ >= height_ || x0_ >= width_) {
        done_ = true;
        return;
      }
      y_ = tile_y_ + y0_;
    }
  }

  std::uint32_t width_ = 0, height_ = 0, tile_ = 1, x0_ = 0, dx_ = 1, y0_ = 0, dy_ = 1;
  std::uint32_t tile_x_ = 0, tile_y_ = 0, y_ = 0;
  bool done_ = false;
};

}  // namespace artu::hw
