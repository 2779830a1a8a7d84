#include "sim/report/color.h"

namespace artu::sim {

Image blank(std::uint32_t width, std::uint32_t height, Color color) {
  Image image{width, height, {}};
  image.rgb.reserve(std::size_t{3} * width * height);
  for (std::size_t i = 0; i < std::size_t{width} * height; ++i) {
    image.rgb.insert(image.rgb.end(), {color.r, color.g, color.b});
  }
  return image;
}

void set_pixel(Image& image, std::uint32_t x, std::uint32_t y, Color color) {
  if (x >= image.width || y >= image.height) return;
  std::uint8_t* pixel = &image.rgb[3 * (std::size_t{y} * image.width + x)];
  pixel[0] = color.r;
  pixel[1] = color.g;
  pixel[2] = color.b;
}

void paste(Image& image, const Image& part, std::uint32_t x, std::uint32_t y) {
  for (std::uint32_t row = 0; row < part.height; ++row) {
    for (std::uint32_t column = 0; column < part.width; ++column) {
      const std::uint8_t* p = &part.rgb[3 * (std::size_t{row} * part.width + column)];
      set_pixel(image, x + column, y + row, {p[0], p[1], p[2]});
    }
  }
}

}  // namespace artu::sim
