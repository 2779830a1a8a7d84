// One DRAM channel with its controller: which command goes out when, within the part's timing.
//
// First ready, first come (FR-FCFS, Rixner et al., ISCA 2000): of the waiting requests the oldest whose row is open
// and whose column command may go out; without one, the oldest activate or precharge that may.  A row with waiting
// accesses is not closed.  Reads go first; writes wait until there are write_high of them or no reads, and then go
// until write_low are left.  A request that has waited `starvation` clocks is served before all others. A line is one
// column access that occupies the data bus for as many bursts as it has; a read of a line that waits to be written is
// answered from the queue.
#pragma once

#include <array>
#include <vector>

#include "hw/dram_config.h"
#include "hw/fabric/memory_port.h"
#include "hw/memory/dram_queue.h"

namespace artu::hw {

/// Where a line lies in its channel.
struct DramPlace {
  std::uint32_t channel = 0, bank = 0;
  std::uint64_t row = 0;
};
DramPlace place_of_line(const DramConfig& config, std::uint64_t line);

/// What the data bus carries for a line: whole bursts.
std::uint64_t bus_bytes_of_line(const DramConfig& config);

class DramChannel {
 public:
  struct Counts {
    std::uint64_t row_hits = 0, row_misses = 0, row_empty = 0, bus_clocks = 0, refreshes = 0, turns = 0, forwarded = 0;
    std::uint64_t activates = 0, precharges = 0, reads = 0, writes = 0, read_clocks = 0;
  };

  explicit DramChannel(const DramConfig& config);
  void reset();

  bool can_accept(bool write) const {
    return write ? writes_.size() < config_.write_queue_depth : reads_.size() < config_.queue_depth;
  }
  void accept(const MemoryRequest& request, const DramPlace& place, Cycle now);
  /// Sends at most one command; returns the next cycle in which it could send one, or `never`.
  Cycle step(Cycle now);

  /// Answers in the order of their completion; `front` only where there is one.
  bool has_answer(Cycle now) const { return answered_ != answers_.size() && answers_[answered_].done <= now; }
  Cycle next_answer() const { return answered_ == answers_.size() ? never : answers_[answered_].done; }
  const MemoryResponse& front() const { return answers_[answered_].response; }
  void pop();

  std::size_t waiting() const { return reads_.size() + writes_.size() + answers_.size() - answered_; }
  const Counts& counts() const { return counts_; }

 private:
  struct Bank {
    bool open = false;
    std::uint64_t row = 0;
    Cycle activate_at = 0, column_at = 0, precharge_at = 0, used_at = 0;  // earliest commands; last access
  };
  struct Answer {
    Cycle done;
    MemoryResponse response;
  };
  struct Choice {
    Cycle at = never;
    DramQueue::Index index = DramQueue::none;
    std::uint64_t number = 0;
    /// The oldest of those that can go now, or else the first that can.
    void consider(Cycle earliest, DramQueue::Index i, std::uint64_t its_number) {
      if (earliest > at || (earliest == at && its_number > number)) return;
      *this = {earliest, i, its_number};
    }
  };

  void refresh(Cycle now);
  bool starves(const DramQueue& queue, Cycle now) const;
  void choose_direction(Cycle now);
  Cycle column_at(std::uint32_t bank) const;
  Cycle activate_at(const Bank& bank) const;
  void consider(DramQueue::Index oldest, bool starving, Cycle now, Choice& hit, Choice& other) const;
  void column(DramQueue& queue, DramQueue::Index index, Cycle now);
  void activate(DramRequest& request, Cycle now);
  void precharge(std::uint32_t bank, Cycle now);
  void close(std::uint32_t bank, Cycle activate_at);
  void answer(Cycle done, const MemoryResponse& response);
  void time_out(std::uint32_t bank, Cycle now);

  const DramConfig config_;
  const Cycle data_;         // clocks of the data bus for a line
  const Cycle last_column_;  // from its first burst's command to its last one's
  const Cycle same_group_;   // column command to column command of the same bank group
  DramQueue reads_, writes_;
  std::vector<Bank> banks_;
  std::vector<Answer> answers_;
  std::size_t answered_ = 0;
  bool writing_ = false;
  Cycle command_at_ = 0, read_at_ = 0, write_at_ = 0;  // earliest next command, and by direction
  std::vector<Cycle> group_read_at_, group_write_at_;
  std::array<Cycle, 4> activates_{};  // the last four, oldest at activate_index_; plus 1, 0 is none
  std::size_t activate_index_ = 0;
  Cycle refresh_at_ = 0;
  std::uint32_t refresh_bank_ = 0;
  Counts counts_;
};

}  // namespace artu::hw
