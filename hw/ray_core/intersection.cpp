#include "hw/ray_core/intersection.h"

#include <algorithm>

namespace artu::hw {

void Intersection::reset() {
  fetching_ = false;
  outstanding_ = 0;
  tester_free_ = 0;
  tests_ = hits_ = left_out_ = 0;
}

void Intersection::test(Slot slot, std::uint32_t index) {
  RayContext& context = contexts_[slot];
  const bool dynamic = NodeReference::is_dynamic(leaves_[slot].leaf);
  const FrameDescriptor& frame = registers_.descriptor;
  const std::uint32_t triangle = NodeReference::first(leaves_[slot].leaf) + index;
  const TriangleRecord& record = image_.at<TriangleRecord>(
      (dynamic ? frame.dynamic_triangles : frame.static_triangles) + Address{triangle} * sizeof(TriangleRecord));
  ++tests_;
  TriangleHit hit;
  if (!hit_tests_.triangle(context.ray, record.a, record.b, record.c, hit)) return;
  ++hits_;
  if (fault_ != 0) hit.t = float_of(bits_of(hit.t) ^ fault_);
  if (context.found && !nearer(hit, record.primitive, context.best, context.best_primitive)) return;
  context.found = true;
  context.best = hit;
  context.best_primitive = record.primitive;
  context.best_triangle = triangle;
  context.best_attributes = record.attributes;
  context.dynamic = dynamic;
}

Activity Intersection::tick(Cycle now) {
  bool moved = false;
  bool blocked = false;
  const bool arrived = triangles_->response.can_pop();
  if (arrived && now >= tester_free_) {
    tester_free_ = now + interval_;
    // The tag holds the slot and the triangle's place in its leaf.
    const std::uint32_t tag = triangles_->response.front().tag;
    triangles_->response.pop();
    --outstanding_;
    const auto slot = static_cast<Slot>(tag >> 8);
    Leaf& leaf = leaves_[slot];
    test(slot, tag & 255);
    ++leaf.answered;
    if (registers_.skip.any_hit && contexts_[slot].kind == RayKind::shadow && contexts_[slot].found &&
        leaf.count > leaf.fetched) {
      left_out_ += leaf.count - leaf.fetched;
      leaf.count = leaf.fetched;
      if (fetching_ && fetch_slot_ == slot) fetching_ = false;
    }
    if (leaf.answered == leaf.count) tested_->push(slot);
    moved = true;
  }
  if (!fetching_ && in_->can_pop()) {
    const LeafTask task = in_->front();
    in_->pop();
    leaves_[task.slot] = {task.leaf, 0, 0, NodeReference::count(task.leaf)};
    fetching_ = true;
    fetch_slot_ = task.slot;
    moved = true;
  }
  if (fetching_) {
    Leaf& leaf = leaves_[fetch_slot_];
    if (triangles_->request.can_push()) {
      const FrameDescriptor& frame = registers_.descriptor;
      const Address base = NodeReference::is_dynamic(leaf.leaf) ? frame.dynamic_triangles : frame.static_triangles;
      const Address index = NodeReference::first(leaf.leaf) + leaf.fetched;
      triangles_->request.push(
          {base + index * sizeof(TriangleRecord), 0, std::uint32_t{fetch_slot_} << 8 | leaf.fetched, 0});
      ++outstanding_;
      if (++leaf.fetched == leaf.count) fetching_ = false;
      moved = true;
    } else {
      blocked = true;
    }
  }
  if (moved) {
    if (fetching_ || in_->can_pop()) return {State::busy, now + 1};
    if (triangles_->response.can_pop()) return {State::busy, std::max(now + 1, tester_free_)};
    return Activity::once(State::busy, outstanding_ != 0 ? State::stall_mem : State::stall_in);
  }
  if (arrived) return {State::busy, tester_free_};
  if (blocked || outstanding_ != 0) return {State::stall_mem};
  return {State::stall_in};
}

void Intersection::report(Statistics& out) const {
  out.push_back({path(), "triangle_tests", tests_, "", "triangles tested"});
  out.push_back({path(), "hits", hits_, "", "tests that were hits, nearest or not"});
  out.push_back({path(), "left_out", left_out_, "", "triangles not fetched since a shadow ray was already blocked"});
}

std::string Intersection::describe() const { return std::to_string(outstanding_) + " triangle fetches outstanding"; }

}  // namespace artu::hw
