// Gives each candidate its threshold (patent, threshold adjustment module 535; C5, C6, C11-C13): a pipeline around the
// policy that is configured.
//
// In, out: candidates.   Latency the policy's (the output channel's), initiation interval 1.
// Stalls: stall_out when the render executor takes no more.
#pragma once

#include "hw/fabric/fifo.h"
#include "hw/selective/policy.h"
#include "hw/selective/tokens.h"

namespace artu::hw {

class ThresholdAdjuster : public Block {
 public:
  static std::uint32_t latency(const SelectiveConfig& config) { return policy(config.policy).latency; }
  ThresholdAdjuster(sc_core::sc_module_name name, ClockDomain& domain, const SelectiveConfig& config)
      : Block(name, domain), config_(config), policy_(policy(config.policy)) {}
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
  const Policy policy_;
  Fifo<Candidate>* in_ = nullptr;
  Fifo<Candidate>* out_ = nullptr;
  std::uint8_t fault_ = 0;
  std::uint64_t lowered_ = 0, raised_ = 0;
};

}  // namespace artu::hw
