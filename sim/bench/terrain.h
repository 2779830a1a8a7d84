// A scene of as many triangles as one likes: hills, seen from above at an angle, so that rays meet all of them.
#pragma once

#include <cstdint>

#include "traces/frame.h"

namespace artu::sim {

/// Static, edge * edge * 2 triangles; the same hills with any number.
traces::Scene terrain(std::uint32_t edge, std::uint32_t width, std::uint32_t height);
/// Its only frame: a camera and a light that casts shadows.
traces::Frame terrain_frame(std::uint32_t width, std::uint32_t height);

}  // namespace artu::sim
