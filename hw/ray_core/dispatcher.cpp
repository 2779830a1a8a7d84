#include "hw/ray_core/dispatcher.h"

namespace artu::hw {

void Dispatcher::reset() {
  source_arbiter_.reset();
  core_arbiter_.reset();
  pixels_ = 0;
}

/// The core that the pixel goes to; the number of cores if none that may have it has room.
std::size_t Dispatcher::core_for(const PixelJob& pixel) {
  if (policy_ == Dispatch::first_come) {
    return core_arbiter_.pick(cores_.size(), [&](std::size_t i) { return cores_[i]->can_push(); });
  }
  const std::uint32_t columns = (registers_.descriptor.width + tile_ - 1) / tile_;
  const std::size_t core = (pixel.y / tile_ * columns + pixel.x / tile_) % cores_.size();
  return cores_[core]->can_push() ? core : cores_.size();
}

Activity Dispatcher::tick(Cycle now) {
  const std::size_t source =
      source_arbiter_.pick(sources_.size(), [&](std::size_t i) { return sources_[i]->can_pop(); });
  if (source == sources_.size()) return {State::stall_in};
  const std::size_t core = core_for(sources_[source]->front());
  if (core == cores_.size()) return {State::stall_out};
  const PixelJob& pixel = sources_[source]->front();
  if (records_ != nullptr) {
    (*records_)[std::size_t{pixel.y} * registers_.descriptor.width + pixel.x].cycles = static_cast<std::uint32_t>(now);
  }
  cores_[core]->push(pixel);
  sources_[source]->pop();
  source_arbiter_.granted(source, sources_.size());
  core_arbiter_.granted(core, cores_.size());
  ++pixels_;
  return {State::busy, now + 1};
}

void Dispatcher::report(Statistics& out) const {
  out.push_back({path(), "pixels", pixels_, "pixels", "pixels handed to the cores"});
}

}  // namespace artu::hw
