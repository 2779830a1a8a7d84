// Lays a scene and its frames down in the unit's memory.
#pragma once

#include <string>

#include "sim/driver/geometry_image.h"
#include "traces/frame.h"

namespace artu::sim {

class ImageBuilder {
 public:
  /// What the frames share: frame buffer, room for the stacks of so many contexts to spill to, materials, textures,
  /// static geometry and its tree.
  ImageBuilder(const traces::Scene& scene, const hw::AccelConfig& accel, hw::MemoryImage& image,
               std::uint32_t spilling_contexts = 0);

  /// Lays the frame down after it (over the frame before); returns the address of its descriptor.
  hw::Address add(const traces::Frame& frame);

  /// Entries of a traversal's stack that the last frame's trees need at most.
  std::uint32_t stack_needed() const { return stack_needed_; }

 private:
  hw::Address add_materials(const std::vector<hw::Address>& textures);
  hw::Address add_texture(const traces::Texture& texture);

  const traces::Scene& scene_;
  const hw::AccelConfig accel_;
  hw::MemoryImage& image_;
  std::uint32_t pitch_;
  hw::Address frame_buffer_ = 0, hit_classes_ = 0, stack_spills_ = 0, materials_ = 0;
  LaidGeometry static_;
  std::uint64_t shared_top_ = 0;
  std::uint32_t stack_needed_ = 0;
};

}  // namespace artu::sim
