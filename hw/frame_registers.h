// What the control unit has read from the frame descriptor, held in registers that all blocks see.
#pragma once

#include <vector>

#include "hw/datapath/shading.h"
#include "hw/fabric/phase.h"
#include "hw/memory/layout.h"
#include "hw/pixel_record.h"

namespace artu::hw {

struct FrameRegisters {
  FrameDescriptor descriptor{};
  ShadingConstants shading{};
  std::vector<LightRecord> lights;
};

inline constexpr std::uint32_t maximum_lights = 64;

}  // namespace artu::hw
