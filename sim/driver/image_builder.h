// Lays a scene and its frames down in the unit's memory.
#pragma once

#include <string>

#include "sim/driver/dynamic_trees.h"
#include "sim/driver/geometry_image.h"
#include "sim/driver/static_trees.h"
#include "sim/driver/tree_quality.h"
#include "traces/frame.h"

namespace artu::sim {

class ImageBuilder {
 public:
  /// What the frames share: frame buffer, room for spilled stacks, materials, textures, static geometry and its tree.
  /// `frames` is needed for refit alone; the tree comes from `trees` where there are any.
  ImageBuilder(const traces::Scene& scene, const hw::UnitConfig& unit, FrameFrom frames, hw::MemoryImage& image,
               StaticTrees* trees = nullptr);

  /// Lays the frame down after it (over the frame before); returns the address of its descriptor.
  hw::Address add(const traces::Frame& frame);

  /// Entries of a traversal's stack that the last frame's trees need at most.
  std::uint32_t stack_needed() const { return stack_needed_; }
  /// Of the last frame's tree.
  const TreeQuality& dynamic_quality() const { return dynamic_quality_; }

 private:
  hw::Address add_materials(const std::vector<hw::Address>& textures);
  hw::Address add_texture(const traces::Texture& texture);

  const traces::Scene& scene_;
  DynamicTrees dynamic_trees_;
  hw::MemoryImage& image_;
  std::uint32_t pitch_;
  hw::Address frame_buffer_ = 0, hit_classes_ = 0, stack_spills_ = 0, materials_ = 0;
  LaidGeometry static_;
  std::uint64_t shared_top_ = 0;
  std::uint32_t stack_needed_ = 0;
  TreeQuality dynamic_quality_;
};

}  // namespace artu::sim
