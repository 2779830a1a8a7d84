// Starts pixels in free contexts and sets up every ray.
//
// In:  pixels to trace; contexts whose next ray is ready for set-up (from shading); contexts that are free again.
// Out: rays to traversal, primary ones and others on channels of their own.
// Latency: generate + set_up for primary rays, set_up for others.  Initiation interval 1.  With `ray_order`
// secondary-first next rays go first, so that pixels in flight finish before others begin; with primary-first new
// pixels do, as long as contexts are free; with first-come they take turns.
// Stalls: stall_in without work or without a free context.  Its output never fills: there is room for all contexts.
#pragma once

#include "hw/fabric/fifo.h"
#include "hw/frame_registers.h"
#include "hw/ray_core/ray_context.h"

namespace artu::hw {

class RayGenerator : public Block {
 public:
  RayGenerator(sc_core::sc_module_name name, ClockDomain& domain, const FrameRegisters& registers,
               RayContexts& contexts, const PrecisionConfig& precision = {}, RayOrder order = RayOrder::secondary_first)
      : Block(name, domain), registers_(registers), contexts_(contexts), hit_tests_(precision), order_(order) {}
  void bind(Fifo<PixelJob>& jobs, Fifo<Slot>& next_rays, Fifo<Slot>& freed, Fifo<Slot>& primary, Fifo<Slot>& others) {
    jobs_ = &jobs;
    next_rays_ = &next_rays;
    freed_ = &freed;
    primary_ = &primary;
    others_ = &others;
  }

  void reset() override;
  void report(Statistics& out) const override;
  std::string describe() const override;
  std::uint64_t rays(RayKind kind) const { return rays_[static_cast<std::size_t>(kind)]; }

 private:
  Activity tick(Cycle now) override;
  void start(Slot slot, const PixelJob& job);
  bool pixel_goes_first() const;
  void next_ray(Cycle now);
  void new_pixel(Cycle now);

  const FrameRegisters& registers_;
  RayContexts& contexts_;
  const HitTests hit_tests_;
  const RayOrder order_;
  bool pixel_was_last_ = false;
  Fifo<PixelJob>* jobs_ = nullptr;
  Fifo<Slot>* next_rays_ = nullptr;
  Fifo<Slot>* freed_ = nullptr;
  Fifo<Slot>* primary_ = nullptr;
  Fifo<Slot>* others_ = nullptr;
  std::vector<Slot> free_;
  std::array<std::uint64_t, ray_kinds> rays_{};
};

}  // namespace artu::hw
