// Walks both trees for many rays at a time: fetches nodes, tests child boxes or planes, keeps a stack for each ray.
//
// In:  rays from the ray generator; leaves tested, from intersection; nodes from the node cache; lines of spilled
//      stacks; from the control unit that the dynamic tree is built.
// Out: leaves to intersection; finished rays to hit_point (hit), to shading (miss, shadow).
// Latency: `box`, `wide_box` or `plane`, as the kind of tree asks, from a node's last line to the ray's next step.
// Initiation interval: tests / box_testers cycles a node (8-wide nodes are two lines), at least `node_interval`; 1 for
// steps (a fetch, a leaf or an end); dropping stack entries whose boxes begin behind the best hit takes a step and a
// cycle each.
// A ray begins with both root boxes; the nearer child is visited first.  Which ray begins first: `ray_order`.
// Stack: `stack_entries` on chip; what overflows is spilled a line at a time, oldest first, and read back when the ray
// has nothing else; a ray goes on or ends when its writes are acknowledged.  Or it is forgotten: see ray_stack.h.
// While the dynamic tree is being built rays walk the static one first and wait where they need the other.
// Stalls: stall_mem when nodes or spilled entries are awaited or the memory takes no request, stall_out when
// intersection, hit_point or shading take no more.
#pragma once

#include <algorithm>

#include "hw/fabric/memory_port.h"
#include "hw/frame_registers.h"
#include "hw/memory/image.h"
#include "hw/ray_core/pipelines.h"
#include "hw/ray_core/ray_context.h"

namespace artu::hw {

/// A leaf to test for the ray in a context: 8 + 32 bits.
struct LeafTask {
  Slot slot = 0;
  std::uint32_t leaf = 0;
};

class Traversal : public Block {
 public:
  Traversal(sc_core::sc_module_name name, ClockDomain& domain, const FrameRegisters& registers,
            const MemoryImage& image, RayContexts& contexts, const RayCoreConfig& config, const Pipelines& pipelines,
            const PrecisionConfig& precision = {}, std::uint32_t core = 0)
      : Block(name, domain),
        registers_(registers),
        image_(image),
        contexts_(contexts),
        config_(config),
        pipelines_(pipelines),
        hit_tests_(precision),
        core_(core),
        boxed_(contexts.size()),
        resumed_(contexts.size()),
        restarted_(contexts.size()) {
    for (std::uint32_t tests = 0; tests < rounds_.size(); ++tests) {
      rounds_[tests] = std::max(config_.node_interval, (tests + config_.box_testers - 1) / config_.box_testers);
    }
  }

  struct Ports {
    Fifo<Slot>* primary;
    Fifo<Slot>* others;
    Fifo<Slot>* tested;
    Fifo<LeafTask>* leaves;
    Fifo<Slot>* hits;
    Fifo<Slot>* misses;
    Fifo<Slot>* shadows;
    MemoryLink* nodes;
    MemoryLink* spills = nullptr;      // where the unit spills
    Fifo<TreeBuilt>* built = nullptr;  // where the build may overlap with the first pass
  };
  void bind(const Ports& ports) { ports_ = ports; }
  /// Fault injection: bits that every box interval's end is xored with.
  void inject(std::uint32_t bits) { fault_ = bits; }

  void reset() override;
  void report(Statistics& out) const override;
  std::string describe() const override;
  std::uint64_t node_visits() const { return node_visits_; }
  std::uint64_t finished(RayKind kind) const { return finished_[static_cast<std::size_t>(kind)]; }

 private:
  enum class Advance : std::uint8_t { done, dropping, blocked_memory, blocked_out };
  /// Rays that wait their turn, in order; room for every context.
  template <class Entry>
  class Queue {
   public:
    explicit Queue(std::size_t contexts) {
      std::size_t room = 1;
      while (room < contexts) room *= 2;
      entries_.resize(room);
      last_ = room - 1;
    }
    void clear() { head_ = tail_ = 0; }
    bool empty() const { return head_ == tail_; }
    std::size_t size() const { return tail_ - head_; }
    const Entry& front() const { return entries_[head_ & last_]; }
    void push(const Entry& entry) { entries_[tail_++ & last_] = entry; }
    void pop() { ++head_; }

   private:
    std::vector<Entry> entries_;
    std::size_t last_ = 0, head_ = 0, tail_ = 0;
  };
  struct Boxed {
    Cycle at;
    Slot slot;
  };

  /// Where a tree's nodes lie, and what they are.
  struct Tree {
    Address nodes = 0;
    std::uint32_t node_bytes = 0;
    TreeKind kind = TreeKind::bvh2;
    std::uint32_t latency = 0;  // of a node's test
  };

  Activity tick(Cycle now) override;
  bool test_boxes(Cycle now, bool& blocked);
  Fifo<Slot>* next_ray() const;
  void begin(Slot slot, Cycle now);
  Steps test_roots(const RayContext& context) const;
  void visit(Slot slot, Cycle now);
  void take(Slot slot, const Steps& steps, std::uint32_t latency, Cycle now);
  const Tree& tree_of(std::uint32_t node) const { return trees_[NodeReference::is_dynamic(node) ? 1 : 0]; }
  Address address_of(const Tree& tree, std::uint32_t node) const {
    return tree.nodes + Address{NodeReference::index(node)} * tree.node_bytes;
  }
  Tree tree(TreeKind kind, Address nodes) const { return {nodes, node_bytes(kind), kind, pipelines_.node(kind)}; }
  Advance advance(Slot slot, Cycle now);
  Advance fetch(Slot slot, RayContext& context);
  Advance finish(Slot slot, RayContext& context);

  // traversal_stack.cpp
  std::uint32_t entries_in_a_line() const;
  Address spilled_line(Slot slot, std::uint32_t entry) const;
  void overflow(Slot slot, RayContext& context);
  Advance underflow(Slot slot, RayContext& context);
  bool await_spills(RayContext& context);
  bool dynamic_ready() const;
  bool answer_spills();
  bool release();

  const FrameRegisters& registers_;
  const MemoryImage& image_;
  RayContexts& contexts_;
  const RayCoreConfig config_;
  const Pipelines pipelines_;
  const HitTests hit_tests_;
  const std::uint32_t core_;
  Ports ports_{};
  std::uint32_t fault_ = 0;
  std::array<Tree, 2> trees_;            // static and dynamic, as the descriptor says
  std::array<std::uint32_t, 9> rounds_;  // cycles that so many tests keep the testers busy
  Queue<Boxed> boxed_;                   // in the box pipeline
  Queue<Slot> resumed_;                  // what they waited for is there: they step as they are
  Queue<Slot> restarted_;                // begin at the roots again
  std::vector<Slot> parked_;             // wait for the dynamic tree
  bool built_ = false;                   // it is there
  Cycle boxed_at_ = 0;                   // when the last one that entered the box pipeline leaves it
  Cycle stepper_free_ = 0, testers_free_ = 0;
  std::uint32_t awaited_ = 0;  // rays that wait for memory
  std::uint64_t node_visits_ = 0, box_tests_ = 0, leaves_ = 0, dropped_ = 0, dynamic_skipped_ = 0, cut_short_ = 0;
  std::uint64_t pushes_ = 0, spilled_lines_ = 0, refilled_lines_ = 0, restarts_ = 0, waits_for_tree_ = 0;
  std::array<std::uint64_t, ray_kinds> finished_{};
};

}  // namespace artu::hw
