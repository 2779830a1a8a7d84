// One clock: a wake list of blocks, driven by a single SystemC method.
//
// A block that has nothing to do is not on the list; when the list is empty the domain waits for one
// timed event, at the next cycle in which anything can happen.  In clocked mode every block is ticked in
// every cycle: the same cycles, slower, which is the check on the wake list.
#pragma once

#include <cstdint>
#include <random>
#include <systemc>
#include <vector>

#include "hw/fabric/block.h"

namespace artu::hw {

class ClockDomain : public sc_core::sc_module {
 public:
  /// `period` in ticks of the timeline; `tick` is their length.
  ClockDomain(sc_core::sc_module_name name, Timeline& timeline, Tick period, double tick_seconds);

  Cycle now() const { return now_; }
  /// The same, where it lies: for those that ask often.
  const Cycle* clock() const { return &now_; }
  Tick period() const { return period_; }
  Timeline& timeline() { return timeline_; }
  /// The first cycle of this domain that begins strictly after `tick`.
  Cycle cycle_after(Tick tick) const { return tick / period_ + 1; }
  /// The same for SystemC's time, which is not before the frame: at the border, time is sc_time.
  Cycle first_cycle_after(const sc_core::sc_time& time) const;

  /// Stops the frame when no token has moved for this many cycles and no block is busy.  (An event-driven run
  /// need not wait so long: it is stuck when no block will ever be woken.)
  void set_watchdog(Cycle cycles) { watchdog_ = cycles; }
  /// Whether the watchdog ended the last frame.  (If every block sleeps for good, the frame just never finishes.)
  bool dead_locked() const { return dead_locked_; }

  /// Asks for a tick of the block in `cycle`, which is later than the present one.
  void wake(const Block& block, Cycle cycle);

  void set_clocked(bool clocked) { clocked_ = clocked; }
  void set_shuffle(bool shuffle, std::uint64_t seed);

  /// Cycle 0 of a frame: resets all blocks; each is ticked in cycle 1.
  void begin_frame();
  void end_frame(Cycle cycle);
  /// Called by a block: the frame ends with the present cycle; no domain has another one until the next frame.
  void finish();
  void stop();

  /// No block of it is to be ticked.
  bool asleep() const { return next_ == never; }

  std::uint64_t ticks_done() const { return ticks_done_; }
  const std::vector<Block*>& blocks() const { return blocks_; }

 private:
  friend class Block;
  static constexpr std::size_t slots = 256;  // cycles ahead that the wheel covers

  std::size_t add(Block& block);
  void step();
  void work();
  void watch();
  bool anyone_busy() const;
  Cycle next_on_wheel() const;
  Tick next_tick() const { return running_ && next_ != never ? next_ * period_ : never; }
  void schedule();
  sc_core::sc_time time_of(Tick tick) const;
  void refill(Cycle cycle);

  Timeline& timeline_;
  const Tick period_;
  const double tick_seconds_;
  sc_core::sc_time frame_start_;
  sc_core::sc_event due_;
  std::vector<Block*> blocks_;

  // Wheel: for each of the next `slots` cycles one bit a block; wakes further ahead wait in far_.
  std::size_t words_ = 0;
  std::vector<std::uint64_t> wheel_;
  std::uint64_t occupied_[slots / 64] = {};
  struct Far {
    Cycle cycle;
    std::size_t block;
  };
  std::vector<Far> far_;
  Cycle far_next_ = never;

  Cycle now_ = 0, next_ = never;  // the cycle that is worked on, and the next with a wake
  Cycle watchdog_ = never, watched_from_ = 0;
  std::uint64_t watched_moves_ = 0;
  bool dead_locked_ = false;
  bool running_ = false, clocked_ = false, shuffle_ = false;
  std::mt19937_64 random_;
  std::vector<std::size_t> order_;
  std::uint64_t ticks_done_ = 0;
};

inline Cycle Block::now() const { return domain_.now(); }

// The innermost call of the model: every push and every busy tick makes one.
inline void ClockDomain::wake(const Block& block, Cycle cycle) {
  if (cycle < now_ + slots) {
    const std::size_t slot = cycle % slots;
    wheel_[slot * words_ + block.word_] |= block.bit_;
    occupied_[slot / 64] |= std::uint64_t{1} << (slot % 64);
  } else {
    far_.push_back({cycle, block.index_});
    far_next_ = far_next_ < cycle ? far_next_ : cycle;
  }
  if (cycle < next_) {
    next_ = cycle;
    if (!timeline_.driven && running_) schedule();
  }
}

}  // namespace artu::hw
