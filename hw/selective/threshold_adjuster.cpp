#include "hw/selective/threshold_adjuster.h"

namespace artu::hw {

Activity ThresholdAdjuster::tick(Cycle now) {
  if (!in_->can_pop()) return {State::stall_in};
  if (!out_->can_push()) return {State::stall_out};
  Candidate candidate = in_->front();
  in_->pop();
  candidate.threshold = static_cast<std::uint8_t>(policy_.threshold(candidate, config_) ^ fault_);
  lowered_ += candidate.threshold < config_.reference;
  raised_ += candidate.threshold > config_.reference;
  out_->push(candidate);
  return {State::busy, now + 1};
}

void ThresholdAdjuster::report(Statistics& out) const {
  out.push_back({path(), "lowered", lowered_, "pixels", "candidates whose threshold is below the reference"});
  out.push_back({path(), "raised", raised_, "pixels", "candidates whose threshold is above the reference"});
}

}  // namespace artu::hw
