// Computes the surface at a ray's nearest hit: normals, texture coordinates, origins of the next rays.
//
// In:  rays with a hit, from traversal; the triangle and its attributes, two lines, through the triangle cache.
// Out: contexts to shading.
// Latency: `hit_point` from the second line's arrival.  One request a cycle, two a hit: initiation interval 2.
// Stalls: stall_mem when lines are awaited or the cache takes no request.  The output never fills.
#pragma once

#include "hw/fabric/memory_port.h"
#include "hw/frame_registers.h"
#include "hw/memory/image.h"
#include "hw/ray_core/ray_context.h"

namespace artu::hw {

class HitPoint : public Block {
 public:
  HitPoint(sc_core::sc_module_name name, ClockDomain& domain, const FrameRegisters& registers, const MemoryImage& image,
           RayContexts& contexts, const PrecisionConfig& precision = {})
      : Block(name, domain),
        registers_(registers),
        image_(image),
        contexts_(contexts),
        triangle_bits_(static_cast<int>(precision.triangle)) {}
  void bind(Fifo<Slot>& in, Fifo<Slot>& out, MemoryLink& triangles) {
    in_ = &in;
    out_ = &out;
    triangles_ = &triangles;
  }

  void reset() override;
  void report(Statistics& out) const override;

 private:
  Activity tick(Cycle now) override;
  Address triangle_of(const RayContext& context) const;
  Address attributes_of(const RayContext& context) const;
  void compute(RayContext& context);

  const FrameRegisters& registers_;
  const MemoryImage& image_;
  RayContexts& contexts_;
  const int triangle_bits_;
  Fifo<Slot>* in_ = nullptr;
  Fifo<Slot>* out_ = nullptr;
  MemoryLink* triangles_ = nullptr;
  bool second_ = false;  // the front ray's triangle is requested, its attributes are not
  std::uint32_t outstanding_ = 0;
  std::uint64_t hits_ = 0;
};

}  // namespace artu::hw
