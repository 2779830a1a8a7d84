// Shared DRAM: LPDDR channels with banks and open rows, in a clock domain of their own.
//
// In:  line requests from the L2 (64-byte lines, interleaved over the channels by line).
// Out: a response for each request; for a write it says that the data are in memory.
// Timing, in DRAM clocks: a request to the open row of a bank has its first data t_cl after its column command,
// one to another row pays t_rp (where a row is open) and t_rcd before; a row stays open at least t_ras; a line
// occupies its channel's data bus for line / (2 * bus_bits / 8) clocks.  First come, first served in each channel.
// One request is accepted and one answer given a clock; a request whose channel has queue_depth in flight waits, and
// those behind it.  Rows are left open.
// Not modelled: refresh, read/write turn-round, command-bus contention.
#pragma once

#include <vector>

#include "hw/fabric/memory_port.h"
#include "hw/fabric/round_robin.h"
#include "hw/unit_config.h"

namespace artu::hw {

class Dram : public Block {
 public:
  Dram(sc_core::sc_module_name name, ClockDomain& domain, const DramConfig& config);
  void bind(MemoryLink& link) { link_ = &link; }
  /// Fault injection: the answer with this number, from 0, is lost.
  void lose(std::uint64_t answer) { lost_ = answer; }

  void reset() override;
  void report(Statistics& out) const override;
  std::string describe() const override;

  std::uint64_t read_bytes() const { return read_bytes_; }
  std::uint64_t write_bytes() const { return write_bytes_; }

 private:
  struct Bank {
    bool open = false;
    std::uint64_t row = 0;
    Cycle column_at = 0;     // earliest next column command
    Cycle precharge_at = 0;  // earliest precharge of the open row
  };
  struct Pending {
    Cycle done;
    MemoryResponse response;
  };
  struct Channel_ {
    std::vector<Bank> banks;
    Cycle bus_free = 0;
    std::vector<Pending> queue;  // in order of `done`: the data bus is in order
    std::size_t head = 0;
    std::size_t waiting() const { return queue.size() - head; }
  };

  Activity tick(Cycle now) override;
  void accept(Channel_& channel, std::uint64_t line_index, const MemoryRequest& request, Cycle now);

  const DramConfig config_;
  const Cycle burst_;  // clocks of data bus for a line
  const unsigned channel_shift_, bank_shift_, row_shift_;
  MemoryLink* link_ = nullptr;
  std::vector<Channel_> channels_;
  RoundRobin arbiter_;
  std::uint64_t lost_ = never, answers_ = 0;
  std::uint64_t read_bytes_ = 0, write_bytes_ = 0, row_hits_ = 0, row_misses_ = 0, row_empty_ = 0, bus_clocks_ = 0;
};

}  // namespace artu::hw
