#include "sim/compare/plane.h"

#include <algorithm>

namespace artu::sim {
namespace {

/// Along rows; the result is transposed, so that a second call goes along the columns and turns it back.
Plane along_rows_transposed(const Plane& in, const Kernel& kernel) {
  const std::size_t radius = kernel.size() / 2;
  Plane out{in.height, in.width, std::vector<double>(in.values.size())};
  std::vector<double> row(in.width + 2 * radius);  // with the border repeated
  for (std::uint32_t y = 0; y < in.height; ++y) {
    const double* first = &in.values[std::size_t{y} * in.width];
    std::fill_n(row.begin(), radius, first[0]);
    std::copy_n(first, in.width, row.begin() + static_cast<std::ptrdiff_t>(radius));
    std::fill(row.end() - static_cast<std::ptrdiff_t>(radius), row.end(), first[in.width - 1]);
    for (std::uint32_t x = 0; x < in.width; ++x) {
      double sum = 0;
      for (std::size_t i = 0; i < kernel.size(); ++i) sum += kernel[i] * row[x + i];
      out.values[std::size_t{x} * out.width + y] = sum;
    }
  }
  return out;
}

}  // namespace

Plane filtered(const Plane& plane, const Kernel& along_x, const Kernel& along_y) {
  if (plane.values.empty()) return plane;
  return along_rows_transposed(along_rows_transposed(plane, along_x), along_y);
}

}  // namespace artu::sim
