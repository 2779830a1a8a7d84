// Shades hits and misses, asks for shadow rays light by light, sets up the next rays, finishes pixels.
//
// In:  surfaces from hit_point; misses and finished shadow rays from traversal; material and texels, in lines,
//      through the texture cache.
// Out: contexts with a ray to set up, to the ray generator; finished pixels to the frame writer; freed contexts.
// Latency to the next ray's set-up, with 1 for the channel: from a hit's last line `texture` + `accumulate`, from a
// shadow ray's return `accumulate`; then `light` and 1 for each light that is looked at; then, where no light sends a
// shadow ray, `next_ray`.  From a miss `accumulate`.  A pixel leaves after the same.
// Initiation interval: one cycle a light that is looked at, at least one; one line request a cycle, and two a material.
// Stalls: stall_mem when lines are awaited or the cache takes no request, stall_out when the frame writer is full.
#pragma once

#include "hw/fabric/memory_port.h"
#include "hw/frame_registers.h"
#include "hw/memory/frame_writer.h"
#include "hw/memory/image.h"
#include "hw/ray_core/pipelines.h"
#include "hw/ray_core/ray_context.h"

namespace artu::hw {

class Shading : public Block {
 public:
  Shading(sc_core::sc_module_name name, ClockDomain& domain, const FrameRegisters& registers, const MemoryImage& image,
          RayContexts& contexts, const Pipelines& pipelines, const PrecisionConfig& precision = {})
      : Block(name, domain),
        registers_(registers),
        image_(image),
        contexts_(contexts),
        pipelines_(pipelines),
        steps_(shading_steps(static_cast<int>(precision.shading))),
        fetch_queue_(contexts.size()),
        shade_queue_(contexts.size()),
        finish_queue_(contexts.size()) {}

  struct Ports {
    Fifo<Slot>* hits;
    Fifo<Slot>* misses;
    Fifo<Slot>* shadows;
    Fifo<Slot>* next_rays;
    Fifo<Slot>* freed;
    Fifo<PixelToken>* pixels;
    MemoryLink* memory;
  };
  void bind(const Ports& ports) { ports_ = ports; }
  void observe(PixelRecords* records) { records_ = records; }
  /// Fault injection: bits that every traced pixel's red code is xored with.
  void inject(std::uint8_t bits) { fault_ = bits; }

  void reset() override;
  void report(Statistics& out) const override;
  std::string describe() const override;

 private:
  /// Slots in order; never more than there are contexts.
  class SlotQueue {
   public:
    explicit SlotQueue(std::size_t slots) : ring_(slots) {}
    void clear() { head_ = tail_ = 0; }
    bool empty() const { return head_ == tail_; }
    Slot front() const { return ring_[head_ % ring_.size()]; }
    void push(Slot slot) { ring_[tail_++ % ring_.size()] = slot; }
    void pop() { ++head_; }
    std::size_t size() const { return tail_ - head_; }

   private:
    std::vector<Slot> ring_;
    std::size_t head_ = 0, tail_ = 0;
  };

  Activity tick(Cycle now) override;
  void want(RayContext& context, Address line);
  void fetch_material(Slot slot);
  bool fetch_texels(Slot slot);
  void answer(Slot slot);
  bool request(bool& blocked);
  bool finish_pixel();
  void shade(Slot slot, Cycle now);
  void lights(Slot slot, Cycle now, std::uint32_t latency);
  void next_ray(Slot slot, Cycle now, std::uint32_t latency);

  const FrameRegisters& registers_;
  const MemoryImage& image_;
  RayContexts& contexts_;
  const Pipelines pipelines_;
  const ShadingSteps& steps_;
  Ports ports_{};
  PixelRecords* records_ = nullptr;
  std::uint8_t fault_ = 0;
  SlotQueue fetch_queue_, shade_queue_, finish_queue_;
  Cycle shader_free_ = 0;
  std::uint32_t outstanding_ = 0;
  std::uint64_t shaded_ = 0, sky_ = 0, lights_ = 0, lights_skipped_ = 0, textured_ = 0, textures_skipped_ = 0,
                pixels_ = 0;
};

}  // namespace artu::hw
