// One step of a traversal: the children of a node that a ray meets, nearest first, for every kind of tree
// (docs/arithmetic.md, section 4 and docs/trees.md) and every format of the box test.
#pragma once

#include <array>

#include "hw/datapath/box.h"
#include "hw/memory/layout.h"

namespace artu::hw {

/// A child to visit: its reference and the ray's interval in it.  Only a kd-tree's step needs the end; those of a BVH's
/// node may have any.
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

/// Visits the node whose record lies at `record`, of the given kind, with the interval that `from` had when it was
/// chosen; `limit` is the best t so far, or tmax; `padding` is P; `fault` bits are xored into every interval's end (0
/// in a sound unit).
using NodeVisit = void (*)(TreeKind kind, const void* record, const Ray& ray, const Step& from, float limit,
                           float padding, std::uint32_t fault, Steps& out);

/// The node visit of a box test with so many stored fraction bits.
NodeVisit node_visit(int fraction_bits);

}  // namespace artu::hw
