// What the tests of the hardware blocks stand on: a bench with its own SystemC context, and blocks at its ends.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hw/fabric/memory_port.h"
#include "hw/fabric/simulation_context.h"

namespace artu::hw::test {

/// Ends the run in a given cycle; in no other one it does anything.
class Stopper : public Block {
 public:
  using Block::Block;
  Cycle at = never;
  void reset() override {}

 private:
  Activity tick(Cycle now) override;
};

/// One clock domain (and others if wanted), channels and blocks that live as long as the test.
class Bench {
 public:
  Bench();

  /// Resets everything and runs from cycle 0 to the end of cycle `last` of `clock`.
  void run(Cycle last);
  /// As `run`, without an end: until nothing can happen any more, or the watchdog stops it.
  void run_until_quiet();

  template <class T, class... Args>
  T& block(const char* name, Args&&... args) {
    return block_in<T>(clock, name, std::forward<Args>(args)...);
  }
  template <class T, class... Args>
  T& block_in(ClockDomain& domain, const char* name, Args&&... args) {
    auto made = std::make_unique<T>(name, domain, std::forward<Args>(args)...);
    T& result = *made;
    modules_.push_back(std::move(made));
    return result;
  }
  ClockDomain& domain(const char* name, Tick period);

  template <class Token>
  Fifo<Token>& fifo(const char* name, std::uint32_t capacity, std::uint32_t latency = 1) {
    auto made = std::make_unique<Fifo<Token>>(name, capacity, latency);
    Fifo<Token>& result = *made;
    channels_.push_back(&result);
    owned_.push_back(std::move(made));
    return result;
  }
  /// A link whose channels are bound one by one, or both to the same requester.
  MemoryLink& link(const char* name, std::uint32_t depth, std::uint32_t request_latency,
                   std::uint32_t response_latency);

  const std::vector<Channel*>& channels() const { return channels_; }

 private:
  SimulationContext context_;

 public:
  Timeline timeline;
  ClockDomain clock;

 private:
  Stopper stopper_;
  std::vector<Channel*> channels_;
  std::vector<std::unique_ptr<Channel>> owned_;
  std::vector<std::unique_ptr<MemoryLink>> links_;
  std::vector<std::unique_ptr<sc_core::sc_module>> modules_;
};

/// The cycles of a state since the beginning of the run.
std::vector<std::uint64_t> cycle_classes(const Block& block);
/// A counter of the block by its name; fails the test if there is none.
std::uint64_t counter(const Block& block, const std::string& name);

/// Pushes token k in cycle `at` of the k-th entry, or in the first one after it in which there is room; one a cycle.
template <class Token>
class Source : public Block {
 public:
  Source(sc_core::sc_module_name name, ClockDomain& domain, Fifo<Token>& out) : Block(name, domain), out_(out) {}

  Source& push_at(Cycle at, const Token& token) {
    script_.push_back({at, token});
    return *this;
  }
  /// From cycle `first` on, one token a cycle.
  Source& push_all(Cycle first, const std::vector<Token>& tokens) {
    for (const Token& token : tokens) push_at(first++, token);
    return *this;
  }
  /// When the tokens were pushed in fact.
  std::vector<Cycle> pushed;

  void reset() override {
    pushed.clear();
    next_ = 0;
  }

 private:
  Activity tick(Cycle now) override {
    if (next_ == script_.size()) return {State::stall_in};
    if (now < script_[next_].first) return {State::stall_in, script_[next_].first};
    if (!out_.can_push()) return {State::stall_out};
    out_.push(script_[next_++].second);
    pushed.push_back(now);
    return {State::busy, now + 1};
  }

  Fifo<Token>& out_;
  std::vector<std::pair<Cycle, Token>> script_;
  std::size_t next_ = 0;
};

/// Pops one token a cycle, in the cycles in which `open` holds, and writes down when.
template <class Token>
class Sink : public Block {
 public:
  Sink(sc_core::sc_module_name name, ClockDomain& domain, Fifo<Token>& in) : Block(name, domain), in_(in) {}

  std::function<bool(Cycle)> open;  // not set: always
  std::vector<Token> tokens;
  std::vector<Cycle> cycles;

  void reset() override {
    tokens.clear();
    cycles.clear();
  }

 private:
  Activity tick(Cycle now) override {
    if (!in_.can_pop()) return {State::stall_in};
    if (open && !open(now)) return {State::stall_in, now + 1};
    tokens.push_back(in_.front());
    cycles.push_back(now);
    in_.pop();
    return {State::busy, now + 1};
  }

  Fifo<Token>& in_;
};

/// Answers every request `latency(request)` cycles after it arrived, takes one request a cycle.
class ScriptedMemory : public Block {
 public:
  /// `response_latency` is that of the link: the answer is pushed so that it arrives in time.
  ScriptedMemory(sc_core::sc_module_name name, ClockDomain& domain, MemoryLink& link, std::uint32_t response_latency,
                 Cycle latency);

  std::function<Cycle(const MemoryRequest&)> latency;
  std::function<bool(Cycle)> open;  // takes requests in these cycles only; not set: always
  std::vector<MemoryRequest> requests;
  std::vector<Cycle> cycles;  // in which the requests were taken

  std::vector<Address> lines() const;
  std::size_t writes() const;
  void reset() override;

 private:
  Activity tick(Cycle now) override;
  MemoryLink& link_;
  const std::uint32_t response_latency_;
  std::multimap<Cycle, MemoryResponse> due_;
};

/// n, n + step, n + 2 * step, ...
std::vector<Cycle> every(Cycle first, std::size_t count, Cycle step = 1);

inline MemoryRequest read_of(Address line, std::uint32_t tag = 0) { return {line, 0, tag, 0}; }
inline MemoryRequest write_of(Address line, std::uint64_t bytes, std::uint32_t tag = 0) {
  return {line, bytes, tag, 0};
}
inline constexpr std::uint64_t whole_line = ~std::uint64_t{0};

}  // namespace artu::hw::test
