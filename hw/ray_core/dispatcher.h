// Hands pixels to the ray cores.
//
// In:  pixels from the first rendering unit and from the render executor (both at a time with overlap).
// Out: pixels to each core: with `dispatch` first-come round-robin among those that have room, with tiles all pixels of
//      a tile to the same core, tiles round-robin.
// Latency 1, initiation interval 1.   Stalls: stall_out when no core, or not the tile's, has room.
#pragma once

#include <vector>

#include "hw/fabric/fifo.h"
#include "hw/fabric/round_robin.h"
#include "hw/frame_registers.h"
#include "hw/ray_core/ray_context.h"

namespace artu::hw {

class Dispatcher : public Block {
 public:
  Dispatcher(sc_core::sc_module_name name, ClockDomain& domain, const FrameRegisters& registers,
             Dispatch policy = Dispatch::first_come, std::uint32_t tile = 16)
      : Block(name, domain), registers_(registers), policy_(policy), tile_(tile) {}
  void add_source(Fifo<PixelJob>& source) { sources_.push_back(&source); }
  void add_core(Fifo<PixelJob>& core) { cores_.push_back(&core); }
  /// The pixels' records, for the observer: `cycles` holds the cycle of the dispatch until the frame writer's write.
  void observe(PixelRecords* records) { records_ = records; }

  void reset() override;
  void report(Statistics& out) const override;

 private:
  Activity tick(Cycle now) override;
  std::size_t core_for(const PixelJob& pixel);

  const FrameRegisters& registers_;
  const Dispatch policy_;
  const std::uint32_t tile_;  // pixels, its edge
  std::vector<Fifo<PixelJob>*> sources_, cores_;
  RoundRobin source_arbiter_, core_arbiter_;
  PixelRecords* records_ = nullptr;
  std::uint64_t pixels_ = 0;
};

}  // namespace artu::hw
