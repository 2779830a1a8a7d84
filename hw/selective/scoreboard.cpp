#include "hw/selective/scoreboard.h"

namespace artu::hw {

void Scoreboard::begin(const FrameDescriptor& frame) {
  frame_ = frame;
  columns_ = (frame.width + tile_ - 1) / tile_;
  rows_ = (frame.height + tile_ - 1) / tile_;
  counts_.assign(std::size_t{columns_} * rows_, 0);
  full_.assign(1, {});
  const std::uint32_t last_width = frame.width - (columns_ - 1) * tile_;
  const std::uint32_t last_height = frame.height - (rows_ - 1) * tile_;
  for (std::uint32_t pass = 0; pass + 1 < plan_.passes(); ++pass) {
    std::array<std::uint32_t, 4> next = full_.back();
    for (std::size_t i = 0; i < next.size(); ++i) {
      // A tile begins at a multiple of every stride: its pixels lie like those of an image of its size.
      const TileWalk walk =
          plan_.walk(pass, (i & 1) != 0 ? last_width : tile_, (i & 2) != 0 ? last_height : tile_, tile_);
      next[i] += 2 * static_cast<std::uint32_t>(walk.pixels());
    }
    full_.push_back(next);
  }
  version_ = 0;
}

void Scoreboard::count(const LineWritten& written) {
  const bool classes = written.line >= frame_.hit_classes &&
                       written.line < frame_.hit_classes + std::uint64_t{frame_.pitch} * frame_.height;
  const std::uint64_t index = classes ? written.line - frame_.hit_classes : (written.line - frame_.frame_buffer) / 4;
  const auto y = static_cast<std::uint32_t>(index / frame_.pitch), x = static_cast<std::uint32_t>(index % frame_.pitch);
  const std::uint32_t bytes_a_pixel = classes ? 1 : 4;
  for (std::uint32_t i = 0; i < line_bytes / bytes_a_pixel; ++i) {
    if ((written.bytes >> (i * bytes_a_pixel) & 1) != 0) add(x + i, y);
  }
  ++version_;
}

bool Scoreboard::finished_before(std::uint32_t pass, const Area& area) const {
  for (std::uint32_t row = area.top / tile_; row <= area.bottom / tile_; ++row) {
    for (std::uint32_t column = area.left / tile_; column <= area.right / tile_; ++column) {
      const std::size_t shape = (column + 1 == columns_ ? 1u : 0u) | (row + 1 == rows_ ? 2u : 0u);
      if (counts_[row * columns_ + column] < full_[pass][shape]) return false;
    }
  }
  return true;
}

std::uint64_t Scoreboard::bytes() const {
  // The count before the last pass is less than twice the pixels of a tile.
  std::uint64_t bits = 1;
  while ((2 * std::uint64_t{tile_} * tile_ - 1) >> bits != 0) ++bits;
  return (counts_.size() * bits + 7) / 8;
}

}  // namespace artu::hw
