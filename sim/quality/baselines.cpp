#include "sim/quality/baselines.h"

#include <algorithm>

namespace artu::sim {
namespace {

/// Mean of codes of one channel, rounded half up.
class Mean {
 public:
  void add(std::uint8_t code) { sum_ += code, ++count_; }
  std::uint8_t value() const { return static_cast<std::uint8_t>((2 * sum_ + count_) / (2 * count_)); }

 private:
  std::uint32_t sum_ = 0, count_ = 0;
};

template <class ValueOf>
Image made(const Image& full, ValueOf value_of) {
  Image image = full;
  for (std::uint32_t y = 0; y < full.height; ++y) {
    for (std::uint32_t x = 0; x < full.width; ++x) {
      for (std::uint32_t c = 0; c < 3; ++c) {
        const auto code = [&](std::uint32_t i, std::uint32_t j) {
          return full.rgb[3 * (std::size_t{j} * full.width + i) + c];
        };
        image.rgb[3 * (std::size_t{y} * full.width + x) + c] = value_of(x, y, code);
      }
    }
  }
  return image;
}

}  // namespace

Image checkerboard(const Image& full) {
  if (full.width == 1 && full.height == 1) return full;
  return made(full, [&](std::uint32_t x, std::uint32_t y, auto code) -> std::uint8_t {
    if ((x + y) % 2 == 0) return code(x, y);
    Mean mean;
    if (x > 0) mean.add(code(x - 1, y));
    if (x + 1 < full.width) mean.add(code(x + 1, y));
    if (y > 0) mean.add(code(x, y - 1));
    if (y + 1 < full.height) mean.add(code(x, y + 1));
    return mean.value();
  });
}

Image low_resolution(const Image& full) {
  return made(full, [&](std::uint32_t x, std::uint32_t y, auto code) {
    const auto right = [&](std::uint32_t v, std::uint32_t size) {
      return v % 2 == 0 || v + 1 == size ? v / 2 * 2 : v + 1;
    };
    const std::uint32_t x0 = x / 2 * 2, x1 = right(x, full.width), y0 = y / 2 * 2, y1 = right(y, full.height);
    Mean mean;
    for (const std::uint32_t j : {y0, y1}) {
      for (const std::uint32_t i : {x0, x1}) mean.add(code(i, j));
    }
    return mean.value();
  });
}

std::uint64_t checkerboard_pixels(std::uint32_t width, std::uint32_t height) {
  return (std::uint64_t{width} * height + 1) / 2;
}

std::uint64_t low_resolution_pixels(std::uint32_t width, std::uint32_t height) {
  return std::uint64_t{(width + 1) / 2} * ((height + 1) / 2);
}

}  // namespace artu::sim
