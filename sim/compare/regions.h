// How far pictures are from the full render, for the whole frame and for what the frame shows: moving things, things
// that stand still, and nothing.
#pragma once

#include <array>
#include <cstdint>

#include "sim/compare/full_render.h"

namespace artu::sim {

enum class Area : std::uint8_t { whole, dynamic_geometry, static_geometry, background };
inline constexpr std::size_t area_count = 4;
inline constexpr const char* area_names[area_count] = {"all", "dynamic", "static", "background"};

/// Which of the three a pixel belongs to.
Area area_of(hw::HitClass hit_class);

/// Sums over the pixels of an area, of any number of frames.
struct AreaError {
  std::uint64_t pixels = 0;
  std::uint64_t squares = 0;  // of the differences, over all channels
  std::uint64_t windows = 0;  // of SSIM, whose centre lies in the area
  double similarity = 0;      // sum of their SSIM
  double flip = 0;            // sum of FLIP

  /// In dB from the mean of the squares of all frames; infinity where nothing differs, NaN without a pixel.
  double psnr() const;
  /// Means; NaN without a window, or a pixel.
  double mean_ssim() const;
  double mean_flip() const;
};

struct Errors {
  std::array<AreaError, area_count> areas;  // by Area

  const AreaError& of(Area area) const { return areas[static_cast<std::size_t>(area)]; }
  /// A frame's picture, of the full render's size.
  void add(const FullRender& full, const Image& image);
  void add(const Errors& others);
};

}  // namespace artu::sim
