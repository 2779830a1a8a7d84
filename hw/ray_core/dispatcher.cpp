#include "hw/ray_core/dispatcher.h"

namespace artu::hw {

void Dispatcher::reset() {
  source_arbiter_.reset();
  core_arbiter_.reset();
  pixels_ = 0;
}

Activity Dispatcher::tick(Cycle now) {
  const std::size_t source =
      source_arbiter_.pick(sources_.size(), [&](std::size_t i) { return sources_[i]->can_pop(); });
  if (source == sources_.size()) return {State::stall_in};
  const std::size_t core = core_arbiter_.pick(cores_.size(), [&](std::size_t i) { return cores_[i]->can_push(); });
  if (core == cores_.size()) return {State::stall_out};
  cores_[core]->push(sources_[source]->front());
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
