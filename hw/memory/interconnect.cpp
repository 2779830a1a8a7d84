#include "hw/memory/interconnect.h"

namespace artu::hw {

void Interconnect::flag_requests() {
  waiting_.assign(masters_.size() / 64 + 1, 0);
  for (std::size_t i = 0; i < masters_.size(); ++i) {
    masters_[i]->request.flag(waiting_[i / 64], static_cast<unsigned>(i % 64));
  }
}

void Interconnect::reset() {
  arbiter_.reset();
  requests_ = responses_ = 0;
}

Activity Interconnect::tick(Cycle now) {
  bool moved = false, blocked = false;
  const std::size_t chosen =
      arbiter_.pick(waiting_, masters_.size(), [&](std::size_t i) { return masters_[i]->request.can_pop(); });
  if (chosen != masters_.size()) {
    if (below_->request.can_push()) {
      MemoryRequest request = masters_[chosen]->request.front();
      request.source = static_cast<std::uint16_t>(chosen);
      masters_[chosen]->request.pop();
      below_->request.push(request);
      arbiter_.granted(chosen, masters_.size());
      ++requests_;
      moved = true;
    } else {
      blocked = true;
    }
  }
  if (below_->response.can_pop()) {
    const MemoryResponse response = below_->response.front();
    Fifo<MemoryResponse>& up = masters_[response.source]->response;
    if (up.can_push()) {
      up.push(response);
      below_->response.pop();
      ++responses_;
      moved = true;
    } else {
      blocked = true;
    }
  }
  if (moved) {
    bool left = below_->response.can_pop();
    for (std::uint64_t word : waiting_) left |= word != 0;
    return left ? Activity(State::busy, now + 1) : Activity::once(State::busy, State::stall_in);
  }
  return {blocked ? State::stall_out : State::stall_in};
}

void Interconnect::report(Statistics& out) const {
  out.push_back({path(), "requests", requests_, "", "requests passed to the L2"});
  out.push_back({path(), "responses", responses_, "", "responses passed to the masters"});
}

}  // namespace artu::hw
