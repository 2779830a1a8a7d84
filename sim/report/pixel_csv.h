// `--dump-pixels`: one row a pixel and frame, with the columns of docs/selective-rendering.md.
#pragma once

#include <string>

#include "sim/driver/frame_outcome.h"

namespace artu::sim {

/// The first line, with its end.
extern const char* const pixel_csv_header;

/// One row, with its end.
std::string pixel_csv_row(std::uint32_t frame, std::uint32_t x, std::uint32_t y, const hw::PixelRecord& pixel);

/// The rows of one frame, handed to `write` in pieces of a picture row.
template <class Write>
void pixel_csv_rows(const FrameOutcome& outcome, Write write) {
  std::string line;
  for (std::uint32_t y = 0; y < outcome.height; ++y) {
    line.clear();
    for (std::uint32_t x = 0; x < outcome.width; ++x) {
      line += pixel_csv_row(outcome.index, x, y, outcome.pixels.at(std::size_t{y} * outcome.width + x));
    }
    write(line);
  }
}

}  // namespace artu::sim
