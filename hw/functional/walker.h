// Traversals of both trees without time: the steps and counts of hw/ray_core's traversal and intersection, ray by ray.
//
// In binary32, and where no stack can overflow, boxes are tested with SSE2 (wide_steps.h); else step by step as the
// blocks do it, with the same stack.
#pragma once

#include "hw/datapath/walk.h"
#include "hw/datapath/wide_steps.h"
#include "hw/functional/counts.h"
#include "hw/functional/frame_memory.h"
#include "hw/ray_core/ray_stack.h"

namespace artu::hw {

template <class Tap>
class Walker {
 public:
  /// `portable`: never with SSE2, for tests.  `overflows`: a stack may need more entries than are on chip.
  Walker(const UnitConfig& config, const FrameMemory& memory, bool portable, bool overflows, FunctionalCounts& counts,
         Tap& tap)
      : config_(config.core),
        skip_dynamic_(config.skip.dynamic_root),
        tests_(config.precision),
        memory_(memory),
        padding_(box_padding(static_cast<int>(std::min(config.precision.box, config.precision.triangle)))),
        native_(config.precision.box == most_fraction_bits && config.precision.triangle == most_fraction_bits &&
                !overflows && !portable),
        entries_in_a_line_(memory.kind[0] == TreeKind::kd || memory.kind[1] == TreeKind::kd ? 4 : 8),
        counts_(counts),
        tap_(tap) {}

  const HitTests& tests() const { return tests_; }

  /// Of a ray that is set up, or dead: its closest hit, or with Any the first that is found.
  template <bool Any>
  void walk(const Ray& ray, Found& found) {
    found.hit = false;
    if (is_zero(ray.direction)) return;
    Steps roots;
    tests_.roots(memory_.frame, ray, 0, roots, skip_dynamic_);
    counts_.boxes += roots.tests;
    count_dynamic(roots);
#ifdef ARTU_SSE2
    if (native_ && ray.limited == 0) return native<Any>(ray, roots, found);
#endif
    general<Any>(ray, roots, found);
  }

 private:
  void count_dynamic(const Steps& roots) {
    bool dynamic = memory_.frame.dynamic_root == NodeReference::none;
    for (std::uint32_t i = 0; i < roots.count; ++i) dynamic |= NodeReference::is_dynamic(roots.step[i].node);
    if (!dynamic) ++counts_.dynamic_skipped;
  }
  static float limit_of(const Ray& ray, const Found& found) { return found.hit ? found.best.t : ray.tmax; }

  /// False if the ray ends here.
  template <bool Any, class Test>
  bool leaf(const Ray& ray, std::uint32_t reference, const Test& test, Found& found) {
    ++counts_.leaves;
    const bool dynamic = NodeReference::is_dynamic(reference);
    const std::uint32_t first = NodeReference::first(reference), count = NodeReference::count(reference);
    const TriangleRecord* record = memory_.leaf(reference);
    tap_.leaf(memory_.address_of(record), count);
    for (std::uint32_t i = 0; i < count; ++i) {
      TriangleHit hit;
      if (!test(ray, record[i], hit)) continue;
      consider(hit, record[i].primitive, first + i, dynamic, found);
      if constexpr (Any) {
        counts_.triangles += i + 1;
        counts_.left_out += count - i - 1;
        return false;
      }
    }
    counts_.triangles += count;
    return true;
  }

  template <bool Any>
  void general(const Ray& ray, const Steps& roots, Found& found);
  void push(const Steps& steps, Step& next);
  /// The next step of a ray whose last one led nowhere; false at its end.
  bool pop(const Ray& ray, const Found& found, Step& next);
#ifdef ARTU_SSE2
  template <bool Any>
  void native(const Ray& ray, const Steps& roots, Found& found);
#endif

