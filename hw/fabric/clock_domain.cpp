#include "hw/fabric/clock_domain.h"

#include <algorithm>

#include "hw/fabric/fifo.h"
#include "hw/fabric/phase.h"

namespace artu::hw {

ClockDomain::ClockDomain(sc_core::sc_module_name name, Timeline& timeline, Tick period, double tick_seconds)
    : sc_module(name), timeline_(timeline), period_(period), tick_seconds_(tick_seconds) {
  timeline_.domains.push_back(this);
  SC_HAS_PROCESS(ClockDomain);
  SC_METHOD(step);
  sensitive << due_;
  dont_initialize();
}

std::size_t ClockDomain::add(Block& block) {
  blocks_.push_back(&block);
  words_ = (blocks_.size() + 63) / 64;
  wheel_.assign(words_ * slots, 0);
  return blocks_.size() - 1;
}

void ClockDomain::set_shuffle(bool shuffle, std::uint64_t seed) {
  shuffle_ = shuffle;
  random_.seed(seed);
}

void ClockDomain::begin_frame() {
  std::fill(wheel_.begin(), wheel_.end(), 0);
  std::fill(std::begin(occupied_), std::end(occupied_), 0);
  far_.clear();
  far_next_ = never;
  now_ = 0;
  next_ = never;
  watched_from_ = 0;
  watched_moves_ = 0;
  dead_locked_ = false;
  running_ = true;
  frame_start_ = sc_core::sc_time_stamp();
  for (Block* block : blocks_) {
    block->reset();
    block->begin_frame(0);
  }
  timeline_.driven = true;
  for (Block* block : blocks_) wake(*block, 1);
  timeline_.driven = false;
  schedule();
}

void ClockDomain::end_frame(Cycle cycle) {
  for (Block* block : blocks_) block->end_frame(cycle);
}

void ClockDomain::finish() {
  for (ClockDomain* domain : timeline_.domains) domain->stop();
}

void ClockDomain::stop() {
  running_ = false;
  due_.cancel();
}

/// The first cycle after the present one for which the wheel has a wake.
Cycle ClockDomain::next_on_wheel() const {
  // The occupancy bits from the slot after the present one, once round.
  const std::size_t start = (now_ + 1) % slots;
  std::size_t word = start / 64;
  std::uint64_t bits = occupied_[word] & (~std::uint64_t{0} << (start % 64));
  for (std::size_t i = 0; i <= slots / 64; ++i) {
    if (bits != 0) {
      const std::size_t slot = word * 64 + static_cast<std::size_t>(__builtin_ctzll(bits));
      return now_ + 1 + (slot + slots - start) % slots;
    }
    word = (word + 1) % (slots / 64);
    bits = occupied_[word];
    if (i + 1 == slots / 64) bits &= ~(~std::uint64_t{0} << (start % 64));
  }
  return never;
}

sc_core::sc_time ClockDomain::time_of(Tick tick) const {
  return frame_start_ + sc_core::sc_time(static_cast<double>(tick) * tick_seconds_, sc_core::SC_SEC);
}

Cycle ClockDomain::first_cycle_after(const sc_core::sc_time& time) const {
  auto cycle = static_cast<Cycle>((time - frame_start_).to_seconds() / (static_cast<double>(period_) * tick_seconds_));
  // That was rounded; an edge's time is what decides.
  while (cycle > 0 && time_of((cycle - 1) * period_) > time) --cycle;
  while (time_of(cycle * period_) <= time) ++cycle;
  return cycle;
}

void ClockDomain::schedule() {
  const Tick tick = next_tick();
  if (tick == never) return;
  const sc_core::sc_time at = time_of(tick);
  const sc_core::sc_time& present = sc_core::sc_time_stamp();
  due_.cancel();
  due_.notify(at > present ? at - present : sc_core::SC_ZERO_TIME);
}

void ClockDomain::refill(Cycle cycle) {
  // Only now_ has moved on: wakes that came within the wheel's reach go onto it.
  far_next_ = never;
  std::size_t kept = 0;
  for (const Far& far : far_) {
    if (far.cycle < cycle + slots) {
      wake(*blocks_[far.block], far.cycle);
    } else {
      far_next_ = std::min(far_next_, far.cycle);
      far_[kept++] = far;
    }
  }
  far_.resize(kept);
}

void ClockDomain::step() {
  // Whichever domain the kernel calls drives all of them from edge to edge, in the order of their ticks, without
  // going through the kernel again: a kernel event costs as much as ticking thirty blocks.
  timeline_.driven = true;
  while (running_) {
    ClockDomain* earliest = nullptr;
    Tick tick = never;
    for (ClockDomain* domain : timeline_.domains) {
      const Tick next = domain->next_tick();
      if (next < tick) {
        tick = next;
        earliest = domain;
      }
    }
    if (earliest == nullptr) break;  // all asleep, for good or until the border wakes one
    if (timeline_.in_step && earliest->time_of(tick) > sc_core::sc_time_stamp()) {
      earliest->schedule();
      break;
    }
    if (timeline_.observer != nullptr && tick != timeline_.now) timeline_.observer->settled(timeline_.now, tick);
    timeline_.now = tick;
    earliest->work();
    earliest->watch();
  }
  timeline_.driven = false;
  if (!running_ && timeline_.at_end) timeline_.at_end();
}

void ClockDomain::watch() {
  if (now_ - watched_from_ < watchdog_) return;
  std::uint64_t moves = 0;
  for (const Channel* channel : timeline_.channels) moves += channel->moves();
  if (watched_moves_ == moves && !anyone_busy()) {
    dead_locked_ = true;
    finish();
  }
  watched_from_ = now_;
  watched_moves_ = moves;
}

/// A busy block moves no token for as long as its computation takes, and yet it will.
bool ClockDomain::anyone_busy() const {
  for (const ClockDomain* domain : timeline_.domains) {
    for (const Block* block : domain->blocks_) {
      if (block->state() == State::busy) return true;
    }
  }
  return false;
}

inline void Block::run(Cycle now) {
  const Activity activity = attention_ ? tick_with_attention(now) : tick(now);
  account(now, in_phase(activity.state), in_phase(activity.after));
  if (activity.next != never) domain_.wake(*this, activity.next);
}

void ClockDomain::work() {
  const Cycle cycle = next_;
  now_ = cycle;
  next_ = clocked_ ? cycle + 1 : never;
  if (far_next_ < cycle + slots) refill(cycle);
  const std::size_t slot = cycle % slots;
  std::uint64_t* words = &wheel_[slot * words_];
  occupied_[slot / 64] &= ~(std::uint64_t{1} << (slot % 64));
  if (clocked_ || shuffle_) {
    order_.clear();
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      if (clocked_ || (words[i / 64] >> (i % 64) & 1) != 0) order_.push_back(i);
    }
    std::fill(words, words + words_, 0);
    if (shuffle_) std::shuffle(order_.begin(), order_.end(), random_);
    for (std::size_t i : order_) blocks_[i]->run(cycle);
    ticks_done_ += order_.size();
  } else {
    for (std::size_t w = 0; w < words_; ++w) {
      std::uint64_t bits = words[w];
      words[w] = 0;
      while (bits != 0) {
        const std::size_t i = w * 64 + static_cast<std::size_t>(__builtin_ctzll(bits));
        bits &= bits - 1;
        blocks_[i]->run(cycle);
        ++ticks_done_;
      }
    }
  }
  // The blocks have asked for their next ticks; what was asked for earlier can only matter later than the next cycle.
  if (next_ != cycle + 1) next_ = std::min({next_, next_on_wheel(), far_next_});
}

