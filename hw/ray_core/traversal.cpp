#include "hw/ray_core/traversal.h"

#include <algorithm>

namespace artu::hw {

void Traversal::reset() {
  ready_head_ = ready_tail_ = 0;
  ready_at_ = 0;
  stepper_free_ = testers_free_ = 0;
  fetches_ = 0;
  node_visits_ = box_tests_ = leaves_ = dropped_ = dynamic_skipped_ = 0;
  finished_.fill(0);
}

namespace {
float limit_of(const RayContext& context) { return context.found ? context.best.t : context.ray.tmax; }
}  // namespace

/// The nearest step is next, the others go on the stack, the farthest first; then through the pipeline.
void Traversal::take(Slot slot, const Steps& steps, std::uint32_t latency, Cycle now) {
  RayContext& context = contexts_[slot];
  for (std::uint32_t i = steps.count; i-- > 1;) context.stack[context.stack_size++] = steps.step[i];
  context.next = steps.count != 0 ? steps.step[0] : Step{};
  box_tests_ += steps.tests;
  const std::uint32_t rounds = std::max<std::uint32_t>(1, (steps.tests + box_testers_ - 1) / box_testers_);
  testers_free_ = now + rounds;
  ready_at_ = std::max(ready_at_, now + rounds - 1 + latency);  // in order, also where trees differ in depth
  ready_[ready_tail_++ % ready_.size()] = {ready_at_, slot};
}

void Traversal::begin(Slot slot, Cycle now) {
  RayContext& context = contexts_[slot];
  context.found = false;
  context.stack_size = 0;
  Steps steps;
  if (!is_zero(context.ray.direction)) {
    const FrameDescriptor& frame = registers_.descriptor;
    hit_tests_.roots(frame, context.ray, fault_, steps);
    bool dynamic = false;
    for (std::uint32_t i = 0; i < steps.count; ++i) dynamic |= NodeReference::is_dynamic(steps.step[i].node);
    if (frame.dynamic_root != NodeReference::none && !dynamic) ++dynamic_skipped_;
  }
  take(slot, steps, pipelines_.box, now);
}

TreeKind Traversal::kind_of(std::uint32_t node) const {
  return NodeReference::is_dynamic(node) ? registers_.descriptor.dynamic_kind : registers_.descriptor.static_kind;
}

Address Traversal::address_of(std::uint32_t node) const {
  const FrameDescriptor& frame = registers_.descriptor;
  const Address nodes = NodeReference::is_dynamic(node) ? frame.dynamic_nodes : frame.static_nodes;
  return nodes + Address{NodeReference::index(node)} * node_bytes(kind_of(node));
}

void Traversal::visit(Slot slot, Cycle now) {
  RayContext& context = contexts_[slot];
  const TreeKind kind = kind_of(context.next.node);
  Steps steps;
  hit_tests_.node(kind, &image_.at<std::uint8_t>(address_of(context.next.node)), context.ray, context.next,
                  limit_of(context), fault_, steps);
  ++node_visits_;
  take(slot, steps, pipelines_.node(kind), now);
}

Traversal::Advance Traversal::finish(Slot slot, RayContext& context) {
  Fifo<Slot>& out = context.kind == RayKind::shadow ? *ports_.shadows : context.found ? *ports_.hits : *ports_.misses;
  if (!out.can_push()) return Advance::blocked_out;
  if (context.kind == RayKind::primary) {
    context.hit_class = !context.found    ? HitClass::miss
                        : context.dynamic ? HitClass::dynamic_geometry
                                          : HitClass::static_geometry;
    context.primary_primitive = context.best_primitive;
    context.primary_t_bits = bits_of(context.best.t);
  }
  out.push(slot);
  ++finished_[static_cast<std::size_t>(context.kind)];
  return Advance::done;
}

/// What a ray does next: fetch a node, have a leaf tested, or end.
Traversal::Advance Traversal::advance(Slot slot, Cycle now) {
  RayContext& context = contexts_[slot];
  const bool occluded = context.kind == RayKind::shadow && context.found;
  std::uint32_t dropped = 0;
  while (!occluded && context.next.node == NodeReference::none && context.stack_size != 0) {
    const Step& top = context.stack[--context.stack_size];
    if (top.enter > limit_of(context)) {
      ++dropped;
    } else {
      context.next = top;
    }
  }
  if (dropped != 0) {
    dropped_ += dropped;
    stepper_free_ = now + 1 + dropped;
    return Advance::dropping;
  }
  if (occluded || context.next.node == NodeReference::none) return finish(slot, context);
  if (!NodeReference::is_leaf(context.next.node)) return fetch(slot, context);
  if (!ports_.leaves->can_push()) return Advance::blocked_out;
  ports_.leaves->push({slot, context.next.node});
  context.next.node = NodeReference::none;
  ++leaves_;
  return Advance::done;
}

/// Asks for the lines of the node that is next, all at once.
Traversal::Advance Traversal::fetch(Slot slot, RayContext& context) {
  const Address address = address_of(context.next.node);
  const std::uint32_t lines = kind_of(context.next.node) == TreeKind::bvh8 ? 2 : 1;
  if (!ports_.nodes->request.can_push(lines)) return Advance::blocked_memory;
  for (std::uint32_t i = 0; i < lines; ++i) {
    ports_.nodes->request.push({line_of(address) + i * line_bytes, 0, slot, 0});
  }
  context.lines_left = static_cast<std::uint8_t>(lines);
  ++fetches_;
  return Advance::done;
}

Activity Traversal::tick(Cycle now) {
  bool moved = false;
  // (1) The box testers: a node that arrived, or else the roots for a new ray.
  const bool free = now >= testers_free_;
  if (ports_.nodes->response.can_pop() && (free || contexts_[ports_.nodes->response.front().tag].lines_left > 1)) {
    const Slot slot = static_cast<Slot>(ports_.nodes->response.front().tag);
    ports_.nodes->response.pop();
    if (--contexts_[slot].lines_left == 0) {
      --fetches_;
      visit(slot, now);
    }
    moved = true;
  } else if (!free) {
    // The testers are still at a wide node.
  } else if (Fifo<Slot>* in = ports_.others->can_pop()    ? ports_.others
                              : ports_.primary->can_pop() ? ports_.primary
                                                          : nullptr) {
    const Slot slot = in->front();
    in->pop();
    begin(slot, now);
    moved = true;
  }
  // (2) The stepper: a ray whose leaf was tested, or else one that leaves the box pipeline.
  Advance step = Advance::done;
  const bool tested = ports_.tested->can_pop();
  const bool boxed = ready_head_ != ready_tail_ && ready_[ready_head_ % ready_.size()].at <= now;
  if (now >= stepper_free_ && (tested || boxed)) {
    step = advance(tested ? ports_.tested->front() : ready_[ready_head_ % ready_.size()].slot, now);
    if (step == Advance::done) {
      if (tested) {
        ports_.tested->pop();
      } else {
        ++ready_head_;
      }
      moved = true;
    } else if (step == Advance::dropping) {
      moved = true;
    }
  }
  if (moved) {
    const bool left = ports_.nodes->response.can_pop() || ports_.others->can_pop() || ports_.primary->can_pop() ||
                      ports_.tested->can_pop() || step == Advance::dropping;
    if (left) return {State::busy, now + 1};
    // Rays in the box pipeline keep the block busy until the first of them leaves it.
    if (ready_head_ != ready_tail_) return {State::busy, std::max(now + 1, ready_[ready_head_ % ready_.size()].at)};
    return Activity::once(State::busy, fetches_ != 0 ? State::stall_mem : State::stall_in);
  }
  // Of the testers, the stepper and the pipeline, the first that is free again or done.
  Cycle next = never;
  if (now < testers_free_) next = testers_free_;
  if (now < stepper_free_ && (tested || boxed)) next = std::min(next, stepper_free_);
  if (ready_head_ != ready_tail_ && !boxed) next = std::min(next, ready_[ready_head_ % ready_.size()].at);
  if (step == Advance::blocked_memory) return {State::stall_mem, next};
  if (step == Advance::blocked_out) return {State::stall_out, next};
  if (next != never) return {State::busy, next};
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
