// A timed channel: latency, capacity, back-pressure; one producer, one consumer.
//
// What is pushed in a cycle can be popped `latency` cycles later (at least one), what is popped in a cycle
// frees its entry for the producer in the next: so the order in which the blocks of a cycle are ticked
// cannot matter.  A push wakes the consumer, a pop wakes a producer that found the channel full.
// Producer and consumer may be in different clock domains; the latency is in the consumer's cycles.
#pragma once

#include <cassert>
#include <random>
#include <string>
#include <vector>

#include "hw/fabric/clock_domain.h"

namespace artu::hw {

/// What all channels have in common: names and ends for the picture of a dead-lock, random stalls.
class Channel {
 public:
  Channel(std::string name, std::uint32_t capacity, std::uint32_t latency)
      : name_(std::move(name)), capacity_(capacity), latency_(latency) {}
  virtual ~Channel() = default;
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;

  void bind(Block& producer, Block& consumer) {
    producer_ = &producer;
    consumer_ = &consumer;
    timeline_ = &producer.domain().timeline();
    producer_domain_ = &producer.domain();
    consumer_domain_ = &consumer.domain();
    consumer_now_ = consumer_domain_->clock();
    same_domain_ = producer_domain_ == consumer_domain_;
    rare_kind_ = stalls_ || !same_domain_;
    timeline_->channels.push_back(this);
  }
  virtual void reset() = 0;
  /// Keeps a bit of `word` set while anything is in the channel: its consumer need not look at empty ones.
  void flag(std::uint64_t& word, unsigned bit) {
    flags_ = &word;
    flag_ = std::uint64_t{1} << bit;
  }
  /// Adds a random latency to pushes; order is kept.
  void stall_randomly(std::uint64_t seed) {
    stalls_ = rare_kind_ = true;
    seed_ = seed;
  }

  const std::string& name() const { return name_; }
  std::uint32_t capacity() const { return capacity_; }
  std::uint32_t size() const { return tail_ - head_; }
  /// Pushes and pops so far: the watchdog looks whether any have been made.
  std::uint64_t moves() const { return std::uint64_t{head_} + tail_; }
  std::uint32_t pops() const { return head_; }
  std::uint32_t pushes() const { return tail_; }
  const Block* producer() const { return producer_; }
  const Block* consumer() const { return consumer_; }

 protected:
  /// Now, in the consumer's cycles: the last one that began.
  Cycle consumer_cycle() const { return consumer_domain_->cycle_after(timeline_->now) - 1; }
  /// The producer's next cycle.
  Cycle producer_next() const {
    return same_domain_ ? *consumer_now_ + 1 : producer_domain_->cycle_after(timeline_->now);
  }
  /// When a token that is pushed now arrives, where that is not just a number of the present cycle: between domains, or
  /// with random stalls.
  Cycle arrival_of_rare_kind() {
    const Cycle ready = consumer_cycle() + latency_;
    return stalls_ && random_() % 4 == 0 ? ready + random_() % 16 : ready;
  }

  std::string name_;
  std::uint64_t seed_ = 0;
  std::minstd_rand random_;
  std::uint64_t own_flags_ = 0;
  Block* producer_ = nullptr;
  Block* consumer_ = nullptr;
  ClockDomain* producer_domain_ = nullptr;
  bool same_domain_ = true, stalls_ = false;
  // What every push and pop needs comes last, beside the entries of the derived class.
  Cycle arrival_ = never;  // of the first token
  const Cycle* consumer_now_ = nullptr;
  ClockDomain* consumer_domain_ = nullptr;
  Timeline* timeline_ = nullptr;
  std::uint64_t* flags_ = &own_flags_;
  std::uint64_t flag_ = 0;
  std::uint32_t capacity_, latency_;
  std::uint32_t head_ = 0, tail_ = 0;  // tokens popped and pushed so far
  bool rare_kind_ = false;             // see above
};

template <class Token>
class Fifo : public Channel {
 public:
  /// `capacity` entries, those in flight included; `latency` >= 1 cycles of the consumer's clock.
  Fifo(std::string name, std::uint32_t capacity, std::uint32_t latency = 1)
      : Channel(std::move(name), capacity, latency) {
    std::size_t physical = 1;
    while (physical < capacity) physical *= 2;
    entries_.resize(physical);
    mask_ = static_cast<std::uint32_t>(physical - 1);
  }

  void reset() override {
    head_ = tail_ = 0;
    arrival_ = never;
    *flags_ &= ~flag_;
    head_before_ = 0;
    last_pop_ = never;
    last_ready_ = 0;
    producer_waits_ = false;
    random_.seed(static_cast<std::minstd_rand::result_type>(seed_));
  }

  /// Producer: whether there is room for `n` more.  If not, the producer is woken when an entry is freed.
  bool can_push(std::uint32_t n = 1) {
    // An entry that was freed in this very cycle is no room yet, whoever was ticked first; it will be in the next.
    const std::uint32_t head = last_pop_ == timeline_->now ? head_before_ : head_;
    if (tail_ - head + n <= capacity_) return true;
    wait_for_room();
    return false;
  }

  /// `extra` cycles on top of the channel's latency must not let a token overtake an earlier one.
  void push(const Token& token, std::uint32_t extra = 0) {
    assert(tail_ - head_ < capacity_);
    Cycle ready = (rare_kind_ ? arrival_of_rare_kind() : *consumer_now_ + latency_) + extra;
    if (ready < last_ready_) ready = last_ready_;
    last_ready_ = ready;
    if (head_ == tail_) arrival_ = ready;
    Entry& entry = entries_[tail_++ & mask_];
    entry.ready = ready;
    entry.token = token;
    *flags_ |= flag_;
    consumer_domain_->wake(*consumer_, ready);
  }

  /// For who watches: the token of the push with this number, from 0 on, and when it arrives.  Known while the token is
  /// in the channel, and to the end of the cycle in which it is popped.
  const Token& pushed(std::uint32_t number) const { return entries_[number & mask_].token; }
  Cycle arrival(std::uint32_t number) const { return entries_[number & mask_].ready; }

  /// Consumer: whether a token has arrived.
  bool can_pop() const { return arrival_ <= *consumer_now_; }
  const Token& front() const { return entries_[head_ & mask_].token; }
  void pop() {
    if (last_pop_ != timeline_->now) {
      last_pop_ = timeline_->now;
      head_before_ = head_;
    }
    if (++head_ == tail_) {
      arrival_ = never;
      *flags_ &= ~flag_;
    } else {
      arrival_ = entries_[head_ & mask_].ready;
    }
    if (producer_waits_) {
      producer_waits_ = false;
      producer_domain_->wake(*producer_, producer_next());
    }
  }

 private:
  struct Entry {
    Cycle ready;
    Token token;
  };
  void wait_for_room() {
    if (last_pop_ == timeline_->now) producer_domain_->wake(*producer_, producer_domain_->now() + 1);
    producer_waits_ = true;
  }

  std::uint32_t mask_ = 0;
  std::uint32_t head_before_ = 0;  // of the cycle of the last pop, before it
  bool producer_waits_ = false;
  std::vector<Entry> entries_;
  Tick last_pop_ = never;
  Cycle last_ready_ = 0;
};

}  // namespace artu::hw
