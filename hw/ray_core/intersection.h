// Tests the triangles of leaves.
//
// In:  leaves from traversal; triangles from the triangle cache.   Out: contexts whose leaf is done, to traversal.
// Latency: `triangle` from the last triangle's data to the answer.  One fetch a cycle, one test every
// `triangle_interval`; several leaves are in work at a time, their triangles fetched in order.
// A shadow ray's leaf ends at its first hit: triangles not yet fetched are left out (early-out).
// Stalls: stall_mem when triangles are awaited or the cache takes no request.  The output never fills.
#pragma once

#include "hw/fabric/memory_port.h"
#include "hw/frame_registers.h"
#include "hw/memory/image.h"
#include "hw/ray_core/traversal.h"

namespace artu::hw {

class Intersection : public Block {
 public:
  Intersection(sc_core::sc_module_name name, ClockDomain& domain, const FrameRegisters& registers,
               const MemoryImage& image, RayContexts& contexts, const PrecisionConfig& precision = {},
               std::uint32_t interval = 1)
      : Block(name, domain),
        registers_(registers),
        image_(image),
        contexts_(contexts),
        hit_tests_(precision),
        interval_(interval),
        leaves_(contexts.size()) {}
  void bind(Fifo<LeafTask>& in, Fifo<Slot>& tested, MemoryLink& triangles) {
    in_ = &in;
    tested_ = &tested;
    triangles_ = &triangles;
  }
  /// Fault injection: bits that the t of every hit is xored with.
  void inject(std::uint32_t bits) { fault_ = bits; }

  void reset() override;
  void report(Statistics& out) const override;
  std::string describe() const override;
  std::uint64_t tests() const { return tests_; }

 private:
  struct Leaf {
    std::uint32_t leaf = 0;
    std::uint32_t fetched = 0, answered = 0, count = 0;
  };
  Activity tick(Cycle now) override;
  void test(Slot slot, std::uint32_t index);

  const FrameRegisters& registers_;
  const MemoryImage& image_;
  RayContexts& contexts_;
  const HitTests hit_tests_;
  const std::uint32_t interval_;
  Cycle tester_free_ = 0;
  Fifo<LeafTask>* in_ = nullptr;
  Fifo<Slot>* tested_ = nullptr;
  MemoryLink* triangles_ = nullptr;
  std::uint32_t fault_ = 0;
  std::vector<Leaf> leaves_;  // by slot: a ray has one leaf in work at most
  bool fetching_ = false;
  Slot fetch_slot_ = 0;
  std::uint32_t outstanding_ = 0;
  std::uint64_t tests_ = 0, hits_ = 0, left_out_ = 0;
};

}  // namespace artu::hw
