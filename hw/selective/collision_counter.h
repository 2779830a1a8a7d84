// Counts, among a candidate's eight neighbours, the primary rays that hit static and dynamic geometry (patent,
// collision-frequency detection module 533; C4, C11).
//
// In, out: candidates.   Latency 2 (the output channel's), initiation interval 1.
// Stalls: stall_out when the threshold adjuster takes no more.
#pragma once

#include "hw/fabric/fifo.h"
#include "hw/selective/tokens.h"

namespace artu::hw {

class CollisionCounter : public Block {
 public:
  static constexpr std::uint32_t latency = 2;
  CollisionCounter(sc_core::sc_module_name name, ClockDomain& domain) : Block(name, domain) {}
  void bind(Fifo<Candidate>& in, Fifo<Candidate>& out) {
    in_ = &in;
    out_ = &out;
  }
  void reset() override { static_ = dynamic_ = 0; }
  void report(Statistics& out) const override;

 private:
  Activity tick(Cycle now) override;
  Fifo<Candidate>* in_ = nullptr;
  Fifo<Candidate>* out_ = nullptr;
  std::uint64_t static_ = 0, dynamic_ = 0;
};

}  // namespace artu::hw
