// One ray core: ray generation, traversal, intersection, hit point, shading, and its three L1 caches.
//
// In:  pixels to trace.   Out: finished pixels; three memory links to the interconnect.
// Instantiates and binds; the blocks' headers say what each does.
#pragma once

#include <memory>
#include <vector>

#include "hw/memory/cache.h"
#include "hw/memory/interconnect.h"
#include "hw/ray_core/hit_point.h"
#include "hw/ray_core/intersection.h"
#include "hw/ray_core/ray_generator.h"
#include "hw/ray_core/shading.h"
#include "hw/ray_core/traversal.h"

namespace artu::hw {

/// What shows where the rays of a core are.
struct RayPaths {
  const RayContexts* contexts;
  const Fifo<Slot>*primary, *others, *tested, *hits, *misses, *shadows, *surfaces, *next_rays, *freed;
  const Fifo<LeafTask>* leaves;
  const MemoryLink *nodes, *triangles, *attributes, *texels;
};

class RayCore : public sc_core::sc_module {
 public:
  RayCore(sc_core::sc_module_name name, ClockDomain& domain, const UnitConfig& config, const FrameRegisters& registers,
          const MemoryImage& image, std::uint32_t number);

  /// Connects the L1 caches to the interconnect and the core to the dispatcher and the frame writer; `built` may be
  /// null.
  void bind(Interconnect& interconnect, Fifo<PixelJob>& jobs, Fifo<PixelToken>& pixels, Fifo<TreeBuilt>* built);

  /// All channels inside, for reset and for the picture of a dead-lock.
  const std::vector<Channel*>& channels() const { return channels_; }

  RayPaths ray_paths() const;

 private:
  const RayCoreConfig config_;
  const Pipelines pipelines_;
  RayContexts contexts_;

 public:
  RayGenerator ray_generator;
  Traversal traversal;
  Intersection intersection;
  HitPoint hit_point;
  Shading shading;
  Cache node_cache, triangle_cache, texture_cache;

 private:
  Fifo<Slot> primary_, others_, tested_, hits_, misses_, shadows_, surfaces_, next_rays_, freed_;
  Fifo<LeafTask> leaves_;
  MemoryLink nodes_, triangles_, attributes_, texels_;
  MemoryLink node_misses_, triangle_misses_, texture_misses_, spills_;
  std::vector<Channel*> channels_;
};

}  // namespace artu::hw
