#include "hw/memory/interconnect.h"

namespace artu::hw {

void Interconnect::flag_channels() {
  waiting_.assign(masters_.size() / 64 + 1, 0);
  for (std::size_t i = 0; i < masters_.size(); ++i) {
    masters_[i]->request.flag(waiting_[i / 64], static_cast<unsigned>(i % 64));
  }
  for (std::size_t i = 0; i < memories_.size(); ++i) {
    memories_[i]->response.flag(answering_, static_cast<unsigned>(i));
  }
}

void Interconnect::reset() {
  for (RoundRobin& arbiter : arbiters_) arbiter.reset();
  answered_.assign(masters_.size(), never);
  first_memory_ = 0;
  requests_ = responses_ = conflicts_ = 0;
}

/// One look at every master that waits: for each memory the first from its arbiter's pointer on, or else the first.
bool Interconnect::pass_requests(bool& blocked, bool& left) {
  std::array<std::size_t, maximum_memories> chosen;
  std::size_t ready = 0;
  std::uint32_t asked = 0;  // memories, and so those whose entry above means something
  for (std::size_t word = 0; word < waiting_.size(); ++word) {
    for (std::uint64_t bits = waiting_[word]; bits != 0; bits &= bits - 1) {
      const std::size_t i = word * 64 + static_cast<std::size_t>(__builtin_ctzll(bits));
      const Fifo<MemoryRequest>& requests = masters_[i]->request;
      if (!requests.can_pop()) continue;
      const std::size_t memory = memory_of(requests.front().line);
      ++ready;
      if ((asked >> memory & 1) == 0) {
        chosen[memory] = i;
        asked |= 1u << memory;
      } else if (const std::size_t pointer = arbiters_[memory].pointer(); chosen[memory] < pointer && i >= pointer) {
        chosen[memory] = i;
      }
    }
  }
  bool moved = false;
  std::size_t granted = 0;
  for (; asked != 0; asked &= asked - 1) {
    const auto memory = static_cast<std::size_t>(__builtin_ctz(asked));
    const std::size_t master = chosen[memory];
    Fifo<MemoryRequest>& down = memories_[memory]->request;
    if (!down.can_push()) {
      blocked = true;
      continue;
    }
    MemoryRequest request = masters_[master]->request.front();
    request.source = static_cast<std::uint16_t>(master);
    masters_[master]->request.pop();
    left |= masters_[master]->request.can_pop();
    ++granted;
    down.push(request);
    arbiters_[memory].granted(master, masters_.size());
    ++requests_;
    moved = true;
  }
  left |= granted != ready;
  return moved;
}

bool Interconnect::pass_response(std::size_t memory, Cycle now, bool& blocked) {
  Fifo<MemoryResponse>& responses = memories_[memory]->response;
  if (!responses.can_pop()) return false;
  const MemoryResponse response = responses.front();
  Fifo<MemoryResponse>& up = masters_[response.source]->response;
  if (answered_[response.source] == now) {
    ++conflicts_;
    return false;
  }
  if (!up.can_push()) {
    blocked = true;
    return false;
  }
  up.push(response);
  responses.pop();
  answered_[response.source] = now;
  ++responses_;
  return true;
}

Activity Interconnect::tick(Cycle now) {
  // What is on its way wakes the block when it arrives; `left` is what could go on in the next cycle.
  bool blocked = false, left = false;
  bool moved = pass_requests(blocked, left);
  if (answering_ != 0) {
    for (std::size_t i = 0; i <= last_memory_; ++i) {
      const std::size_t memory = (first_memory_ + i) & last_memory_;
      if ((answering_ >> memory & 1) == 0) continue;
      moved |= pass_response(memory, now, blocked);
      left |= memories_[memory]->response.can_pop();
    }
  }
  if (!moved) return {blocked ? State::stall_out : State::stall_in};
  first_memory_ = (first_memory_ + 1) & last_memory_;
  return left ? Activity(State::busy, now + 1) : Activity::once(State::busy, State::stall_in);
}

void Interconnect::report(Statistics& out) const {
  out.push_back({path(), "requests", requests_, "", "requests passed down"});
  out.push_back({path(), "responses", responses_, "", "responses passed up"});
  out.push_back({path(), "conflicts", conflicts_, "", "responses held back since their master got one in that cycle"});
}

}  // namespace artu::hw
