#include "sim/compare/regions.h"

#include <cmath>
#include <limits>

#include "sim/compare/flip.h"
#include "sim/compare/image_metrics.h"

namespace artu::sim {
namespace {

double mean(double sum, std::uint64_t count) {
  return count == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / static_cast<double>(count);
}

}  // namespace

Area area_of(hw::HitClass hit_class) {
  switch (hit_class) {
    case hw::HitClass::dynamic_geometry:
      return Area::dynamic_geometry;
    case hw::HitClass::static_geometry:
      return Area::static_geometry;
    default:
      return Area::background;
  }
}

double AreaError::psnr() const {
  return pixels == 0 ? std::numeric_limits<double>::quiet_NaN() : psnr_of(squares, pixels);
}
double AreaError::mean_ssim() const { return mean(similarity, windows); }
double AreaError::mean_flip() const { return mean(flip, pixels); }

void Errors::add(const Errors& others) {
  for (std::size_t i = 0; i < area_count; ++i) {
    areas[i].pixels += others.areas[i].pixels;
    areas[i].squares += others.areas[i].squares;
    areas[i].windows += others.areas[i].windows;
    areas[i].similarity += others.areas[i].similarity;
    areas[i].flip += others.areas[i].flip;
  }
}

void Errors::add(const FullRender& full, const Image& image) {
  const std::uint32_t width = image.width;
  const auto both = [&](std::size_t pixel, auto&& change) {
    change(areas[static_cast<std::size_t>(Area::whole)]);
    change(areas[static_cast<std::size_t>(area_of(full.classes[pixel]))]);
  };
  const std::vector<double> flips = flip_map(full.image, image);
  for (std::size_t i = 0; i < flips.size(); ++i) {
    std::uint64_t squares = 0;
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
      const int d = int{image.rgb[c]} - int{full.image.rgb[c]};
      squares += static_cast<std::uint64_t>(d * d);
    }
    both(i, [&](AreaError& area) {
      ++area.pixels;
      area.squares += squares;
      area.flip += flips[i];
    });
  }
  const std::vector<double> similarities = ssim_map(full.image, image);
  const std::size_t columns = similarities.empty() ? 1 : width - ssim_window + 1, half = ssim_window / 2;
  for (std::size_t i = 0; i < similarities.size(); ++i) {
    both((i / columns + half) * width + i % columns + half, [&](AreaError& area) {
      ++area.windows;
      area.similarity += similarities[i];
    });
  }
}

}  // namespace artu::sim
