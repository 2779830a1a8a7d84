#include "hw/memory/interconnect.h"

namespace artu::hw {

void Interconnect::flag_requests() {
  waiting_.assign(masters_.size() / 64 + 1, 0);
  for (std::size_t i = 0; i < masters_.size(); ++i) {
    masters_[i]->request.flag(waiting_[i / 64], static_cast<unsigned>(i % 64));
  }
}

void Interconnect::reset() {
  for (RoundRobin& arbiter : arbiters_) arbiter.reset();
  asked_.assign(masters_.size(), never);
  answered_.assign(masters_.size(), never);
  first_memory_ = 0;
  requests_ = responses_ = conflicts_ = 0;
}

bool Interconnect::pass_request(std::size_t memory, Cycle now, bool& blocked) {
  RoundRobin& arbiter = arbiters_[memory];
  const std::size_t chosen = arbiter.pick(waiting_, masters_.size(), [&](std::size_t i) {
    const Fifo<MemoryRequest>& requests = masters_[i]->request;
    return requests.can_pop() && memory_of(requests.front().line) == memory && asked_[i] != now;
  });
  if (chosen == masters_.size()) return false;
  if (!memories_[memory]->request.can_push()) {
    blocked = true;
    return false;
  }
  MemoryRequest request = masters_[chosen]->request.front();
  request.source = static_cast<std::uint16_t>(chosen);
  masters_[chosen]->request.pop();
  asked_[chosen] = now;
  memories_[memory]->request.push(request);
  arbiter.granted(chosen, masters_.size());
  ++requests_;
  return true;
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
  bool moved = false, blocked = false, left = false;
  const std::size_t memories = memories_.size();
  for (std::size_t i = 0; i < memories; ++i) moved |= pass_request(i, now, blocked);
  for (std::size_t i = 0; i < memories; ++i) {
    moved |= pass_response((first_memory_ + i) & (memories - 1), now, blocked);
  }
  if (!moved) return {blocked ? State::stall_out : State::stall_in};
  first_memory_ = (first_memory_ + 1) & (memories - 1);
  for (const MemoryLink* memory : memories_) left |= memory->response.can_pop();
  for (std::uint64_t word : waiting_) left |= word != 0;
  return left ? Activity(State::busy, now + 1) : Activity::once(State::busy, State::stall_in);
}

void Interconnect::report(Statistics& out) const {
  out.push_back({path(), "requests", requests_, "", "requests passed down"});
  out.push_back({path(), "responses", responses_, "", "responses passed up"});
  out.push_back({path(), "conflicts", conflicts_, "", "responses held back since their master got one in that cycle"});
}

}  // namespace artu::hw
