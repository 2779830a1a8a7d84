#include "sim/driver/tree_morton.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace artu::sim {

namespace {

// In binary64 no sum or difference of a trace's coordinates overflows.
double centre(const Box& box, int axis) { return (double{box.lo[axis]} + double{box.hi[axis]}) / 2; }

/// The radix tree over codes in order.
class Radix {
 public:
  Radix(const std::vector<std::uint64_t>& codes, std::uint32_t leaf_size, const BinaryNodes& made)
      : codes_(codes), leaf_size_(leaf_size), made_(made) {}

  /// Of the places first ... last.
  BinaryNode* node(std::size_t first, std::size_t last) {
    if (last - first < leaf_size_) return made_.leaf(first, last - first + 1);
    const std::size_t split = last_below(first, last);
    BinaryNode* below = node(first, split);
    return made_.inner(below, node(split + 1, last));
  }

 private:
  /// The last place that is 0 in the highest bit in which the range differs: of the codes, or where these are all the
  /// same of the places themselves, as Karras does.
  std::size_t last_below(std::size_t first, std::size_t last) const {
    const bool same = codes_[first] == codes_[last];
    const auto key = [&](std::size_t place) { return same ? std::uint64_t{place} : codes_[place]; };
    std::uint64_t bit = 1;
    for (std::uint64_t differ = key(first) ^ key(last); differ > 1; differ >>= 1) bit <<= 1;
    std::size_t below = first, above = last;
    while (above - below > 1) {
      const std::size_t middle = below + (above - below) / 2;
      ((key(middle) & bit) == 0 ? below : above) = middle;
    }
    return below;
  }

  const std::vector<std::uint64_t>& codes_;
  const std::uint32_t leaf_size_;
  const BinaryNodes& made_;
};

}  // namespace

std::uint64_t interleave(std::uint32_t x, std::uint32_t y, std::uint32_t z, unsigned bits) {
  std::uint64_t code = 0;
  for (unsigned bit = bits; bit-- > 0;) {
    code = code << 3 | std::uint64_t{(x >> bit & 1) << 2 | (y >> bit & 1) << 1 | (z >> bit & 1)};
  }
  return code;
}

Box centre_box(const std::vector<Box>& boxes) {
  double lo[3], hi[3];
  for (int axis = 0; axis < 3; ++axis) {
    lo[axis] = hi[axis] = centre(boxes[0], axis);
    for (const Box& box : boxes) {
      lo[axis] = std::min(lo[axis], centre(box, axis));
      hi[axis] = std::max(hi[axis], centre(box, axis));
    }
  }
  const auto vector = [](const double* v) {
    return hw::Vector{static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
  };
  return {vector(lo), vector(hi)};
}

std::vector<std::uint64_t> morton_codes(const std::vector<Box>& boxes, const Box& grid, unsigned bits) {
  const double cells = std::ldexp(1.0, static_cast<int>(bits));
  const auto cell = [&](const Box& box, int axis) {
    const double extent = double{grid.hi[axis]} - grid.lo[axis];
    if (!(extent > 0)) return std::uint32_t{0};
    const double at = (centre(box, axis) - grid.lo[axis]) / extent * cells;
    return static_cast<std::uint32_t>(std::clamp(at, 0.0, cells - 1));
  };
  std::vector<std::uint64_t> codes;
  codes.reserve(boxes.size());
  for (const Box& box : boxes) codes.push_back(interleave(cell(box, 0), cell(box, 1), cell(box, 2), bits));
  return codes;
}

BinaryNode* build_morton(const std::vector<Box>& boxes, const TreeRecipe& recipe, const BinaryNodes& made) {
  Box grid = boxes[0];
  if (recipe.builder.known_box) {
    for (const Box& box : boxes) grow(grid, box);
  } else {
    grid = centre_box(boxes);
  }
  const std::vector<std::uint64_t> codes = morton_codes(boxes, grid, recipe.builder.code_bits);
  // The order that the unit's radix sort ends with: its passes are stable.
  std::stable_sort(made.ids.begin(), made.ids.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return codes[a] < codes[b]; });
  std::vector<std::uint64_t> sorted;
  sorted.reserve(codes.size());
  for (const std::uint32_t id : made.ids) sorted.push_back(codes[id]);
  return Radix(sorted, recipe.leaf_size, made).node(0, sorted.size() - 1);
}

}  // namespace artu::sim
