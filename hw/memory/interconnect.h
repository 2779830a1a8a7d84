// Crossbar between masters (L1 caches, selective blocks, tree builder, control; or the L2's banks) and memories (the
// L2's banks; or the DRAM).
//
// In:  one request channel a master; one response channel a memory.
// Out: one request a cycle to each memory and from each master, round-robin among the masters whose first request is
//      for it; one response a cycle from each memory and to each master, from the memories in turn.
// Memories are interleaved line by line.
// Latency: that of the channels of its masters (`interconnect_latency` each way before the L2, 1 behind it).
// Stalls: stall_out when a memory's request channel or a master's response channel is full.
#pragma once

#include <vector>

#include "hw/fabric/memory_port.h"
#include "hw/fabric/round_robin.h"

namespace artu::hw {

class Interconnect : public Block {
 public:
  Interconnect(sc_core::sc_module_name name, ClockDomain& domain) : Block(name, domain) {}
  void add_master(MemoryLink& link) { masters_.push_back(&link); }
  /// After the last master and the last memory.
  void flag_channels();
  /// As many as a power of two, 16 at most.
  void add_memory(MemoryLink& link) {
    memories_.push_back(&link);
    last_memory_ = memories_.size() - 1;
    arbiters_.emplace_back();
  }

  void reset() override;
  void report(Statistics& out) const override;

 private:
  Activity tick(Cycle now) override;
  void look_at_arrivals();
  std::size_t next_master(std::size_t memory) const;
  bool pass_requests(bool& blocked, bool& left);
  bool pass_response(std::size_t memory, Cycle now, bool& blocked);
  std::size_t memory_of(Address line) const { return line / line_bytes & last_memory_; }

  std::vector<MemoryLink*> masters_, memories_;
  std::vector<std::uint64_t> waiting_;  // a bit a master
  std::vector<std::uint64_t> known_;    // of them those whose first request has arrived and been looked at
  std::vector<std::uint64_t> wanted_;   // of them, memory by memory, those whose request is for it
  std::uint32_t asked_ = 0;             // a bit a memory that any is for
  std::uint64_t answering_ = 0;         // a bit a memory
  std::vector<RoundRobin> arbiters_;    // one a memory
  std::vector<Cycle> answered_;         // by master: when it got its last response
  std::size_t last_memory_ = 0;
  std::size_t first_memory_ = 0;  // whose responses go first
  std::uint64_t requests_ = 0, responses_ = 0, conflicts_ = 0;
};

}  // namespace artu::hw
