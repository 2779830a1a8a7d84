// How far two pictures are apart.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/report/image.h"

namespace artu::sim {

struct ImageDifference {
  double psnr = 0;              // dB over all channels, peak 255; infinity where the pictures are equal
  double ssim = 0;              // NaN where the picture is smaller than the window, 11 x 11
  unsigned largest = 0;         // of all channels of all pixels, 0 ... 255
  std::uint64_t differing = 0;  // pixels that differ in a channel
  std::uint64_t pixels = 0;
  std::uint64_t squares = 0;  // sum of squared differences over all channels
};

/// In dB with a peak of 255; infinity where `squares` is 0.
double psnr_of(std::uint64_t squares, std::uint64_t pixels);

inline constexpr std::uint32_t ssim_window = 11;

/// SSIM of every window that lies in the picture whole, row by row: (width - 10) x (height - 10), of which (x, y) is
/// the window around pixel (x + 5, y + 5).  Empty where the picture is smaller than the window.
std::vector<double> ssim_map(const Image& a, const Image& b);

/// Both must have one size.
///
/// SSIM is that of Wang, Bovik, Sheikh and Simoncelli (2004): Gaussian window of 11 x 11 with sigma 1.5, K1 = 0.01,
/// K2 = 0.03, L = 255, only where the whole window lies in the picture; the mean of R, G and B.
ImageDifference compare_images(const Image& a, const Image& b);

}  // namespace artu::sim
