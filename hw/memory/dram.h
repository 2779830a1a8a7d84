// Shared DRAM: LPDDR channels with their controllers, in a clock domain of their own.
//
// In:  line requests from the L2 (64-byte lines).   Out: a response for each request; for a write it says that the data
//      are in memory.
// Latency, in DRAM clocks: an access to an open row t_cl (a write: t_cwl) and the line's time on the bus, line / (2 *
// bus_bits / 8); with no row open t_rcd more, with another one t_rp + t_rcd.  See hw/memory/dram_channel.h for the
// scheduling.  One request is accepted and one answer given a clock; a request whose channel has no room in its queue
// waits, and those behind it.
// Not modelled: power-down, temperature-dependent refresh, command and data training.
#pragma once

#include <functional>
#include <vector>

#include "hw/fabric/memory_port.h"
#include "hw/fabric/round_robin.h"
#include "hw/memory/dram_channel.h"
#include "hw/memory/main_memory.h"
#include "hw/unit_config.h"

namespace artu::hw {

/// Told of each request in the DRAM clock in which the DRAM takes it.  No part of the chip; must not throw.
using MemoryObserver = std::function<void(Cycle, const MemoryRequest&)>;

class Dram : public MainMemory {
 public:
  Dram(sc_core::sc_module_name name, ClockDomain& domain, const DramConfig& config);
  void bind(MemoryLink& link) override { link_ = &link; }
  /// Fault injection: the answer with this number, from 0, is lost.
  void lose(std::uint64_t answer) { lost_ = answer; }
  /// None: {}.
  void observe(MemoryObserver observer) { observer_ = std::move(observer); }

  void reset() override;
  void report(Statistics& out) const override;
  std::string describe() const override;

  std::uint64_t read_bytes() const override { return read_bytes_; }
  std::uint64_t write_bytes() const override { return write_bytes_; }

 private:
  Activity tick(Cycle now) override;
  bool answer(Cycle now, bool& blocked);
  Cycle next_answer() const;
  bool can_accept();
  bool accept(Cycle now);

  const DramConfig config_;
  MemoryLink* link_ = nullptr;
  MemoryObserver observer_;
  std::vector<DramChannel> channels_;
  std::vector<Cycle> step_at_;  // by channel
  RoundRobin arbiter_;
  DramPlace place_;  // of the next request
  bool placed_ = false;
  std::uint64_t lost_ = never, answers_ = 0;
  std::uint64_t read_bytes_ = 0, write_bytes_ = 0;
};

}  // namespace artu::hw
