// A colour of a picture, and pictures made of others.
#pragma once

#include <cstdint>

#include "sim/report/image.h"

namespace artu::sim {

struct Color {
  std::uint8_t r, g, b;
};

/// One colour everywhere.
Image blank(std::uint32_t width, std::uint32_t height, Color color);
/// Outside the picture: nothing happens.
void set_pixel(Image& image, std::uint32_t x, std::uint32_t y, Color color);
/// Puts `part` into `image`, its upper left corner at (x, y).
void paste(Image& image, const Image& part, std::uint32_t x, std::uint32_t y);

}  // namespace artu::sim
