// One step of a traversal: the children of a node that a ray meets, nearest first, for every kind of tree
// (docs/arithmetic.md, section 4 and docs/trees.md).
#pragma once

#include <array>

#include "hw/datapath/box.h"
#include "hw/memory/layout.h"

namespace artu::hw {

/// A child to visit: its reference and the ray's interval in it.
struct Step {
  std::uint32_t node = NodeReference::none;
  float enter = 0, exit = 0;
};

/// The children to visit, by rising `enter`; on equal ones by rising index.
struct Steps {
  std::uint32_t count = 0;
  std::uint32_t tests = 0;  // boxes or planes that were tested
  std::array<Step, 8> step;

  void add(std::uint32_t node, float enter, float exit) {
    std::uint32_t i = count++;
    for (; i > 0 && enter < step[i - 1].enter; --i) step[i] = step[i - 1];
    step[i] = {node, enter, exit};
  }
};

/// Planes of a wide node's child i on an axis, as every test decodes them.
template <int Width>
float decoded_lo(const WideNodeRecord<Width>& node, int axis, int i) {
  return node.origin[axis] + static_cast<float>(node.lo[axis][i]) * float_of(std::uint32_t{node.exponent[axis]} << 23);
}
template <int Width>
float decoded_hi(const WideNodeRecord<Width>& node, int axis, int i) {
  return node.origin[axis] + static_cast<float>(node.hi[axis][i]) * float_of(std::uint32_t{node.exponent[axis]} << 23);
}

/// Tests one box; `fault` bits are xored into the interval's end (0 in a sound unit).
inline void test_box(const Ray& ray, Vector lo, Vector hi, std::uint32_t node, float limit, std::uint32_t fault,
                     Steps& out) {
  Interval box = box_interval(ray, lo, hi);
  if (fault != 0) box.exit = float_of(bits_of(box.exit) ^ fault);
  ++out.tests;
  if (meets(box, limit)) out.add(node, box.enter, box.exit);
}

/// Visits the node whose record lies at `record`, of the given kind, with the interval that `from` had when it was
/// chosen; `limit` is the best t so far, or tmax.
void visit_node(TreeKind kind, const void* record, const Ray& ray, const Step& from, float limit, std::uint32_t fault,
                Steps& out);

/// The first step of a ray: both root boxes.  A root that is `none` is left out.
void visit_roots(const FrameDescriptor& frame, const Ray& ray, std::uint32_t fault, Steps& out);

}  // namespace artu::hw
