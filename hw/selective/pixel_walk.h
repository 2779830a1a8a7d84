// The order in which the first pass visits its pixels: tiles row by row; in a tile rows, or a Morton curve (Morton
// 1966), along which pixels that follow each other stay near each other in both directions.
#pragma once

#include "hw/selective/tile_walk.h"
#include "hw/unit_config.h"

namespace artu::hw {

/// Visits every `stride`-th pixel of every `stride`-th row once; at least one pixel.
class PixelWalk {
 public:
  PixelWalk() = default;
  PixelWalk(PixelOrder order, std::uint32_t width, std::uint32_t height, std::uint32_t tile, std::uint32_t stride)
      : order_(order), width_(width), height_(height), tile_(tile), stride_(stride) {
    if (order_ == PixelOrder::rows) {
      rows_ = TileWalk(width, height, tile, 0, stride, 0, stride);
      x_ = rows_.span().begin;
      y_ = rows_.span().y;
    }
  }

  bool done() const { return done_; }
  std::uint32_t x() const { return x_; }
  std::uint32_t y() const { return y_; }
  void next() {
    if (order_ == PixelOrder::rows) {
      next_in_row();
    } else {
      do {
        next_on_curve();
      } while (!done_ && (x_ >= width_ || y_ >= height_));
    }
  }

 private:
  void next_in_row() {
    x_ += stride_;
    if (x_ < rows_.span().end) return;
    rows_.next();
    done_ = rows_.done();
    if (done_) return;
    x_ = rows_.span().begin;
    y_ = rows_.span().y;
  }
  /// The even bits of n.
  static std::uint32_t even_bits(std::uint32_t n) {
    n &= 0x55555555u;
    n = (n | n >> 1) & 0x33333333u;
    n = (n | n >> 2) & 0x0f0f0f0fu;
    n = (n | n >> 4) & 0x00ff00ffu;
    return (n | n >> 8) & 0x0000ffffu;
  }
  void next_on_curve() {
    const std::uint32_t cells = tile_ / stride_;
    if (++index_ == cells * cells) {
      index_ = 0;
      tile_x_ += tile_;
      if (tile_x_ >= width_) {
        tile_x_ = 0;
        tile_y_ += tile_;
      }
      done_ = tile_y_ >= height_;
    }
    x_ = tile_x_ + even_bits(index_) * stride_;
    y_ = tile_y_ + even_bits(index_ >> 1) * stride_;
  }

  PixelOrder order_ = PixelOrder::rows;
  std::uint32_t width_ = 0, height_ = 0, tile_ = 1, stride_ = 1;
  TileWalk rows_;
  std::uint32_t tile_x_ = 0, tile_y_ = 0, index_ = 0;
  std::uint32_t x_ = 0, y_ = 0;
  bool done_ = false;
};

}  // namespace artu::hw
