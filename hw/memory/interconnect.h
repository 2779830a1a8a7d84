// Crossbar between the masters (L1 caches, selective blocks, tree builder, control) and the L2.
//
// In:  one request channel a master; one response channel from the L2.
// Out: one request a cycle to the L2, round-robin; one response a cycle to the master it belongs to.
// Latency: `interconnect_latency` each way (the latency of its masters' channels).
// Stalls: stall_out when the L2's request channel or a master's response channel is full.
#pragma once

#include <vector>

#include "hw/fabric/memory_port.h"
#include "hw/fabric/round_robin.h"

namespace artu::hw {

class Interconnect : public Block {
 public:
  Interconnect(sc_core::sc_module_name name, ClockDomain& domain) : Block(name, domain) {}
  void add_master(MemoryLink& link) { masters_.push_back(&link); }
  /// After the last master.
  void flag_requests();
  void bind_below(MemoryLink& link) { below_ = &link; }

  void reset() override;
  void report(Statistics& out) const override;

 private:
  Activity tick(Cycle now) override;

  std::vector<MemoryLink*> masters_;
  MemoryLink* below_ = nullptr;
  std::vector<std::uint64_t> waiting_;  // a bit a master
  RoundRobin arbiter_;
  std::uint64_t requests_ = 0, responses_ = 0;
};

}  // namespace artu::hw
