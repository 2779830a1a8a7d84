// Sends the sampling pixels to the ray cores (patent, first rendering unit 510; C1).
//
// In:  a pass command.   Out: pixels to trace, to the dispatcher, in the order `pixel_order`.
// Latency 1, initiation interval 1.   Stalls: stall_out when the dispatcher takes no more.
#pragma once

#include "hw/fabric/fifo.h"
#include "hw/frame_registers.h"
#include "hw/ray_core/ray_context.h"
#include "hw/selective/pixel_walk.h"
#include "hw/selective/tokens.h"

namespace artu::hw {

class FirstRenderingUnit : public Block {
 public:
  FirstRenderingUnit(sc_core::sc_module_name name, ClockDomain& domain, const SelectiveConfig& config,
                     const FrameRegisters& registers, PixelOrder order = PixelOrder::rows)
      : Block(name, domain), config_(config), registers_(registers), order_(order) {}
  void bind(Fifo<PassCommand>& command, Fifo<PixelJob>& jobs) {
    command_ = &command;
    jobs_ = &jobs;
  }
  void observe(PixelRecords* records) { records_ = records; }

  void reset() override;
  void report(Statistics& out) const override;

 private:
  Activity tick(Cycle now) override;

  const SelectiveConfig config_;
  const FrameRegisters& registers_;
  const PixelOrder order_;
  Fifo<PassCommand>* command_ = nullptr;
  Fifo<PixelJob>* jobs_ = nullptr;
  PixelRecords* records_ = nullptr;
  bool active_ = false;
  PixelWalk walk_;
  std::uint64_t pixels_ = 0;
};

}  // namespace artu::hw
