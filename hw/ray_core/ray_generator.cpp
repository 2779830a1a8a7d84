#include "hw/ray_core/ray_generator.h"

namespace artu::hw {

void RayGenerator::reset() {
  free_.clear();
  for (std::size_t slot = contexts_.size(); slot-- > 0;) free_.push_back(static_cast<Slot>(slot));
  rays_.fill(0);
  context_cycles_ = 0;
  pixel_was_last_ = false;
}

void RayGenerator::start(Slot slot, const PixelJob& job) {
  RayContext& context = contexts_[slot];
  context.pixel = job;
  context.sum = {};
  context.weight = {1, 1, 1};
  context.kind = RayKind::primary;
  context.depth = 0;
  context.pending.clear();
  context.ray = primary_ray(registers_.descriptor.camera, job.x, job.y);
  if (!is_zero(context.ray.direction)) hit_tests_.set_up(context.ray);
}

bool RayGenerator::pixel_goes_first() const {
  return order_ == RayOrder::primary_first || (order_ == RayOrder::first_come && !pixel_was_last_);
}

void RayGenerator::next_ray(Cycle now) {
  const Slot slot = next_rays_->front();
  next_rays_->pop();
  hit_tests_.set_up(contexts_[slot].ray);
  contexts_[slot].arrival = now;
  ++rays_[static_cast<std::size_t>(contexts_[slot].kind)];
  others_->push(slot);
  pixel_was_last_ = false;
}

void RayGenerator::new_pixel(Cycle now) {
  const Slot slot = free_.back();
  free_.pop_back();
  start(slot, jobs_->front());
  contexts_[slot].since = contexts_[slot].arrival = now;
  jobs_->pop();
  ++rays_[static_cast<std::size_t>(RayKind::primary)];
  primary_->push(slot);
  pixel_was_last_ = true;
}

Activity RayGenerator::tick(Cycle now) {
  bool moved = false;
  if (freed_->can_pop()) {
    const Slot slot = freed_->front();
    free_.push_back(slot);
    freed_->pop();
    context_cycles_ += now - contexts_[slot].since;
    moved = true;
  }
  const bool next = next_rays_->can_pop() && others_->can_push();
  const bool pixel = (!next || pixel_goes_first()) && jobs_->can_pop() && !free_.empty() && primary_->can_push();
  if (pixel) {
    new_pixel(now);
    moved = true;
  } else if (next) {
    next_ray(now);
    moved = true;
  }
  if (moved) {
    const bool left = next_rays_->can_pop() || freed_->can_pop() || (jobs_->can_pop() && !free_.empty());
    return left ? Activity(State::busy, now + 1) : Activity::once(State::busy, State::stall_in);
  }
  return {State::stall_in};
}

void RayGenerator::report(Statistics& out) const {
  static const char* const names[ray_kinds] = {"primary_rays", "shadow_rays", "reflection_rays", "refraction_rays"};
  for (std::size_t kind = 0; kind < ray_kinds; ++kind) {
    out.push_back({path(), names[kind], rays_[kind], "rays", "rays of this kind that were set up"});
  }
  out.push_back({path(), "context_cycles", context_cycles_, "cycles", "pixels were in flight, summed over them"});
}

std::string RayGenerator::describe() const {
  return std::to_string(free_.size()) + " of " + std::to_string(contexts_.size()) + " contexts free";
}

}  // namespace artu::hw
