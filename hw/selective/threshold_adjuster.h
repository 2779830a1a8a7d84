// Moves the reference threshold by a candidate's hit counts (patent, threshold adjustment module 535; C5, C6, C11-C13):
// more dynamic than static neighbours lower it, so that more is traced where the viewer looks.
//
// In, out: candidates.   Latency 2 (the output channel's), initiation interval 1.
// Stalls: stall_out when the render executor takes no more.
#pragma once

#include "hw/fabric/fifo.h"
#include "hw/selective/tokens.h"

namespace artu::hw {

class ThresholdAdjuster : public Block {
 public:
  static constexpr std::uint32_t latency = 2;
  ThresholdAdjuster(sc_core::sc_module_name name, ClockDomain& domain, const SelectiveConfig& config)
      : Block(name, domain), config_(config) {}
  void bind(Fifo<Candidate>& in, Fifo<Candidate>& out) {
    in_ = &in;
    out_ = &out;
  }
  /// Fault injection: bits that every threshold is xored with.
  void inject(std::uint8_t bits) { fault_ = bits; }
  void reset() override { lowered_ = raised_ = 0; }
  void report(Statistics& out) const override;

 private:
  Activity tick(Cycle now) override;
  const SelectiveConfig config_;
  Fifo<Candidate>* in_ = nullptr;
  Fifo<Candidate>* out_ = nullptr;
  std::uint8_t fault_ = 0;
  std::uint64_t lowered_ = 0, raised_ = 0;
};

}  // namespace artu::hw
