// Walks both trees for many rays at a time: fetches nodes, tests child boxes or planes, keeps a stack for each ray.
//
// In:  rays from the ray generator; leaves tested, from intersection; nodes from the node cache.
// Out: leaves to intersection; finished rays to hit_point (hit), to shading (miss, shadow).
// Latency: `box`, `wide_box` or `plane`, as the kind of tree asks, from a node's last line to the ray's next step.
// Initiation interval: tests / box_testers cycles a node (8-wide nodes are two lines), 1 for steps (a
// fetch, a leaf or an end); dropping stack entries whose boxes begin behind the best hit takes a step and a cycle each.
// A ray begins with both root boxes; the nearer child is visited first.
// Stalls: stall_mem when nodes are awaited or the cache takes no request, stall_out when intersection, hit_point or
// shading take no more.
#pragma once

#include "hw/fabric/memory_port.h"
#include "hw/frame_registers.h"
#include "hw/memory/image.h"
#include "hw/ray_core/pipelines.h"
#include "hw/ray_core/ray_context.h"

namespace artu::hw {

/// A leaf to test for the ray in a context: 8 + 32 bits.
struct LeafTask {
  Slot slot = 0;
  std::uint32_t leaf = 0;
};

class Traversal : public Block {
 public:
  Traversal(sc_core::sc_module_name name, ClockDomain& domain, const FrameRegisters& registers,
            const MemoryImage& image, RayContexts& contexts, const RayCoreConfig& config, const Pipelines& pipelines,
            const PrecisionConfig& precision = {})
      : Block(name, domain),
        registers_(registers),
        image_(image),
        contexts_(contexts),
        box_testers_(config.box_testers),
        pipelines_(pipelines),
        hit_tests_(precision),
        ready_(contexts.size()) {}

  struct Ports {
    Fifo<Slot>* primary;
    Fifo<Slot>* others;
    Fifo<Slot>* tested;
    Fifo<LeafTask>* leaves;
    Fifo<Slot>* hits;
    Fifo<Slot>* misses;
    Fifo<Slot>* shadows;
    MemoryLink* nodes;
  };
  void bind(const Ports& ports) { ports_ = ports; }
  /// Fault injection: bits that every box interval's end is xored with.
  void inject(std::uint32_t bits) { fault_ = bits; }

  void reset() override;
  void report(Statistics& out) const override;
  std::string describe() const override;
  std::uint64_t node_visits() const { return node_visits_; }
  std::uint64_t finished(RayKind kind) const { return finished_[static_cast<std::size_t>(kind)]; }

 private:
  enum class Advance : std::uint8_t { done, dropping, blocked_memory, blocked_out };
  struct Ready {
    Cycle at;
    Slot slot;
  };

  Activity tick(Cycle now) override;
  void begin(Slot slot, Cycle now);
  void visit(Slot slot, Cycle now);
  void take(Slot slot, const Steps& steps, std::uint32_t latency, Cycle now);
  TreeKind kind_of(std::uint32_t node) const;
  Address address_of(std::uint32_t node) const;
  Advance advance(Slot slot, Cycle now);
  Advance fetch(Slot slot, RayContext& context);
  Advance finish(Slot slot, RayContext& context);

  const FrameRegisters& registers_;
  const MemoryImage& image_;
  RayContexts& contexts_;
  const std::uint32_t box_testers_;
  const Pipelines pipelines_;
  const HitTests hit_tests_;
  Ports ports_{};
  std::uint32_t fault_ = 0;
  std::vector<Ready> ready_;  // rays in the box pipeline, in order; a ring of one entry a context
  std::size_t ready_head_ = 0, ready_tail_ = 0;
  Cycle ready_at_ = 0;  // of the last one that entered
  Cycle stepper_free_ = 0, testers_free_ = 0;
  std::uint32_t fetches_ = 0;
  std::uint64_t node_visits_ = 0, box_tests_ = 0, leaves_ = 0, dropped_ = 0, dynamic_skipped_ = 0;
  std::array<std::uint64_t, ray_kinds> finished_{};
};

}  // namespace artu::hw