  const RayCoreConfig config_;
  const bool skip_dynamic_;
  const HitTests tests_;
  const FrameMemory memory_;
  const float padding_;
  const bool native_;
  const std::uint32_t entries_in_a_line_;  // of a stack that is spilled
  FunctionalCounts& counts_;
  Tap& tap_;
  RayStack stack_;
};

template <class Tap>
void Walker<Tap>::push(const Steps& steps, Step& next) {
  const std::uint32_t first = stack_.done();
  for (std::uint32_t i = steps.count; i-- > first + 1;) {
    stack_.push(steps.step[i], i, i + 1 == steps.count);
    ++counts_.pushes;
  }
  next.node = NodeReference::none;
  if (steps.count > first) {
    next = steps.step[first];
    stack_.descend(first, first + 1 == steps.count);
  }
  if (stack_.on_chip() <= config_.stack_entries) return;
  if (config_.stack_overflow == StackOverflow::restart) {
    stack_.give_up(stack_.on_chip() - config_.stack_entries);
    return;
  }
  while (stack_.on_chip() > config_.stack_entries) {
    stack_.give_up(entries_in_a_line_);
    ++counts_.spilled_lines;
  }
}

template <class Tap>
bool Walker<Tap>::pop(const Ray& ray, const Found& found, Step& next) {
  for (;;) {
    while (!stack_.empty()) {
      const Step top = stack_.top();
      stack_.pop();
      if (top.enter > limit_of(ray, found)) {
        ++counts_.dropped;
        continue;
      }
      next = top;
      return true;
    }
    if (!stack_.overflown()) return false;
    if (config_.stack_overflow == StackOverflow::restart) {
      stack_.restart();
      ++counts_.restarts;
      Steps roots;
      tests_.roots(memory_.frame, ray, 0, roots, skip_dynamic_);
      counts_.boxes += roots.tests;
      push(roots, next);
      if (next.node != NodeReference::none) return true;
    } else {
      stack_.refill(entries_in_a_line_);
      ++counts_.refilled_lines;
    }
  }
}

template <class Tap>
template <bool Any>
void Walker<Tap>::general(const Ray& ray, const Steps& roots, Found& found) {
  const auto test = [this](const Ray& r, const TriangleRecord& t, TriangleHit& hit) {
    return tests_.triangle(r, t.a, t.b, t.c, hit);
  };
  stack_.clear(config_.stack_overflow == StackOverflow::restart);
  Step next;
  push(roots, next);
  while (next.node != NodeReference::none || pop(ray, found, next)) {
    const Step step = next;
    next.node = NodeReference::none;
    if (NodeReference::is_leaf(step.node)) {
      if (!leaf<Any>(ray, step.node, test, found)) return;
      continue;
    }
    const TreeKind kind = memory_.kind[NodeReference::is_dynamic(step.node)];
    const std::uint8_t* node = memory_.node(step.node);
    tap_.node(memory_.address_of(node), kind);
    ++counts_.nodes;
    Steps steps;
    tests_.node(kind, node, ray, step, limit_of(ray, found), 0, steps);
    counts_.boxes += steps.tests;
    push(steps, next);
  }
}

#ifdef ARTU_SSE2
template <class Tap>
template <bool Any>
void Walker<Tap>::native(const Ray& ray, const Steps& roots, Found& found) {
  const float padding = padding_;
  const auto test = [padding](const Ray& r, const TriangleRecord& t, TriangleHit& hit) {
    const auto box = [padding](const Ray& of, Vector lo, Vector hi) {
      return box_interval<float>(of, lo, hi, padding);
    };
    return intersect<float>(r, t.a, t.b, t.c, box, hit);
  };
  const WideSteps boxes(ray, padding);
  Step stack[maximum_stack + 8];
  std::uint32_t size = 0;
  for (std::uint32_t i = roots.count; i-- > 0;) stack[size++] = roots.step[i];
  if (size > 1) ++counts_.pushes;
  float limit = ray.tmax;
  std::uint64_t nodes = 0, tested = 0, pushes = 0, dropped = 0;
  while (size != 0) {
    Step step = stack[--size];
    if (step.enter > limit) {
      ++dropped;
      continue;
    }
    // Down to a leaf, or to a node of which the ray meets no child.
    while (!NodeReference::is_leaf(step.node)) {
      const TreeKind kind = memory_.kind[NodeReference::is_dynamic(step.node)];
      const std::uint8_t* node = memory_.node(step.node);
      tap_.node(memory_.address_of(node), kind);
      ++nodes;
      if (kind == TreeKind::bvh2) {
        const auto& record = *reinterpret_cast<const NodeRecord*>(node);
        __m128 enters;
        const unsigned met = boxes.binary(record, limit, enters);
        tested += 2;
        if (met == 0) {
          step.node = NodeReference::none;
          break;
        }
        const float enter[2] = {_mm_cvtss_f32(enters), _mm_cvtss_f32(_mm_shuffle_ps(enters, enters, 1))};
        if (met == 3) {
          const int far = enter[1] < enter[0] ? 0 : 1;
          stack[size].node = record.child[far];
          stack[size++].enter = enter[far];
          ++pushes;
          step.node = record.child[1 - far];
        } else {
          step.node = record.child[met >> 1];
        }
        continue;
      }
      Steps steps;
      if (kind == TreeKind::bvh4) {
        boxes.wide(*reinterpret_cast<const WideNodeRecord<4>*>(node), limit, steps);
      } else if (kind == TreeKind::bvh8) {
        boxes.wide(*reinterpret_cast<const WideNodeRecord<8>*>(node), limit, steps);
      } else {
        tests_.node(kind, node, ray, step, limit, 0, steps);
      }
      tested += steps.tests;
      step.node = NodeReference::none;
      if (steps.count == 0) break;
      for (std::uint32_t i = steps.count; i-- > 1;) stack[size++] = steps.step[i];
      pushes += steps.count - 1;
      step = steps.step[0];
    }
    if (step.node == NodeReference::none) continue;
    if (!leaf<Any>(ray, step.node, test, found)) break;
    if (found.hit) limit = found.best.t;
  }
  counts_.nodes += nodes;
  counts_.boxes += tested;
  counts_.pushes += pushes;
  counts_.dropped += dropped;
}
#endif

}  // namespace artu::hw
