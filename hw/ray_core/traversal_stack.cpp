// Traversal: stacks that overflow, and rays that wait.
#include "hw/ray_core/traversal.h"

namespace artu::hw {

namespace {
constexpr std::uint32_t refill_tag = 1u << 16;  // beside the slot
static_assert(spill_bytes == maximum_stack * spill_entry_bytes);
}  // namespace

/// A BVH's entry is a node and where its box begins; a kd-tree's has its interval's end, too.
std::uint32_t Traversal::entries_in_a_line() const {
  const bool intervals =
      registers_.descriptor.static_kind == TreeKind::kd || registers_.descriptor.dynamic_kind == TreeKind::kd;
  return static_cast<std::uint32_t>(line_bytes / (intervals ? spill_entry_bytes : spill_entry_bytes / 2));
}

/// Where the line lies in which the entry is spilled.
Address Traversal::spilled_line(Slot slot, std::uint32_t entry) const {
  const Address area = registers_.descriptor.stack_spills + (Address{core_} * contexts_.size() + slot) * spill_bytes;
  return area + entry / entries_in_a_line() * line_bytes;
}

/// Makes room on chip.
void Traversal::overflow(Slot slot, RayContext& context) {
  RayStack& stack = context.stack;
  if (config_.stack_overflow == StackOverflow::restart) {
    stack.give_up(stack.on_chip() - config_.stack_entries);
    return;
  }
  while (stack.on_chip() > config_.stack_entries) {
    ports_.spills->request.push({spilled_line(slot, stack.bottom()), ~std::uint64_t{0}, std::uint32_t{slot}, 0});
    stack.give_up(entries_in_a_line());
    ++context.spills;
    ++spilled_lines_;
  }
}

/// Whether the ray must wait until its writes are acknowledged; it then waits.
bool Traversal::await_spills(RayContext& context) {
  if (context.spills == 0) return false;
  context.awaits_spills = true;
  ++awaited_;
  return true;
}

/// Nothing is left on chip, but there was more.
Traversal::Advance Traversal::underflow(Slot slot, RayContext& context) {
  if (config_.stack_overflow == StackOverflow::restart) {
    context.stack.restart();
    restarted_.push(slot);
    ++restarts_;
    return Advance::done;
  }
  if (await_spills(context)) return Advance::done;
  if (!ports_.spills->request.can_push()) return Advance::blocked_memory;
  ports_.spills->request.push({spilled_line(slot, context.stack.bottom() - 1), 0, std::uint32_t{slot} | refill_tag, 0});
  ++awaited_;
  ++refilled_lines_;
  return Advance::done;
}

/// An acknowledgement, or a line of entries.
bool Traversal::answer_spills() {
  if (!ports_.spills->response.can_pop()) return false;
  const std::uint32_t tag = ports_.spills->response.front().tag;
  ports_.spills->response.pop();
  const auto slot = static_cast<Slot>(tag & (refill_tag - 1));
  RayContext& context = contexts_[slot];
  if ((tag & refill_tag) != 0) {
    context.stack.refill(entries_in_a_line());
  } else if (--context.spills != 0 || !context.awaits_spills) {
    return true;
  }
  context.awaits_spills = false;
  --awaited_;
  resumed_.push(slot);
  return true;
}

bool Traversal::dynamic_ready() const { return ports_.built == nullptr || built_ || !registers_.builds(); }

/// The dynamic tree is there: rays that wait for it go on.
bool Traversal::release() {
  if (!ports_.built->can_pop()) return false;
  ports_.built->pop();
  built_ = true;
  for (Slot slot : parked_) resumed_.push(slot);
  parked_.clear();
  return true;
}

}  // namespace artu::hw
