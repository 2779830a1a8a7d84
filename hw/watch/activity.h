// What can be seen of a frame from outside: for writers of traces (docs/viewers.md).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hw/datapath/pixel_rays.h"
#include "hw/fabric/block.h"
#include "hw/fabric/timeline.h"

namespace artu::hw {

/// Where a ray is.  It is fetching while lines that it has asked for are not all there.
enum class RayStage : std::uint8_t {
  set_up,           // generation and set-up, in ray_generator's pipeline
  traversal_queue,  // before traversal: it has not begun, or its leaf is tested
  traversal,        // box tests and steps; waiting for spilled entries or the dynamic tree, too
  node_fetch,
  intersection_queue,
  intersection,
  triangle_fetch,
  hit_point_queue,
  hit_point,
  surface_fetch,
  shading_queue,
  shading,
  texture_fetch,   // material and texels
  generator_queue  // the pixel's next ray waits for its set-up
};
inline constexpr std::size_t ray_stages = 14;

struct RayStageName {
  const char* name;
  const char* abbreviation;  // two letters
};
RayStageName name_of(RayStage stage);

/// A ray from its set-up until its pixel's next ray is set up, or the pixel leaves the core.
struct RayInFlight {
  static constexpr std::uint64_t none = ~std::uint64_t{0};
  std::uint64_t number = 0;     // in the order of the set-ups in the frame
  std::uint64_t before = none;  // of the same pixel
  std::uint32_t core = 0;
  std::uint16_t slot = 0, x = 0, y = 0;
  RayKind kind = RayKind::primary;
};

/// What there is to be seen; numbers of blocks and channels are their places here.
struct ActivityLayout {
  struct SeenBlock {
    std::string path;
    Tick period = 1;
  };
  struct SeenChannel {
    std::string name;
    std::uint32_t capacity = 0;
  };
  std::vector<SeenBlock> blocks;
  std::vector<SeenChannel> channels;
  std::uint32_t cores = 0;
  Tick unit_period = 1;         // ticks in a cycle of the unit
  std::uint32_t clock_mhz = 1;  // of the unit
};

/// Is told what changes, in the order of time: at a tick first the phase, then blocks, channels and rays, each in the
/// order of their numbers.  At the beginning of the window it is told everything.  Must not throw.
class ActivitySink {
 public:
  virtual ~ActivitySink() = default;
  virtual void begin(const ActivityLayout& layout, Tick tick) = 0;
  virtual void phase(Tick tick, unsigned phase) {}
  virtual void state(Tick tick, std::size_t block, State state) {}
  /// Entries, those on their way included, once all that happens at the tick has happened.
  virtual void level(Tick tick, std::size_t channel, std::uint32_t entries) {}
  virtual void ray_begins(Tick tick, const RayInFlight& ray) {}
  virtual void ray_enters(Tick tick, const RayInFlight& ray, RayStage stage) {}
  /// `cut`: it would go on, but the window ends.
  virtual void ray_ends(Tick tick, const RayInFlight& ray, bool cut) {}
  /// The end of the window, or of the frame.
  virtual void end(Tick tick) = 0;
};

/// Half-open, in cycles of the unit.
struct ActivityWindow {
  Cycle from = 0, to = never;
};

}  // namespace artu::hw
