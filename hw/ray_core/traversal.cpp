#include "hw/ray_core/traversal.h"

#include <algorithm>

#include "hw/datapath/box.h"

namespace artu::hw {

void Traversal::reset() {
  ready_head_ = ready_tail_ = 0;
  stepper_free_ = 0;
  fetches_ = 0;
  node_visits_ = box_tests_ = leaves_ = dropped_ = dynamic_skipped_ = 0;
  finished_.fill(0);
}

namespace {
float limit_of(const RayContext& context) { return context.found ? context.best.t : context.ray.tmax; }
}  // namespace

/// Tests two boxes; the nearer child that is hit is next, the other goes on the stack.
void Traversal::choose(RayContext& context, const std::uint32_t child[2], const Vector lo[2], const Vector hi[2]) {
  const float limit = limit_of(context);
  Interval box[2];
  bool hit[2];
  for (int i = 0; i < 2; ++i) {
    box[i] = box_interval(context.ray, lo[i], hi[i]);
    if (fault_ != 0) box[i].exit = float_of(bits_of(box[i].exit) ^ fault_);
    hit[i] = child[i] != NodeReference::none && meets(box[i], limit);
    box_tests_ += child[i] != NodeReference::none;
  }
  if (hit[0] && hit[1]) {
    const int near = box[1].enter < box[0].enter ? 1 : 0;
    context.next = child[near];
    context.stack[context.stack_size++] = {child[1 - near], box[1 - near].enter};
  } else {
    context.next = hit[0] ? child[0] : hit[1] ? child[1] : NodeReference::none;
  }
}

void Traversal::begin(Slot slot, Cycle now) {
  RayContext& context = contexts_[slot];
  context.found = false;
  context.stack_size = 0;
  context.next = NodeReference::none;
  if (!is_zero(context.ray.direction)) {
    const FrameDescriptor& frame = registers_.descriptor;
    const std::uint32_t roots[2] = {frame.static_root, frame.dynamic_root};
    const Vector lo[2] = {frame.static_lo, frame.dynamic_lo}, hi[2] = {frame.static_hi, frame.dynamic_hi};
    choose(context, roots, lo, hi);
    const bool dynamic = (context.next != NodeReference::none && NodeReference::is_dynamic(context.next)) ||
                         context.stack_size != 0;
    if (frame.dynamic_root != NodeReference::none && !dynamic) ++dynamic_skipped_;
  }
  ready_push(slot, now + box_latency_);
}

void Traversal::visit(Slot slot, Cycle now) {
  RayContext& context = contexts_[slot];
  const FrameDescriptor& frame = registers_.descriptor;
  const std::uint32_t reference = context.next;
  const Address nodes = NodeReference::is_dynamic(reference) ? frame.dynamic_nodes : frame.static_nodes;
  const NodeRecord& node = image_.at<NodeRecord>(nodes + Address{NodeReference::index(reference)} * sizeof(NodeRecord));
  ++node_visits_;
  choose(context, node.child, node.lo, node.hi);
  ready_push(slot, now + box_latency_);
}

Traversal::Step Traversal::finish(Slot slot, RayContext& context) {
  Fifo<Slot>& out = context.kind == RayKind::shadow ? *ports_.shadows : context.found ? *ports_.hits : *ports_.misses;
  if (!out.can_push()) return Step::blocked_out;
  if (context.kind == RayKind::primary) {
    context.hit_class = !context.found     ? HitClass::miss
                        : context.dynamic ? HitClass::dynamic_geometry
                                          : HitClass::static_geometry;
    context.primary_primitive = context.best_primitive;
    context.primary_t_bits = bits_of(context.best.t);
  }
  out.push(slot);
  ++finished_[static_cast<std::size_t>(context.kind)];
  return Step::done;
}

/// What a ray does next: fetch a node, have a leaf tested, or end.
Traversal::Step Traversal::advance(Slot slot, Cycle now) {
  RayContext& context = contexts_[slot];
  const bool occluded = context.kind == RayKind::shadow && context.found;
  std::uint32_t dropped = 0;
  while (!occluded && context.next == NodeReference::none && context.stack_size != 0) {
    const StackEntry& top = context.stack[--context.stack_size];
    if (top.enter > limit_of(context)) {
      ++dropped;
    } else {
      context.next = top.node;
    }
  }
  if (dropped != 0) {
    dropped_ += dropped;
    stepper_free_ = now + 1 + dropped;
    return Step::dropping;
  }
  if (occluded || context.next == NodeReference::none) return finish(slot, context);
  if (NodeReference::is_leaf(context.next)) {
    if (!ports_.leaves->can_push()) return Step::blocked_out;
    ports_.leaves->push({slot, context.next});
    context.next = NodeReference::none;
    ++leaves_;
    return Step::done;
  }
  if (!ports_.nodes->request.can_push()) return Step::blocked_memory;
  const FrameDescriptor& frame = registers_.descriptor;
  const Address nodes = NodeReference::is_dynamic(context.next) ? frame.dynamic_nodes : frame.static_nodes;
  ports_.nodes->request.push({nodes + Address{NodeReference::index(context.next)} * sizeof(NodeRecord), 0, slot, 0});
  ++fetches_;
  return Step::done;
}

Activity Traversal::tick(Cycle now) {
  bool moved = false;
  // (1) The box testers: a node that arrived, or else the roots for a new ray.
  if (ports_.nodes->response.can_pop()) {
    const Slot slot = static_cast<Slot>(ports_.nodes->response.front().tag);
    ports_.nodes->response.pop();
    --fetches_;
    visit(slot, now);
    moved = true;
  } else if (Fifo<Slot>* in = ports_.others->can_pop()    ? ports_.others
                              : ports_.primary->can_pop() ? ports_.primary
                                                          : nullptr) {
    const Slot slot = in->front();
    in->pop();
    begin(slot, now);
    moved = true;
  }
  // (2) The stepper: a ray whose leaf was tested, or else one that leaves the box pipeline.
  Step step = Step::done;
  const bool tested = ports_.tested->can_pop();
  const bool boxed = ready_head_ != ready_tail_ && ready_[ready_head_ % ready_.size()].at <= now;
  if (now >= stepper_free_ && (tested || boxed)) {
    step = advance(tested ? ports_.tested->front() : ready_[ready_head_ % ready_.size()].slot, now);
    if (step == Step::done) {
      if (tested) {
        ports_.tested->pop();
      } else {
        ++ready_head_;
      }
      moved = true;
    } else if (step == Step::dropping) {
      moved = true;
    }
  }
  if (moved) {
    const bool left = ports_.nodes->response.can_pop() || ports_.others->can_pop() || ports_.primary->can_pop() ||
                      ports_.tested->can_pop() || step == Step::dropping;
    if (left) return {State::busy, now + 1};
    // Rays in the box pipeline keep the block busy until the first of them leaves it.
    if (ready_head_ != ready_tail_) return {State::busy, std::max(now + 1, ready_[ready_head_ % ready_.size()].at)};
    return Activity::once(State::busy, fetches_ != 0 ? State::stall_mem : State::stall_in);
  }
  if (step == Step::blocked_memory) return {State::stall_mem};
  if (step == Step::blocked_out) return {State::stall_out};
  if (now < stepper_free_ && (tested || boxed)) return {State::busy, stepper_free_};
  if (ready_head_ != ready_tail_) return {State::busy, ready_[ready_head_ % ready_.size()].at};
  return {fetches_ != 0 ? State::stall_mem : State::stall_in};
}

void Traversal::report(Statistics& out) const {
  const std::string block = path();
  out.push_back({block, "node_visits", node_visits_, "", "inner nodes fetched and tested"});
  out.push_back({block, "box_tests", box_tests_, "", "boxes tested, root boxes included"});
  out.push_back({block, "leaves", leaves_, "", "leaves given to intersection"});
  out.push_back({block, "dropped", dropped_, "", "stack entries that began behind the best hit"});
  out.push_back({block, "dynamic_skipped", dynamic_skipped_, "rays", "rays that missed the dynamic tree's root box"});
}

std::string Traversal::describe() const {
  return std::to_string(ready_tail_ - ready_head_) + " rays in the box pipeline, " + std::to_string(fetches_) +
         " node fetches outstanding";
}

}  // namespace artu::hw
