// Walks both trees for many rays at a time: fetches nodes, tests two child boxes a cycle, keeps a stack for each ray.
//
// In:  rays from the ray generator; leaves tested, from intersection; nodes from the node cache.
// Out: leaves to intersection; finished rays to hit_point (hit), to shading (miss, shadow).
// Latency: `box` from a node's data to the ray's next step.  Initiation interval 1 for box tests and 1 for steps (a
// fetch, a leaf or an end); dropping stack entries whose boxes begin behind the best hit takes a step and a cycle each.
// A ray begins with both root boxes; the nearer child is visited first.
// Stalls: stall_mem when nodes are awaited or the cache takes no request, stall_out when intersection, hit_point or
// shading take no more.
#pragma once

#include <deque>

#include "hw/fabric/memory_port.h"
#include "hw/frame_registers.h"
#include "hw/memory/image.h"
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
            const MemoryImage& image, RayContexts& contexts, std::uint32_t box_latency)
      : Block(name, domain),
        registers_(registers),
        image_(image),
        contexts_(contexts),
        box_latency_(box_latency),
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
  enum class Step : std::uint8_t { done, dropping, blocked_memory, blocked_out };
  struct Ready {
    Cycle at;
    Slot slot;
  };

  Activity tick(Cycle now) override;
  void begin(Slot slot, Cycle now);
  void visit(Slot slot, Cycle now);
  void choose(RayContext& context, const std::uint32_t child[2], const Vector lo[2], const Vector hi[2]);
  Step advance(Slot slot, Cycle now);
  Step finish(Slot slot, RayContext& context);
  void ready_push(Slot slot, Cycle at) { ready_[ready_tail_++ % ready_.size()] = {at, slot}; }

  const FrameRegisters& registers_;
  const MemoryImage& image_;
  RayContexts& contexts_;
  const std::uint32_t box_latency_;
  Ports ports_{};
  std::uint32_t fault_ = 0;
  std::vector<Ready> ready_;  // rays in the box pipeline, in order; a ring of one entry a context
  std::size_t ready_head_ = 0, ready_tail_ = 0;
  Cycle stepper_free_ = 0;
  std::uint32_t fetches_ = 0;
  std::uint64_t node_visits_ = 0, box_tests_ = 0, leaves_ = 0, dropped_ = 0, dynamic_skipped_ = 0;
  std::array<std::uint64_t, ray_kinds> finished_{};
};

}  // namespace artu::hw
