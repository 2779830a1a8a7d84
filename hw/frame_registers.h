// What the control unit has read from the frame descriptor, held in registers that all blocks see.
#pragma once

#include <vector>

#include "hw/datapath/shading.h"
#include "hw/memory/layout.h"
#include "hw/pixel_record.h"

namespace artu::hw {

/// Phases of a frame, as bits: which blocks have a part in what is going on.
enum Phase : unsigned { phase_start = 1, phase_build = 2, phase_first = 4, phase_selective = 8, phase_flush = 16 };

struct FrameRegisters {
  FrameDescriptor descriptor{};
  ShadingConstants shading{};
  std::vector<LightRecord> lights;
};

inline constexpr std::uint32_t maximum_lights = 64;

}  // namespace artu::hw
