// What a frame comes to, apart from time: the counters of the blocks that do not depend on it, under the same names.
#pragma once

#include <array>
#include <cstdint>

#include "hw/datapath/pixel_rays.h"
#include "hw/fabric/statistics.h"

namespace artu::hw {

struct FunctionalCounts {
  std::array<std::uint64_t, ray_kinds> rays{};
  // Traversal and intersection.
  std::uint64_t nodes = 0, boxes = 0, leaves = 0, pushes = 0, dropped = 0, dynamic_skipped = 0;
  std::uint64_t spilled_lines = 0, refilled_lines = 0, restarts = 0;
  std::uint64_t triangles = 0;  // of a shadow ray up to its first hit
  std::uint64_t left_out = 0;   // of a shadow ray's leaf behind its first hit: the blocks may test some of them
  // Hit point and shading.
  std::uint64_t hit_points = 0, sky = 0, lights = 0, lights_skipped = 0, textured = 0, textures_skipped = 0;
  // Selective rendering.
  std::uint64_t sampled = 0, candidates = 0, interpolated = 0, traced = 0, differences = 0;
  std::uint64_t static_neighbours = 0, dynamic_neighbours = 0, lowered = 0, raised = 0;

  /// The cores together, as block "core.traversal" and so on.
  void report(Statistics& out) const;
};

}  // namespace artu::hw
