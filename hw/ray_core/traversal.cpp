#include "hw/ray_core/traversal.h"

namespace artu::hw {

void Traversal::reset() {
  boxed_.clear();
  resumed_.clear();
  restarted_.clear();
  parked_.clear();
  parked_.reserve(contexts_.size());
  built_ = false;
  for (RayContext& context : contexts_) {
    context.spills = 0;
    context.awaits_spills = false;
  }
  boxed_at_ = 0;
  stepper_free_ = testers_free_ = 0;
  awaited_ = 0;
  node_visits_ = box_tests_ = leaves_ = dropped_ = dynamic_skipped_ = cut_short_ = 0;
  pushes_ = spilled_lines_ = refilled_lines_ = restarts_ = waits_for_tree_ = 0;
  finished_.fill(0);
}

namespace {
float limit_of(const RayContext& context) { return context.found ? context.best.t : context.ray.tmax; }
}  // namespace

/// The nearest step is next, the others go on the stack, the farthest first; then through the pipeline.
void Traversal::take(Slot slot, const Steps& steps, std::uint32_t latency, Cycle now) {
  RayContext& context = contexts_[slot];
  const std::uint32_t first = context.stack.done();
  for (std::uint32_t i = steps.count; i-- > first + 1;) {
    context.stack.push(steps.step[i], i, i + 1 == steps.count);
    ++pushes_;
  }
  if (steps.count > first) {
    context.next = steps.step[first];
    context.stack.descend(first, first + 1 == steps.count);
  } else {
    context.next = {};
  }
  if (context.stack.on_chip() > config_.stack_entries) overflow(slot, context);
  box_tests_ += steps.tests;
  const std::uint32_t rounds = rounds_[steps.tests];
  testers_free_ = now + rounds;
  boxed_at_ = std::max(boxed_at_, now + rounds - 1 + latency);  // in order, also where trees differ in depth
  boxed_.push({boxed_at_, slot});
}

void Traversal::begin(Slot slot, Cycle now) {
  RayContext& context = contexts_[slot];
  context.found = false;
  context.stack.clear(config_.stack_overflow == StackOverflow::restart);
  const FrameDescriptor& frame = registers_.descriptor;
  trees_ = {tree(frame.static_kind, frame.static_nodes), tree(frame.dynamic_kind, frame.dynamic_nodes)};
  context.dynamic_last = !dynamic_ready();
  const Steps steps = test_roots(context);
  bool dynamic = is_zero(context.ray.direction) || frame.dynamic_root == NodeReference::none;
  for (std::uint32_t i = 0; i < steps.count; ++i) dynamic |= NodeReference::is_dynamic(steps.step[i].node);
  if (!dynamic) ++dynamic_skipped_;
  take(slot, steps, pipelines_.box, now);
}

Steps Traversal::test_roots(const RayContext& context) const {
  Steps steps;
  if (is_zero(context.ray.direction)) return steps;
  hit_tests_.roots(registers_.descriptor, context.ray, fault_, steps, registers_.skip.dynamic_root);
  if (context.dynamic_last && steps.count == 2 && NodeReference::is_dynamic(steps.step[0].node)) {
    std::swap(steps.step[0], steps.step[1]);
  }
  return steps;
}

void Traversal::visit(Slot slot, Cycle now) {
  RayContext& context = contexts_[slot];
  const Tree& tree = tree_of(context.next.node);
  Steps steps;
  hit_tests_.node(tree.kind, &image_.at<std::uint8_t>(address_of(tree, context.next.node)), context.ray, context.next,
                  limit_of(context), fault_, steps);
  ++node_visits_;
  take(slot, steps, tree.latency, now);
}

Traversal::Advance Traversal::finish(Slot slot, RayContext& context) {
  if (await_spills(context)) return Advance::done;
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
  const bool occluded = registers_.skip.any_hit && context.kind == RayKind::shadow && context.found;
  std::uint32_t dropped = 0;
  while (!occluded && context.next.node == NodeReference::none && !context.stack.empty()) {
    const Step& top = context.stack.top();
    if (top.enter > limit_of(context)) {
      ++dropped;
    } else {
      context.next = top;
    }
    context.stack.pop();
  }
  if (dropped != 0) {
    dropped_ += dropped;
    stepper_free_ = now + 1 + dropped;
    return Advance::dropping;
  }
  if (occluded) {
    const bool left = context.next.node != NodeReference::none || !context.stack.empty() || context.stack.overflown();
    const Advance end = finish(slot, context);
    if (end == Advance::done && left && !context.awaits_spills) ++cut_short_;
    return end;
  }
  const std::uint32_t next = context.next.node;
  if (next == NodeReference::none) {
    return context.stack.overflown() ? underflow(slot, context) : finish(slot, context);
  }
  if (NodeReference::is_dynamic(next) && !dynamic_ready()) {
    parked_.push_back(slot);
    ++waits_for_tree_;
    return Advance::done;
  }
  if (!NodeReference::is_leaf(next)) return fetch(slot, context);
  if (!ports_.leaves->can_push()) return Advance::blocked_out;
  ports_.leaves->push({slot, next});
  context.next.node = NodeReference::none;
  ++leaves_;
  return Advance::done;
}

/// Asks for the lines of the node that is next, all at once.
Traversal::Advance Traversal::fetch(Slot slot, RayContext& context) {
  const Tree& tree = tree_of(context.next.node);
  const Address address = address_of(tree, context.next.node);
  const std::uint32_t lines = tree.kind == TreeKind::bvh8 ? 2 : 1;
  if (!ports_.nodes->request.can_push(lines)) return Advance::blocked_memory;
  for (std::uint32_t i = 0; i < lines; ++i) {
    ports_.nodes->request.push({line_of(address) + i * line_bytes, 0, slot, 0});
  }
  context.lines_left = static_cast<std::uint8_t>(lines);
  ++awaited_;
  return Advance::done;
}

/// The queue whose ray begins next, if any.
Fifo<Slot>* Traversal::next_ray() const {
  const bool primary = ports_.primary->can_pop(), others = ports_.others->can_pop();
  if (!primary || !others) return primary ? ports_.primary : others ? ports_.others : nullptr;
  switch (config_.ray_order) {
    case RayOrder::secondary_first:
      return ports_.others;
    case RayOrder::primary_first:
      return ports_.primary;
    case RayOrder::first_come:
      break;
  }
  const bool earlier = contexts_[ports_.primary->front()].arrival < contexts_[ports_.others->front()].arrival;
  return earlier ? ports_.primary : ports_.others;
}

/// The box testers: a node that arrived, or else the roots for a ray that starts anew or begins.
bool Traversal::test_boxes(Cycle now, bool& blocked) {
  const bool free = now >= testers_free_;
  const bool arrived = ports_.nodes->response.can_pop();
  if (arrived && contexts_[ports_.nodes->response.front().tag].lines_left > 1) {
    --contexts_[ports_.nodes->response.front().tag].lines_left;
    ports_.nodes->response.pop();
    return true;
  }
  if (!free) return false;  // still at a wide node
  Fifo<Slot>* in = next_ray();
  if (!arrived && restarted_.empty() && in == nullptr) return false;
  // What a node adds to a full stack is two lines at most.
  if (config_.stack_overflow == StackOverflow::spill && !ports_.spills->request.can_push(2)) {
    blocked = true;
    return false;
  }
  if (arrived) {
    const auto slot = static_cast<Slot>(ports_.nodes->response.front().tag);
    ports_.nodes->response.pop();
    --awaited_;
    visit(slot, now);
  } else if (!restarted_.empty()) {
    const Slot slot = restarted_.front();
    restarted_.pop();
    take(slot, test_roots(contexts_[slot]), pipelines_.box, now);
  } else {
    const Slot slot = in->front();
    in->pop();
    begin(slot, now);
  }
  return true;
}

Activity Traversal::tick(Cycle now) {
  // (1) What the memory and the control unit say to rays that wait.
  bool moved = ports_.spills != nullptr && answer_spills();
  if (ports_.built != nullptr) moved |= release();
  // (2) The box testers.
  bool blocked_tests = false;
  moved |= test_boxes(now, blocked_tests);
  // (3) The stepper: a ray whose leaf was tested, or one that need not wait any more, or one from the box pipeline.
  Advance step = Advance::done;
  const bool tested = ports_.tested->can_pop(), resumed = !resumed_.empty();
  const bool boxed = !boxed_.empty() && boxed_.front().at <= now;
  if (now >= stepper_free_ && (tested || resumed || boxed)) {
    step = advance(tested ? ports_.tested->front() : resumed ? resumed_.front() : boxed_.front().slot, now);
    if (step == Advance::done) {
      if (tested) {
        ports_.tested->pop();
      } else if (resumed) {
        resumed_.pop();
      } else {
        boxed_.pop();
      }
      moved = true;
    } else if (step == Advance::dropping) {
      moved = true;
    }
  }
  if (moved) {
    const bool left = ports_.nodes->response.can_pop() || ports_.others->can_pop() || ports_.primary->can_pop() ||
                      ports_.tested->can_pop() || !resumed_.empty() || !restarted_.empty() ||
                      step == Advance::dropping || (ports_.spills != nullptr && ports_.spills->response.can_pop());
    if (left) return {State::busy, now + 1};
    // Rays in the box pipeline keep the block busy until the first of them leaves it.
    if (!boxed_.empty()) return {State::busy, std::max(now + 1, boxed_.front().at)};
    return Activity::once(State::busy, awaited_ != 0 ? State::stall_mem : State::stall_in);
  }
  // Of the testers, the stepper and the pipeline, the first that is free again or done.
  Cycle next = never;
  if (now < testers_free_) next = testers_free_;
  if (now < stepper_free_ && (tested || resumed || boxed)) next = std::min(next, stepper_free_);
  if (!boxed_.empty() && !boxed) next = std::min(next, boxed_.front().at);
  if (step == Advance::blocked_memory || blocked_tests) return {State::stall_mem, next};
  if (step == Advance::blocked_out) return {State::stall_out, next};
  if (next != never) return {State::busy, next};
  return {awaited_ != 0 ? State::stall_mem : State::stall_in};
}

void Traversal::report(Statistics& out) const {
  const std::string block = path();
  out.push_back({block, "node_visits", node_visits_, "", "inner nodes fetched and tested"});
  out.push_back({block, "box_tests", box_tests_, "", "boxes tested, root boxes included"});
  out.push_back({block, "leaves", leaves_, "", "leaves given to intersection"});
  out.push_back({block, "stack_pushes", pushes_, "", "entries put on traversal stacks"});
  out.push_back({block, "dropped", dropped_, "", "stack entries that began behind the best hit"});
  out.push_back({block, "spilled_lines", spilled_lines_, "lines", "of stack entries written to memory"});
  out.push_back({block, "refilled_lines", refilled_lines_, "lines", "of stack entries read back"});
  out.push_back({block, "restarts", restarts_, "", "walks from the roots again, for a forgotten stack entry"});
  out.push_back({block, "tree_waits", waits_for_tree_, "rays", "rays that waited for the dynamic tree to be built"});
  out.push_back({block, "cut_short", cut_short_, "rays", "shadow rays that were blocked with nodes or leaves to go"});
  out.push_back({block, "dynamic_skipped", dynamic_skipped_, "rays", "rays that missed the dynamic tree's root box"});
}

std::string Traversal::describe() const {
  return std::to_string(boxed_.size()) + " rays in the box pipeline, " + std::to_string(awaited_) +
         " wait for memory, " + std::to_string(parked_.size()) + " for the dynamic tree";
}

}  // namespace artu::hw
