#include "hw/selective/first_rendering_unit.h"

namespace artu::hw {

void FirstRenderingUnit::reset() {
  active_ = false;
  pixels_ = 0;
}

Activity FirstRenderingUnit::tick(Cycle now) {
  if (!active_) {
    if (!command_->can_pop()) return {State::stall_in};
    const std::uint32_t stride = command_->front().stride;
    command_->pop();
    const FrameDescriptor& frame = registers_.descriptor;
    walk_ = TileWalk(frame.width, frame.height, config_.tile, 0, stride, 0, stride);
    x_ = walk_.span().begin;
    active_ = true;
    return {State::busy, now + 1};
  }
  if (!jobs_->can_push()) return {State::stall_out};
  const TileWalk::Span span = walk_.span();
  jobs_->push({static_cast<std::uint16_t>(x_), static_cast<std::uint16_t>(span.y)});
  if (records_ != nullptr) {
    (*records_)[std::size_t{span.y} * registers_.descriptor.width + x_].decision = Decision::sampled;
  }
  ++pixels_;
  x_ += walk_.dx();
  if (x_ >= span.end) {
    walk_.next();
    active_ = !walk_.done();
    if (active_) x_ = walk_.span().begin;
  }
  return {State::busy, now + 1};
}

void FirstRenderingUnit::report(Statistics& out) const {
  out.push_back({path(), "pixels", pixels_, "pixels", "sampling pixels sent to the ray cores"});
}

}  // namespace artu::hw
