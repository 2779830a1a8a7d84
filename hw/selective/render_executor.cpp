#include "hw/selective/render_executor.h"

#include "hw/selective/candidate.h"

namespace artu::hw {

void RenderExecutor::record(const Candidate& candidate, int difference, Decision decision) {
  if (records_ == nullptr) return;
  PixelRecord& record = (*records_)[std::size_t{candidate.y} * registers_.descriptor.width + candidate.x];
  note_decision(candidate, difference, decision, record);
}

Activity RenderExecutor::tick(Cycle now) {
  if (!in_->can_pop()) return {State::stall_in};
  const Candidate& candidate = in_->front();
  const int difference = color_difference(metric_, candidate.pairs);
  if (is_interpolated(candidate.pairs, difference, candidate.threshold)) {
    if (!interpolated_->can_push()) return {State::stall_out};
    const Rgb mean = interpolate(candidate.pairs);
    interpolated_->push(
        {candidate.x, candidate.y, static_cast<std::uint8_t>(mean.r ^ fault_), mean.g, mean.b, HitClass::none});
    ++interpolated_count_;
    record(candidate, difference, Decision::interpolated);
  } else {
    if (!traced_->can_push()) return {State::stall_out};
    traced_->push({candidate.x, candidate.y});
    ++traced_count_;
    record(candidate, difference, Decision::traced);
  }
  differences_ += candidate.kind == PassKind::centre ? 2 : 1;
  in_->pop();
  return {State::busy, now + 1};
}

void RenderExecutor::report(Statistics& out) const {
  out.push_back({path(), "interpolated", interpolated_count_, "pixels", "candidates interpolated"});
  out.push_back({path(), "traced", traced_count_, "pixels", "candidates ray traced"});
  out.push_back({path(), "differences", differences_, "", "colour differences taken, of a centre two"});
}

}  // namespace artu::hw
