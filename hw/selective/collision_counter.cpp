#include "hw/selective/collision_counter.h"

namespace artu::hw {

Activity CollisionCounter::tick(Cycle now) {
  if (!in_->can_pop()) return {State::stall_in};
  if (!out_->can_push()) return {State::stall_out};
  Candidate candidate = in_->front();
  in_->pop();
  candidate.counts = count_hits(candidate.ring);
  static_ += candidate.counts.n_static;
  dynamic_ += candidate.counts.n_dynamic;
  out_->push(candidate);
  return {State::busy, now + 1};
}

void CollisionCounter::report(Statistics& out) const {
  out.push_back({path(), "static_hits", static_, "", "static neighbours counted"});
  out.push_back({path(), "dynamic_hits", dynamic_, "", "dynamic neighbours counted"});
}

}  // namespace artu::hw
