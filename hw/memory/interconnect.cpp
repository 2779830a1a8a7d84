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
  known_.assign(waiting_.size(), 0);
  wanted_.assign(waiting_.size() * memories_.size(), 0);
  asked_ = 0;
  first_memory_ = 0;
  requests_ = responses_ = conflicts_ = 0;
}

/// A request is looked at once, when it arrives: which memory it is for.
void Interconnect::look_at_arrivals() {
  const std::size_t words = waiting_.size();
  for (std::size_t word = 0; word < words; ++word) {
    for (std::uint64_t bits = waiting_[word] & ~known_[word]; bits != 0; bits &= bits - 1) {
      const std::uint64_t bit = bits & -bits;
      const Fifo<MemoryRequest>& requests =
          masters_[word * 64 + static_cast<std::size_t>(__builtin_ctzll(bits))]->request;
      if (!requests.can_pop()) continue;
      const std::size_t memory = memory_of(requests.front().line);
      known_[word] |= bit;
      wanted_[memory * words + word] |= bit;
      asked_ |= 1u << memory;
    }
  }
}

/// Of those that ask for the memory the first from its arbiter's pointer on, or else the first.
std::size_t Interconnect::next_master(std::size_t memory) const {
  const std::size_t words = waiting_.size(), pointer = arbiters_[memory].pointer();
  const std::uint64_t* wanted = &wanted_[memory * words];
  std::uint64_t bits = wanted[pointer / 64] & (~std::uint64_t{0} << (pointer % 64));
  for (std::size_t word = pointer / 64;;) {
    if (bits != 0) return word * 64 + static_cast<std::size_t>(__builtin_ctzll(bits));
    word = word + 1 == words ? 0 : word + 1;
    bits = wanted[word];
  }
}

bool Interconnect::pass_requests(bool& blocked, bool& left) {
  look_at_arrivals();
  const std::size_t words = waiting_.size();
  bool moved = false;
  for (std::uint32_t asked = asked_; asked != 0; asked &= asked - 1) {
    const auto memory = static_cast<std::size_t>(__builtin_ctz(asked));
    Fifo<MemoryRequest>& down = memories_[memory]->request;
    if (!down.can_push()) {
      blocked = true;
      continue;
    }
    const std::size_t master = next_master(memory);
    Fifo<MemoryRequest>& requests = masters_[master]->request;
    MemoryRequest request = requests.front();
    request.source = static_cast<std::uint16_t>(master);
    requests.pop();
    left |= requests.can_pop();
    down.push(request);
    arbiters_[memory].granted(master, masters_.size());
    ++requests_;
    moved = true;
    const std::uint64_t others = ~(std::uint64_t{1} << (master % 64));
    known_[master / 64] &= others;
    wanted_[memory * words + master / 64] &= others;
    bool any = false;
    for (std::size_t word = 0; word < words; ++word) any |= wanted_[memory * words + word] != 0;
    if (!any) asked_ &= ~(1u << memory);
  }
  left |= asked_ != 0;
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
