// Lays a scene and its frames down in the unit's memory.
#pragma once

#include <string>

#include "hw/memory/image.h"
#include "sim/driver/tree.h"
#include "traces/frame.h"

namespace artu::sim {

class ImageBuilder {
 public:
  /// What the frames share: frame buffer, materials, textures, static geometry and its tree.
  ImageBuilder(const traces::Scene& scene, const hw::AccelConfig& accel, hw::MemoryImage& image);

  /// Lays the frame down after it (over the frame before); returns the address of its descriptor.
  hw::Address add(const traces::Frame& frame);

  /// Entries of a traversal's stack that the last frame's trees need at most.
  std::uint32_t stack_needed() const { return stack_needed_; }

 private:
  struct Geometry {
    Tree tree;  // its nodes and order are empty once they are in the image
    std::uint32_t node_lines = 0, references = 0;
    hw::Address nodes = 0, triangles = 0, attributes = 0;
  };
  hw::Address add_materials(const std::vector<hw::Address>& textures);
  hw::Address add_texture(const traces::Texture& texture);
  Geometry add_geometry(const traces::Mesh& mesh, hw::TreeKind kind, bool dynamic, std::uint32_t first_id,
                        const std::string& where);

  const traces::Scene& scene_;
  const hw::AccelConfig accel_;
  hw::MemoryImage& image_;
  std::uint32_t pitch_;
  hw::Address frame_buffer_ = 0, hit_classes_ = 0, materials_ = 0;
  Geometry static_;
  std::uint64_t shared_top_ = 0;
  std::uint32_t stack_needed_ = 0;
};

}  // namespace artu::sim
