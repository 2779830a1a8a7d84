// Hands pixels to the ray cores.
//
// In:  pixels from the first rendering unit and from the render executor (never both at a time).
// Out: pixels to each core, round-robin among those that have room.
// Latency 1, initiation interval 1.   Stalls: stall_out when no core has room.
#pragma once

#include <vector>

#include "hw/fabric/fifo.h"
#include "hw/fabric/round_robin.h"
#include "hw/ray_core/ray_context.h"

namespace artu::hw {

class Dispatcher : public Block {
 public:
  Dispatcher(sc_core::sc_module_name name, ClockDomain& domain) : Block(name, domain) {}
  void add_source(Fifo<PixelJob>& source) { sources_.push_back(&source); }
  void add_core(Fifo<PixelJob>& core) { cores_.push_back(&core); }

  void reset() override;
  void report(Statistics& out) const override;

 private:
  Activity tick(Cycle now) override;
  std::vector<Fifo<PixelJob>*> sources_, cores_;
  RoundRobin source_arbiter_, core_arbiter_;
  std::uint64_t pixels_ = 0;
};

}  // namespace artu::hw
