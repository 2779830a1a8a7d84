// What costs as little as selective rendering and knows nothing of the picture: computed from the full render's pixels.
#pragma once

#include "sim/report/image.h"

namespace artu::sim {

/// Every other pixel (x + y even) is the full render's; the others are the mean of their 4 neighbours, or of those that
/// there are at the border, rounded half up.
Image checkerboard(const Image& full);

/// A quarter of the pixels (x and y even, the sampling pixels) is the full render's; the others are interpolated
/// between the nearest of them, linearly along each axis.  Beyond the last one its value goes on.
Image low_resolution(const Image& full);

/// Pixels of the full render that each takes.
std::uint64_t checkerboard_pixels(std::uint32_t width, std::uint32_t height);
std::uint64_t low_resolution_pixels(std::uint32_t width, std::uint32_t height);

}  // namespace artu::sim
