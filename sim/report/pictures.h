// The three pictures of a frame: what it shows, how each pixel came about, what its ray hit.
#pragma once

#include <cstdint>

#include "sim/driver/simulator.h"
#include "sim/report/image.h"

namespace artu::sim {

Image frame_picture(const FrameOutcome& outcome);

/// Interpolated dark blue; sampled in greys and traced in warm colours, by what the primary ray hit.
Image decision_picture(const FrameOutcome& outcome);

/// Dynamic red, static blue, miss grey, black where no ray was traced.
Image class_picture(const FrameOutcome& outcome);

struct Color {
  std::uint8_t r, g, b;
};

/// The legends of the two maps; README.md describes them.
Color decision_color(hw::Decision decision, hw::HitClass hit_class);
Color class_color(hw::HitClass hit_class);

}  // namespace artu::sim
