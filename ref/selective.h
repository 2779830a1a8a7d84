// Selective rendering (docs/selective-rendering.md): integers only, independent of how a pixel is traced.
#pragma once

#include <cstdint>
#include <vector>

#include "ref/golden.h"

namespace artu::ref {

struct Image {
  std::uint32_t width, height;
  std::vector<Pixel>& pixels;  // row by row

  Pixel& at(std::uint32_t x, std::uint32_t y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

/// The pass that renders a pixel: 0 sampling, 1 horizontal, 2 vertical.
inline std::uint8_t pass_of(std::uint32_t x, std::uint32_t y) { return y % 2 != 0 ? 2 : x % 2 != 0 ? 1 : 0; }

/// The threshold that the counts ask for, 8-bit codes.
int threshold_of(const Settings& settings, int n_static, int n_dynamic);

/// Fills in what is known of a candidate of pass 1 or 2 before any ray: counts, threshold, difference and decision,
/// and the colour if that is to interpolate.
void decide(const Settings& settings, const Image& image, std::uint32_t x, std::uint32_t y);

/// Renders the passes in their order; `trace(x, y, pixel)` ray traces a pixel and fills in colour and hit.
template <class Trace>
void render_passes(const Settings& settings, const Image& image, Trace&& trace) {
  const std::uint8_t passes = settings.selective ? 3 : 1;
  for (std::uint8_t pass = 0; pass < passes; ++pass) {
    for (std::uint32_t y = 0; y < image.height; ++y) {
      for (std::uint32_t x = 0; x < image.width; ++x) {
        if (settings.selective && pass_of(x, y) != pass) continue;
        Pixel& pixel = image.at(x, y);
        if (pass > 0) decide(settings, image, x, y);
        if (pixel.decision != Decision::interpolated) trace(x, y, pixel);
      }
    }
  }
}

}  // namespace artu::ref
