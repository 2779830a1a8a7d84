#include "unit/hw/support.h"

namespace artu::hw::test {

Activity Stopper::tick(Cycle now) {
  if (now == at) {
    domain().finish();
    return {State::idle};
  }
  return {State::idle, at > now ? at : never};
}

Bench::Bench() : clock("clock", timeline, 1, 1e-9), stopper_("stopper", clock) {}

void Bench::run(Cycle last) {
  stopper_.at = last;
  run_until_quiet();
  for (ClockDomain* domain : timeline.domains) domain->end_frame(last * clock.period() / domain->period());
}

void Bench::run_until_quiet() {
  context_.enter();
  for (Channel* channel : channels_) channel->reset();
  timeline.now = 0;
  for (ClockDomain* domain : timeline.domains) domain->begin_frame();
  sc_core::sc_start();
  stopper_.at = never;
}

ClockDomain& Bench::domain(const char* name, Tick period) {
  auto made = std::make_unique<ClockDomain>(name, timeline, period, 1e-9);
  ClockDomain& result = *made;
  modules_.push_back(std::move(made));
  return result;
}

MemoryLink& Bench::link(const char* name, std::uint32_t depth, std::uint32_t request_latency,
                        std::uint32_t response_latency) {
  links_.push_back(std::make_unique<MemoryLink>(name, depth, request_latency, response_latency));
  channels_.push_back(&links_.back()->request);
  channels_.push_back(&links_.back()->response);
  return *links_.back();
}

std::vector<std::uint64_t> cycle_classes(const Block& block) {
  std::vector<std::uint64_t> classes;
  for (std::size_t s = 0; s < state_count; ++s) classes.push_back(block.cycles_in(static_cast<State>(s)));
  return classes;
}

std::uint64_t counter(const Block& block, const std::string& name) {
  Statistics statistics;
  block.report(statistics);
  for (const Statistic& s : statistics) {
    if (s.name == name) return s.value;
  }
  ADD_FAILURE() << block.path() << " has no counter " << name;
  return 0;
}

ScriptedMemory::ScriptedMemory(sc_core::sc_module_name name, ClockDomain& domain, MemoryLink& link,
                               std::uint32_t response_latency, Cycle latency)
    : Block(name, domain),
      latency([latency](const MemoryRequest&) { return latency; }),
      link_(link),
      response_latency_(response_latency) {}

std::vector<Address> ScriptedMemory::lines() const {
  std::vector<Address> lines;
  for (const MemoryRequest& request : requests) lines.push_back(request.line);
  return lines;
}

std::size_t ScriptedMemory::writes() const {
  std::size_t count = 0;
  for (const MemoryRequest& request : requests) count += request.write() ? 1 : 0;
  return count;
}

void ScriptedMemory::reset() {
  requests.clear();
  cycles.clear();
  due_.clear();
}

Activity ScriptedMemory::tick(Cycle now) {
  bool moved = false;
  if (link_.request.can_pop() && (!open || open(now))) {
    const MemoryRequest request = link_.request.front();
    link_.request.pop();
    requests.push_back(request);
    cycles.push_back(now);
    due_.emplace(now + latency(request) - response_latency_, MemoryResponse{request.tag, request.source});
    moved = true;
  }
  while (!due_.empty() && due_.begin()->first <= now && link_.response.can_push()) {
    link_.response.push(due_.begin()->second);
    due_.erase(due_.begin());
    moved = true;
  }
  if (moved) return {State::busy, now + 1};
  if (link_.request.can_pop()) return {State::stall_in, now + 1};
  return {State::stall_in, due_.empty() ? never : std::max(due_.begin()->first, now + 1)};
}

std::vector<Cycle> every(Cycle first, std::size_t count, Cycle step) {
  std::vector<Cycle> cycles;
  for (std::size_t i = 0; i < count; ++i) cycles.push_back(first + i * step);
  return cycles;
}

}  // namespace artu::hw::test
