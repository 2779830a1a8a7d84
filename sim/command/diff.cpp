#include <fmt/format.h>

#include <cmath>

#include "sim/command/commands.h"
#include "sim/compare/flip.h"
#include "sim/compare/image_metrics.h"
#include "traces/error.h"

namespace artu::sim {

int diff_command(const std::string& a, const std::string& b) {
  const Image image_a = read_png(a), image_b = read_png(b);
  if (image_a.width != image_b.width || image_a.height != image_b.height) {
    throw InputError(b, fmt::format("is {}x{} and {} is {}x{}; pictures of one size would be right", image_b.width,
                                    image_b.height, a, image_a.width, image_a.height));
  }
  const ImageDifference d = compare_images(image_a, image_b);
  fmt::print("PSNR                {}\n", std::isinf(d.psnr) ? "infinite" : fmt::format("{:.2f} dB", d.psnr));
  fmt::print("SSIM                {}\n",
             std::isnan(d.ssim) ? "not defined (smaller than its 11x11 window)" : fmt::format("{:.6f}", d.ssim));
  fmt::print("FLIP                {:.6f}\n", flip_of(image_a, image_b));
  fmt::print("largest difference  {}\n", d.largest);
  fmt::print("pixels that differ  {} of {} ({:.3f} %)\n", d.differing, d.pixels,
             100.0 * static_cast<double>(d.differing) / static_cast<double>(d.pixels));
  return exit_fine;
}

}  // namespace artu::sim
