#include "hw/datapath/node_visit.h"

#include <cmath>

#include "hw/datapath/wide_steps.h"

namespace artu::hw {

namespace {

template <class R>
struct Visit {
  const Ray& ray;
  float limit, padding;
  std::uint32_t fault;
  Steps& out;

  void box(Vector lo, Vector hi, std::uint32_t node) const {
    Interval box = box_interval<R>(ray, lo, hi, padding);
    if (fault != 0) box.exit = float_of(bits_of(box.exit) ^ fault);
    ++out.tests;
    if (meets(box, limit)) out.add(node, box.enter, box.exit);
  }

  void binary(const NodeRecord& node) const {
    box(node.lo[0], node.hi[0], node.child[0]);
    box(node.lo[1], node.hi[1], node.child[1]);
  }

  template <int Width>
  void wide(const WideNodeRecord<Width>& node) const {
    for (int i = 0; i < node.count; ++i) {
      box({decoded_lo(node, 0, i), decoded_lo(node, 1, i), decoded_lo(node, 2, i)},
          {decoded_hi(node, 0, i), decoded_hi(node, 1, i), decoded_hi(node, 2, i)}, node.child[i]);
    }
  }

  /// The near child gets the interval up to the padded plane, the far one from the plane on: then no piece of a
  /// triangle's interval is lost between them (docs/trees.md has the proof).
  void kd(const KdNodeRecord& node, const Step& from) const {
    const auto add = [&](std::uint32_t child, float enter, float exit) {
      if (child != NodeReference::none && enter <= minimum(exit, limit)) out.add(child, enter, exit);
    };
    if (node.axis == KdNodeRecord::both) {
      add(node.child[0], from.enter, from.exit);
      add(node.child[1], from.enter, from.exit);
      return;
    }
    ++out.tests;
    const int axis = static_cast<int>(node.axis);
    const float inverse = ray.inverse[axis];
    float plane = float(R(node.split - ray.origin[axis]) * R(inverse));
    if (fault != 0) plane = float_of(bits_of(plane) ^ fault);
    const float padded = float(R(plane) * R(padding));
    const int near = std::signbit(inverse) ? 1 : 0;
    // On a limited axis the side that holds the origin keeps the whole interval.
    const float o = ray.origin[axis];
    const bool limited = (ray.limited >> axis & 1) != 0;
    const bool holds[2] = {limited && o <= node.split, limited && o >= node.split};
    add(node.child[near], from.enter, holds[near] ? from.exit : minimum(from.exit, padded));
    add(node.child[1 - near], holds[1 - near] ? from.enter : maximum(from.enter, plane), from.exit);
  }
};

#ifdef ARTU_SSE2
/// The same children with their boxes side by side; what a BVH's step does not need, its interval's end, is left out.
inline bool visit_wide(TreeKind kind, const void* record, const Ray& ray, float limit, float padding, Steps& out) {
  const WideSteps steps(ray, padding);
  switch (kind) {
    case TreeKind::bvh2:
      steps.binary(*static_cast<const NodeRecord*>(record), limit, out);
      return true;
    case TreeKind::bvh4:
      steps.wide(*static_cast<const WideNodeRecord<4>*>(record), limit, out);
      return true;
    case TreeKind::bvh8:
      steps.wide(*static_cast<const WideNodeRecord<8>*>(record), limit, out);
      return true;
    case TreeKind::kd:
      break;
  }
  return false;
}
#endif

template <class R>
void visit_node(TreeKind kind, const void* record, const Ray& ray, const Step& from, float limit, float padding,
                std::uint32_t fault, Steps& out) {
#ifdef ARTU_SSE2
  if constexpr (std::is_same_v<R, float>) {
    if (ray.limited == 0 && fault == 0 && visit_wide(kind, record, ray, limit, padding, out)) return;
  }
#endif
  const Visit<R> visit{ray, limit, padding, fault, out};
  switch (kind) {
    case TreeKind::bvh2:
      return visit.binary(*static_cast<const NodeRecord*>(record));
    case TreeKind::bvh4:
      return visit.wide(*static_cast<const WideNodeRecord<4>*>(record));
    case TreeKind::bvh8:
      return visit.wide(*static_cast<const WideNodeRecord<8>*>(record));
    case TreeKind::kd:
      return visit.kd(*static_cast<const KdNodeRecord*>(record), from);
  }
}

template <int... I>
NodeVisit of_width(int fraction_bits, std::integer_sequence<int, I...>) {
  static constexpr NodeVisit all[] = {&visit_node<Real<fewest_fraction_bits + I>>...};
  return all[fraction_bits - fewest_fraction_bits];
}

}  // namespace

NodeVisit node_visit(int fraction_bits) { return of_width(fraction_bits, EveryWidth()); }

}  // namespace artu::hw
