// The pictures of a frame, pixel by pixel: what it shows, and what the unit did for each pixel.
#pragma once

#include <cstdint>

#include "sim/driver/frame_outcome.h"
#include "sim/report/color.h"

namespace artu::sim {

Image frame_picture(const FrameOutcome& outcome);

/// Interpolated dark blue; sampled in greys and traced in warm colours, by what the primary ray hit.
Image decision_picture(const FrameOutcome& outcome);

/// Dynamic red, static blue, miss grey, black where no ray was traced.
Image class_picture(const FrameOutcome& outcome);

/// code_heat of the threshold, and of the pair's colour difference; black where a pixel has none.
Image threshold_picture(const FrameOutcome& outcome);
Image difference_picture(const FrameOutcome& outcome);

/// cycles_heat from the dispatch of the pixel's job to its write; black where no ray was traced.
Image cycles_picture(const FrameOutcome& outcome);

/// The colours of the two maps; README.md describes them.
Color decision_color(hw::Decision decision, hw::HitClass hit_class);
Color class_color(hw::HitClass hit_class);

}  // namespace artu::sim
