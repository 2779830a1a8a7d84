#include "hw/ray_core/hit_point.h"

namespace artu::hw {

void HitPoint::reset() {
  second_ = false;
  outstanding_ = 0;
  hits_ = 0;
}

Address HitPoint::triangle_of(const RayContext& context) const {
  const FrameDescriptor& frame = registers_.descriptor;
  const Address base = context.dynamic ? frame.dynamic_triangles : frame.static_triangles;
  return base + Address{context.best_triangle} * sizeof(TriangleRecord);
}

Address HitPoint::attributes_of(const RayContext& context) const {
  const FrameDescriptor& frame = registers_.descriptor;
  const Address base = context.dynamic ? frame.dynamic_attributes : frame.static_attributes;
  return base + Address{context.best_attributes} * sizeof(AttributeRecord);
}

void HitPoint::compute(RayContext& context) {
  const FrameDescriptor& frame = registers_.descriptor;
  const auto& triangle = image_.at<TriangleRecord>(triangle_of(context));
  const auto& attributes = image_.at<AttributeRecord>(attributes_of(context));
  context.surface = surface_at(context.ray, context.best, triangle, attributes, triangle_bits_);
  context.material = frame.materials + Address{triangle.material} * sizeof(MaterialRecord);
  ++hits_;
}

Activity HitPoint::tick(Cycle now) {
  bool moved = false, blocked = false;
  if (triangles_->response.can_pop()) {
    const auto slot = static_cast<Slot>(triangles_->response.front().tag);
    triangles_->response.pop();
    --outstanding_;
    if (--contexts_[slot].outstanding == 0) {
      compute(contexts_[slot]);
      out_->push(slot);
    }
    moved = true;
  }
  if (in_->can_pop()) {
    const Slot slot = in_->front();
    RayContext& context = contexts_[slot];
    if (triangles_->request.can_push()) {
      const Address line = second_ ? attributes_of(context) : triangle_of(context);
      if (!second_) context.outstanding = 2;
      triangles_->request.push({line, 0, slot, 0});
      ++outstanding_;
      if (second_) in_->pop();
      second_ = !second_;
      moved = true;
    } else {
      blocked = true;
    }
  }
  if (moved) {
    if (in_->can_pop() || triangles_->response.can_pop()) return {State::busy, now + 1};
    return Activity::once(State::busy, outstanding_ != 0 ? State::stall_mem : State::stall_in);
  }
  if (blocked || outstanding_ != 0) return {State::stall_mem};
  return {State::stall_in};
}

void HitPoint::report(Statistics& out) const {
  out.push_back({path(), "hit_points", hits_, "", "hits whose surface was computed"});
}

}  // namespace artu::hw
