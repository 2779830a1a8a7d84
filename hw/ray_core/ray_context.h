// The state of a pixel in flight in a ray core: its register file entry.
//
// A pixel has one ray in flight at a time, so its context is worked on by one block at a time: the one that holds
// the token with its number.  That is what keeps the order of the sums in docs/arithmetic.md section 7.
#pragma once

#include <array>
#include <vector>

#include "hw/datapath/hit_tests.h"
#include "hw/datapath/pixel_rays.h"
#include "hw/datapath/texture.h"
#include "hw/fabric/timeline.h"
#include "hw/pixel_record.h"
#include "hw/ray_core/ray_stack.h"

namespace artu::hw {

/// Token between the blocks of a core: the number of a context, 8 bits.
using Slot = std::uint16_t;

/// Token: the dynamic tree of the frame is built.
struct TreeBuilt {};

/// A pixel to trace: 16 + 16 bits.
struct PixelJob {
  std::uint16_t x = 0, y = 0;
};

/// What traversal needs at every step comes first, in as few cache lines of the host as it takes.
struct alignas(64) RayContext {
  // The ray in flight.
  Ray ray;
  RayKind kind = RayKind::primary;
  bool found = false, dynamic = false;
  std::uint8_t lines_left = 0;  // of the node that is being fetched

  // Traversal.
  Step next;  // node to visit; without one: pop
  TriangleHit best;
  std::uint8_t spills = 0;     // lines of the stack that the memory has not acknowledged
  bool awaits_spills = false;  // cannot go on before it has
  bool dynamic_last = false;   // the dynamic tree was being built when the ray began
  RayStack stack;
  std::uint32_t best_primitive = 0, best_triangle = 0, best_attributes = 0;
  std::uint64_t arrival = 0;  // when its set-up began

  // The pixel.
  PixelJob pixel;
  Cycle since = 0;  // when the pixel was taken
  Vector sum;       // colour so far
  Vector weight;
  std::uint8_t depth = 0;

  // Hit point and shading.
  std::uint8_t outstanding = 0;  // memory requests
  Surface surface;
  ShadedPoint point;
  Address material = 0;
  TextureFootprint footprint{};
  std::array<Address, 4> fetch{};
  std::uint8_t fetch_count = 0, fetch_issued = 0;
  bool texels_fetched = false;
  std::uint32_t light = 0;
  Vector contribution;  // of the light whose shadow ray is in flight
  PendingRays pending;
  Cycle finish_at = 0;  // when the pixel's last sum leaves the pipeline

  // The primary ray's hit, for the pixel's hit class and record.
  HitClass hit_class = HitClass::miss;
  std::uint32_t primary_primitive = 0, primary_t_bits = 0;
};

using RayContexts = std::vector<RayContext>;

}  // namespace artu::hw
