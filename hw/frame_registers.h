// What the control unit has read from the frame descriptor, held in registers that all blocks see.
#pragma once

#include <vector>

#include "hw/datapath/shading.h"
#include "hw/fabric/phase.h"
#include "hw/memory/image.h"
#include "hw/pixel_record.h"

namespace artu::hw {

/// Whether the dynamic tree is built in this frame.
inline bool builds(const FrameDescriptor& frame, const SkipConfig& skip) {
  return frame.dynamic_triangle_count != 0 && (frame.dynamic_moved != 0 || !skip.rebuild);
}

struct FrameRegisters {
  FrameDescriptor descriptor{};
  ShadingConstants shading{};
  std::vector<LightRecord> lights;
  SkipConfig skip;  // set once, with the unit

  bool builds() const { return hw::builds(descriptor, skip); }
};

inline constexpr std::uint32_t maximum_lights = 64;

inline void take_descriptor(const FrameDescriptor& frame, const ShadingConfig& shading, FrameRegisters& registers) {
  registers.descriptor = frame;
  registers.shading = {frame.ambient, frame.sky_nadir, frame.sky_zenith, shading.max_depth, shading.min_weight};
}

/// The lights that the descriptor in the registers points to.
inline void take_lights(const MemoryImage& image, FrameRegisters& registers) {
  registers.lights.clear();
  for (std::uint32_t i = 0; i < registers.descriptor.light_count; ++i) {
    registers.lights.push_back(image.at<LightRecord>(registers.descriptor.lights + i * sizeof(LightRecord)));
  }
}

}  // namespace artu::hw
