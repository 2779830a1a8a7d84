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
    walk_ = PixelWalk(order_, frame.width, frame.height, config_.tile, stride);
    active_ = true;
    return {State::busy, now + 1};
  }
  if (!jobs_->can_push()) return {State::stall_out};
  jobs_->push({static_cast<std::uint16_t>(walk_.x()), static_cast<std::uint16_t>(walk_.y())});
  if (records_ != nullptr) {
    (*records_)[std::size_t{walk_.y()} * registers_.descriptor.width + walk_.x()].decision = Decision::sampled;
  }
  ++pixels_;
  walk_.next();
  active_ = !walk_.done();
  return {State::busy, now + 1};
}

void FirstRenderingUnit::report(Statistics& out) const {
  out.push_back({path(), "pixels", pixels_, "pixels", "sampling pixels sent to the ray cores"});
}

}  // namespace artu::hw
