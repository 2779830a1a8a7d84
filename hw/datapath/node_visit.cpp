#include "hw/datapath/node_visit.h"

#include <cmath>

namespace artu::hw {

namespace {

void visit_binary(const NodeRecord& node, const Ray& ray, float limit, std::uint32_t fault, Steps& out) {
  test_box(ray, node.lo[0], node.hi[0], node.child[0], limit, fault, out);
  test_box(ray, node.lo[1], node.hi[1], node.child[1], limit, fault, out);
}

template <int Width>
void visit_wide(const WideNodeRecord<Width>& node, const Ray& ray, float limit, std::uint32_t fault, Steps& out) {
  for (int i = 0; i < node.count; ++i) {
    const Vector lo{decoded_lo(node, 0, i), decoded_lo(node, 1, i), decoded_lo(node, 2, i)};
    const Vector hi{decoded_hi(node, 0, i), decoded_hi(node, 1, i), decoded_hi(node, 2, i)};
    test_box(ray, lo, hi, node.child[i], limit, fault, out);
  }
}

/// The near child gets the interval up to the padded plane, the far one from the plane on: then no piece of a
/// triangle's interval is lost between them (docs/trees.md has the proof).
void visit_kd(const KdNodeRecord& node, const Ray& ray, const Step& from, float limit, std::uint32_t fault,
              Steps& out) {
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
  float plane = (node.split - ray.origin[axis]) * inverse;
  if (fault != 0) plane = float_of(bits_of(plane) ^ fault);
  const int near = std::signbit(inverse) ? 1 : 0;
  // On a limited axis the side that holds the origin keeps the whole interval.
  const float o = ray.origin[axis];
  const bool limited = (ray.limited >> axis & 1) != 0;
  const bool holds[2] = {limited && o <= node.split, limited && o >= node.split};
  add(node.child[near], from.enter, holds[near] ? from.exit : minimum(from.exit, plane * box_padding));
  add(node.child[1 - near], holds[1 - near] ? from.enter : maximum(from.enter, plane), from.exit);
}

}  // namespace

void visit_node(TreeKind kind, const void* record, const Ray& ray, const Step& from, float limit, std::uint32_t fault,
                Steps& out) {
  switch (kind) {
    case TreeKind::bvh2:
      return visit_binary(*static_cast<const NodeRecord*>(record), ray, limit, fault, out);
    case TreeKind::bvh4:
      return visit_wide(*static_cast<const WideNodeRecord<4>*>(record), ray, limit, fault, out);
    case TreeKind::bvh8:
      return visit_wide(*static_cast<const WideNodeRecord<8>*>(record), ray, limit, fault, out);
    case TreeKind::kd:
      return visit_kd(*static_cast<const KdNodeRecord*>(record), ray, from, limit, fault, out);
  }
}

void visit_roots(const FrameDescriptor& frame, const Ray& ray, std::uint32_t fault, Steps& out) {
  // A step's interval is the one in which the walk goes on: cut to [0, tmax], which a kd-tree splits further.
  const auto root = [&](std::uint32_t reference, Vector lo, Vector hi) {
    if (reference == NodeReference::none) return;
    Steps one;
    test_box(ray, lo, hi, reference, ray.tmax, fault, one);
    out.tests += one.tests;
    if (one.count != 0) out.add(reference, maximum(one.step[0].enter, 0.0f), minimum(one.step[0].exit, ray.tmax));
  };
  root(frame.static_root, frame.static_lo, frame.static_hi);
  root(frame.dynamic_root, frame.dynamic_lo, frame.dynamic_hi);
}

}  // namespace artu::hw
