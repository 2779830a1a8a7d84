// The frame with every pixel ray traced: what a picture should be, and what it shows where.
#pragma once

#include <cstdint>
#include <vector>

#include "hw/pixel_record.h"
#include "ref/golden.h"
#include "sim/driver/frame_outcome.h"
#include "sim/report/image.h"

namespace artu::sim {

struct FullRender {
  Image image;
  std::vector<hw::HitClass> classes;  // of each pixel's primary ray, row by row; never `none`
};

/// Of a frame that was simulated, or rendered by the golden model, without selective rendering.  The two are equal to
/// the bit; the golden model is faster, the unit knows its cycles.
FullRender full_render_of(const FrameOutcome& outcome);
FullRender full_render_of(const ref::Result& golden);

}  // namespace artu::sim
