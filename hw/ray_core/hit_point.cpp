#include "hw/ray_core/hit_point.h"

namespace artu::hw {

void HitPoint::reset() {
  second_ = false;
  outstanding_ = 0;
  hits_ = 0;
}

Address HitPoint::record(const RayContext& context, Address static_base, Address dynamic_base) const {
  return (context.dynamic ? dynamic_base : static_base) + Address{context.best_triangle} * line_bytes;
}

void HitPoint::compute(RayContext& context) {
  const FrameDescriptor& frame = registers_.descriptor;
  const auto& triangle =
      image_.at<TriangleRecord>(record(context, frame.static_triangles, frame.dynamic_triangles));
  const auto& attributes =
      image_.at<AttributeRecord>(record(context, frame.static_attributes, frame.dynamic_attributes));
  context.surface = surface_at(context.ray, context.best, triangle, attributes);
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
      const FrameDescriptor& frame = registers_.descriptor;
      const Address line = second_ ? record(context, frame.static_attributes, frame.dynamic_attributes)
                                   : record(context, frame.static_triangles, frame.dynamic_triangles);
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
