// How many operators each datapath has, for the energy of an event (docs/energy.md).
//
// Counted are operators that switch when a token goes through the pipeline: those of the longest path.  Not counted are
// what has no operator of its own (signs, shifts by powers of two, conversions, colour tables), and the rare path of a
// ray that is parallel to an axis.  tests/unit/hw/operations_test.cpp counts them in the datapaths' own source.
#pragma once

#include <cstdint>

#include "hw/unit_config.h"

namespace artu::hw {

struct Operations {
  std::uint32_t add = 0, multiply = 0, divide = 0, square_root = 0, compare = 0;

  friend constexpr Operations operator+(Operations a, Operations b) {
    return {a.add + b.add, a.multiply + b.multiply, a.divide + b.divide, a.square_root + b.square_root,
            a.compare + b.compare};
  }
  friend constexpr Operations operator*(std::uint32_t n, Operations a) {
    return {n * a.add, n * a.multiply, n * a.divide, n * a.square_root, n * a.compare};
  }
};

/// Of a datapath with a format of its own: what it computes in that format, and what in binary32.
struct DatapathOperations {
  Operations narrow, binary32;

  friend constexpr DatapathOperations operator+(DatapathOperations a, DatapathOperations b) {
    return {a.narrow + b.narrow, a.binary32 + b.binary32};
  }
};

namespace operations {

// In the box test's format.
inline constexpr DatapathOperations box_interval{{0, 7, 0, 0, 6}, {6, 0, 0, 0, 4}};
/// Whether the interval meets [0, limit].
inline constexpr DatapathOperations box_meets{{}, {0, 0, 0, 0, 3}};
/// A wide node's box from its 8-bit planes.
inline constexpr DatapathOperations box_decode{{}, {6, 6, 0, 0, 0}};
/// A plane of a kd-tree.
inline constexpr DatapathOperations plane{{0, 2, 0, 0, 0}, {1, 0, 0, 0, 7}};

/// A box of a node of this kind, its share of the sorting included; of a kd-tree, a plane.
constexpr DatapathOperations box_test(TreeKind kind) {
  // n boxes are sorted with at most n (n - 1) / 2 comparisons.
  const auto sorted = [](std::uint32_t n) { return DatapathOperations{{}, {0, 0, 0, 0, n / 2}}; };
  switch (kind) {
    case TreeKind::bvh2:
      return box_interval + box_meets + sorted(2);
    case TreeKind::bvh4:
      return box_decode + box_interval + box_meets + sorted(4);
    case TreeKind::bvh8:
      return box_decode + box_interval + box_meets + sorted(8);
    case TreeKind::kd:
      break;
  }
  return plane;
}

/// In the triangle test's format, without the box test that clamps t; its three differences of exact products are two
/// multiplications and an addition each.  With the comparison with the best hit so far.
inline constexpr DatapathOperations triangle_test{{13, 18, 1, 0, 5}, {9, 0, 0, 0, 20}};

// In the shading's format.
inline constexpr DatapathOperations texture_filter{{18, 9, 0, 0, 0}, {}};
inline constexpr DatapathOperations texture_address{{}, {8, 6, 0, 0, 2}};
inline constexpr DatapathOperations sky{{7, 4, 0, 0, 0}, {}};
inline constexpr DatapathOperations begin_shading{{3, 18, 0, 0, 0}, {}};
inline constexpr DatapathOperations add{{3, 0, 0, 0, 0}, {}};
inline constexpr DatapathOperations add_weighted{{3, 3, 0, 0, 0}, {}};
/// A spot light and ten squarings, the most.
inline constexpr DatapathOperations light{{16, 46, 4, 2, 13}, {7, 7, 0, 0, 4}};
/// Both a reflection and a refraction ray.
inline constexpr DatapathOperations next_rays{{9, 17, 1, 0, 1}, {21, 38, 3, 3, 21}};

// In binary32.
inline constexpr Operations primary_ray{16, 18, 1, 1, 2};
inline constexpr Operations ray_set_up{0, 0, 6, 0, 6};
inline constexpr Operations hit_point{57, 65, 4, 2, 34};

}  // namespace operations

// Of the selective blocks, on 8-bit integers, for a candidate.
namespace integer_operations {
inline constexpr std::uint32_t count_hits = 16;  // eight neighbours, two classes
inline constexpr std::uint32_t interpolate = 6;  // a sum and a rounding a channel
/// Three differences, two maxima or sums; or twice three products and three sums, and a difference.  One comparison.
constexpr std::uint32_t color_difference(Metric metric) { return metric == Metric::luma ? 14 : 6; }
}  // namespace integer_operations

}  // namespace artu::hw
