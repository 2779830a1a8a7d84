// Rebuilds the tree of the dynamic geometry at the start of a frame in which it moved.
//
// In:  `build` from the control unit.   Out: `built`; reads and writes of the memory.
// The tree itself is laid down by the driver, by the algorithm that is configured; this block is its cost: the steps of
// build_plan.h, one after the other.
// Time: a step takes what its computing takes or its traffic, whichever is more.  Its lines are issued one a cycle from
// the cycle on in which it begins, at most `outstanding` in flight, the streams in proportion to their lengths; it ends
// with the last answer.  The next step begins in the same cycle; `built` is pushed in that in which the last one ends.
// Stalls: stall_mem when a step's computing is done and its traffic is not.
#pragma once

#include <array>
#include <vector>

#include "hw/fabric/memory_port.h"
#include "hw/frame_registers.h"
#include "hw/memory/build_plan.h"

namespace artu::hw {

struct BuildToken {};

class TreeBuilder : public Block {
 public:
  TreeBuilder(sc_core::sc_module_name name, ClockDomain& domain, const TreeBuilderConfig& config,
              const FrameRegisters& registers)
      : Block(name, domain), config_(config), registers_(registers) {}
  void bind(MemoryLink& memory, Fifo<BuildToken>& build, Fifo<BuildToken>& built) {
    memory_ = &memory;
    build_ = &build;
    built_ = &built;
  }

  void reset() override;
  void report(Statistics& out) const override;
  std::string describe() const override;

 private:
  Activity tick(Cycle now) override;
  void begin_build();
  void begin_step(Cycle now);
  bool issue();

  const TreeBuilderConfig config_;
  const FrameRegisters& registers_;
  MemoryLink* memory_ = nullptr;
  Fifo<BuildToken>* build_ = nullptr;
  Fifo<BuildToken>* built_ = nullptr;
  std::vector<BuildStep> steps_;
  std::size_t step_ = 0;                  // steps_.size(): no build goes on
  std::vector<std::uint64_t> issued_;     // lines of each of the step's streams
  std::uint64_t left_ = 0;                // lines of the step that are not issued yet
  Cycle began_at_ = 0, computed_at_ = 0;  // the step
  std::uint32_t outstanding_ = 0;
  std::uint64_t builds_ = 0, refits_ = 0, triangles_ = 0, lines_read_ = 0, lines_written_ = 0;
  std::array<std::uint64_t, build_stages> stage_cycles_{};
};

}  // namespace artu::hw
