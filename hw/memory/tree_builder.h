// Rebuilds the tree of the dynamic geometry at the start of a frame in which it moved.
//
// In:  `build` from the control unit.   Out: `built`; reads and writes of the memory.
// The tree itself is laid down by the driver; this block is its cost.  Top-down construction: the triangles are read
// once and a 16-byte reference of each is written; at every level whose subtrees do not fit on chip the references are
// read and written again; then nodes, triangles and attributes are written in the tree's order.
// Time: `cycles_per_triangle` for each triangle at each of ceil(log2(n)) levels, overlapped with the level's traffic,
// of which one line a cycle is issued with at most `outstanding` in flight, from one cycle after the level begins; the
// first step (references) computes one cycle a triangle.
// Stalls: stall_mem when a level's computing is done and its traffic is not.
#pragma once

#include <vector>

#include "hw/fabric/memory_port.h"
#include "hw/frame_registers.h"
#include "hw/unit_config.h"

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
  /// A step streams lines in and out while it computes.
  struct Stream {
    Address base;
    std::uint64_t lines;
    bool write;
  };
  struct Step {
    std::vector<Stream> streams;
    std::uint64_t compute = 0;  // cycles
  };

  Activity tick(Cycle now) override;
  void plan();
  bool issue();

  const TreeBuilderConfig config_;
  const FrameRegisters& registers_;
  MemoryLink* memory_ = nullptr;
  Fifo<BuildToken>* build_ = nullptr;
  Fifo<BuildToken>* built_ = nullptr;
  std::vector<Step> steps_;
  std::size_t step_ = 0, stream_ = 0;
  std::uint64_t line_ = 0;
  Cycle computed_at_ = 0;
  std::uint32_t outstanding_ = 0;
  bool active_ = false;
  std::uint64_t builds_ = 0, triangles_ = 0, lines_read_ = 0, lines_written_ = 0;
};

}  // namespace artu::hw