Block::Block(sc_core::sc_module_name name, ClockDomain& domain)
    : sc_module(name),
      domain_(domain),
      index_(domain.add(*this)),
      word_(index_ / 64),
      bit_(std::uint64_t{1} << (index_ % 64)) {}

std::string Block::path() const {
  const std::string full = name();
  if (const sc_core::sc_object* unit = domain_.get_parent_object()) {
    return full.substr(std::string(unit->name()).size() + 1);  // the unit may lie deep in a platform
  }
  const std::size_t dot = full.find('.');
  return dot == std::string::npos ? full : full.substr(dot + 1);
}

void Block::set_phase(unsigned phase) {
  next_phase_ = phase;
  phase_from_ = domain_.now() + 1;
  attention_ = true;
  domain_.wake(*this, phase_from_);
}

void Block::enter_phase(unsigned phase) {
  phase_ = phase;
  for (std::size_t i = 0; i < state_count; ++i) in_phase_[i] = static_cast<State>(i);
  if ((phases_ & phase_) == 0) in_phase_[static_cast<std::size_t>(State::stall_in)] = State::idle;
}

void Block::begin_frame(Cycle now) {
  cycles_.fill(0);
  state_ = last_ = State::idle;
  since_ = now;
  next_phase_ = 1;
  phase_from_ = 0;
  enter_phase(1);
  attention_ = log_level_ != LogLevel::off;
}

/// What few ticks need: a phase that begins, a log.
Activity Block::tick_with_attention(Cycle now) {
  const State before = state_;
  const unsigned phase_before = phase_;
  if (now >= phase_from_ && phase_ != next_phase_) enter_phase(next_phase_);
  attention_ = phase_ != next_phase_ || log_level_ != LogLevel::off;
  const Activity activity = tick(now);
  if (log_level_ != LogLevel::off) log_change(now, before, activity, phase_before);
  return activity;
}

const char* state_name(State state) {
  static const char* const names[state_count] = {"busy", "stall_in", "stall_out", "stall_mem", "idle"};
  return names[static_cast<std::size_t>(state)];
}

void Block::log_change(Cycle now, State before, const Activity& activity, unsigned phase_before) const {
  const State state = in_phase(activity.state), after = in_phase(activity.after);
  std::string what;
  if (phase_ != phase_before) what = std::string("phase ") + phase_name(phase_);
  if (log_level_ == LogLevel::debug && (state != before || after != state)) {
    what += (what.empty() ? "" : ", ") + std::string(state_name(state));
    if (after != state) what += " for a cycle, then " + std::string(state_name(after));
  }
  if (what.empty()) return;
  const std::string detail = describe();
  (*log_sink_)(std::to_string(now) + " " + path() + ": " + what + (detail.empty() ? "" : "; " + detail));
}

}  // namespace artu::hw

// The SystemC library wants this symbol from every program; here the kernel is driven by sc_start alone.
int sc_main(int, char*[]) { return 0; }
