// A block of the chip: ticked by its clock domain when awake, accounted for in every cycle.
#pragma once

#include <array>
#include <string>
#include <systemc>

#include "hw/fabric/statistics.h"
#include "hw/fabric/timeline.h"
#include "hw/run_mode.h"

namespace artu::hw {

/// What a block does in a cycle; every cycle of every block is exactly one of these.
enum class State : std::uint8_t {
  busy,       // moves a token or has one in its pipeline
  stall_in,   // nothing to do while its phase of the frame is not finished: starved
  stall_out,  // blocked by a full channel
  stall_mem,  // waits for memory
  idle        // has no part in this phase of the frame
};
inline constexpr std::size_t state_count = 5;

/// As the reports name it: "busy", "stall_in" ...
const char* state_name(State state);

/// Returned by a block's tick: what this cycle is, and when the block must be ticked again at the latest
/// (a channel wakes it earlier).  Until then the cycles are as `after` says, by default as this one: that is
/// the contract which makes sleeping blocks exact, and ticking one more often than it asks must change nothing.
struct Activity {
  Activity(State now, Cycle next_tick = never) : state(now), after(now), next(next_tick) {}
  /// This cycle as `now`, the following ones as `then`, with no tick until a channel wakes the block.
  static Activity once(State now, State then) {
    Activity activity(now);
    activity.after = then;
    return activity;
  }
  State state, after;
  Cycle next;
};

class ClockDomain;

class Block : public sc_core::sc_module {
 public:
  Block(sc_core::sc_module_name name, ClockDomain& domain);

  /// Back to the state before any frame; called at the start of every frame.
  virtual void reset() = 0;
  /// Appends the block's own counters (not the cycle classes).
  virtual void report(Statistics& out) const {}
  /// One line for the picture of a dead-lock.
  virtual std::string describe() const { return {}; }

  ClockDomain& domain() const { return domain_; }
  Cycle now() const;
  std::uint64_t cycles_in(State state) const { return cycles_[static_cast<std::size_t>(state)]; }
  /// Of the cycles of its clock before `cycle`, which has begun already.
  std::uint64_t cycles_before(State state, Cycle cycle) const {
    const std::uint64_t counted = cycles_in(state);
    if (since_ > cycle) return state == last_ ? counted - 1 : counted;  // the present one is in them
    return state == state_ ? counted + (cycle - since_) : counted;
  }
  /// What it did last.
  State state() const { return state_; }
  /// What it does in a cycle for which it was ticked, or in a later one if it is not ticked before.
  State state_in(Cycle cycle) const { return since_ <= cycle ? state_ : last_; }
  /// The cycle in which what it does has changed, or will: not later than the one after its last tick.
  Cycle state_since() const { return since_; }
  /// Instance path below the unit, such as "core0.traversal".
  std::string path() const;
  /// Which phases of the frame the block has a part in (bits of Phase); outside them waiting is idling.
  void takes_part_in(unsigned phases) { phases_ = phases; }
  /// From the next cycle on.
  void set_phase(unsigned phase);
  /// info: a line for each change of the frame's phase; debug: one for each change of the block's state, too.
  void log_to(LogLevel level, const LogSink& sink) {
    log_level_ = level;
    log_sink_ = &sink;
    attention_ = true;
  }

 protected:
  virtual Activity tick(Cycle now) = 0;

 private:
  friend class ClockDomain;
  void run(Cycle now);
  Activity tick_with_attention(Cycle now);
  void begin_frame(Cycle now);
  void enter_phase(unsigned phase);
  void log_change(Cycle now, State before, const Activity& activity, unsigned phase_before) const;
  /// This cycle is `state`, those that follow are `after`.
  void account(Cycle now, State state, State after) {
    if (state != state_) change(now, state);
    if (after != state) {
      last_ = state;
      change(now + 1, after);
    }
  }
  void change(Cycle now, State state) {
    cycles_[static_cast<std::size_t>(state_)] += now - since_;
    state_ = state;
    since_ = now;
  }
  /// The frame ends before `now`.
  void end_frame(Cycle now) {
    if (since_ > now) {
      --cycles_[static_cast<std::size_t>(last_)];  // the last tick was in a cycle that does not count any more
    } else {
      change(now, state_);
    }
  }
  State in_phase(State state) const { return in_phase_[static_cast<std::size_t>(state)]; }

  ClockDomain& domain_;
  const std::size_t index_;  // in the domain's wake list
  const std::size_t word_;   // there
  const std::uint64_t bit_;  // in the word
  unsigned phases_ = ~0u, phase_ = 1, next_phase_ = 1;
  Cycle phase_from_ = 0;
  LogLevel log_level_ = LogLevel::off;
  const LogSink* log_sink_ = nullptr;
  bool attention_ = false;  // of a tick: see tick_with_attention
  std::array<State, state_count> in_phase_{};
  State state_ = State::idle;  // since since_; what was before is in cycles_
  State last_ = State::idle;   // of the tick before since_
  Cycle since_ = 0;
  std::array<std::uint64_t, state_count> cycles_{};
};

}  // namespace artu::hw
