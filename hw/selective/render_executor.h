// Decides for each candidate whether to interpolate or to ray trace (patent, rendering execution module 537; C7, C8).
//
// In:  candidates.   Out: interpolated pixels to the frame writer, others to the dispatcher.
// Latency 1, initiation interval 1.   Stalls: stall_out when the output that the decision needs is full.
#pragma once

#include "hw/fabric/fifo.h"
#include "hw/frame_registers.h"
#include "hw/memory/frame_writer.h"
#include "hw/ray_core/ray_context.h"
#include "hw/selective/tokens.h"

namespace artu::hw {

class RenderExecutor : public Block {
 public:
  RenderExecutor(sc_core::sc_module_name name, ClockDomain& domain, Metric metric, const FrameRegisters& registers)
      : Block(name, domain), metric_(metric), registers_(registers) {}
  void bind(Fifo<Candidate>& in, Fifo<PixelToken>& interpolated, Fifo<PixelJob>& traced) {
    in_ = &in;
    interpolated_ = &interpolated;
    traced_ = &traced;
  }
  void observe(PixelRecords* records) { records_ = records; }
  /// Fault injection: bits that every interpolated pixel's red code is xored with.
  void inject(std::uint8_t bits) { fault_ = bits; }

  void reset() override { interpolated_count_ = traced_count_ = differences_ = 0; }
  void report(Statistics& out) const override;
  std::uint64_t interpolated() const { return interpolated_count_; }
  std::uint64_t traced() const { return traced_count_; }

 private:
  Activity tick(Cycle now) override;
  void record(const Candidate& candidate, int difference, Decision decision);

  const Metric metric_;
  const FrameRegisters& registers_;
  Fifo<Candidate>* in_ = nullptr;
  Fifo<PixelToken>* interpolated_ = nullptr;
  Fifo<PixelJob>* traced_ = nullptr;
  PixelRecords* records_ = nullptr;
  std::uint8_t fault_ = 0;
  std::uint64_t interpolated_count_ = 0, traced_count_ = 0, differences_ = 0;
};

}  // namespace artu::hw
