#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "sim/precision/report.h"

namespace artu::sim {
namespace {

using Rgb = std::array<double, 3>;

/// 0 to 1 by what was 1 to 255.
Rgb heat(double x) {
  static constexpr double stops[5][3] = {{40, 40, 160}, {140, 30, 140}, {225, 50, 50}, {250, 190, 40}, {255, 255, 255}};
  const double at = x * 4;
  const int i = std::min(static_cast<int>(at), 3);
  Rgb color;
  for (int c = 0; c < 3; ++c) color[c] = stops[i][c] + (stops[i + 1][c] - stops[i][c]) * (at - i);
  return color;
}

}  // namespace

Image heat_map(const Image& a, const Image& b) {
  Image map = a;
  for (std::size_t i = 0; i < map.rgb.size(); i += 3) {
    int d = 0;
    for (std::size_t c = i; c < i + 3; ++c) d = std::max(d, std::abs(int{a.rgb[c]} - int{b.rgb[c]}));
    const Rgb color = d == 0 ? Rgb{0, 0, 0} : heat(std::log(d) / std::log(255));
    for (std::size_t c = 0; c < 3; ++c) map.rgb[i + c] = static_cast<std::uint8_t>(std::lround(color[c]));
  }
  return map;
}

std::string file_name(const std::string& picture_name) {
  std::string name = picture_name;
  std::replace(name.begin(), name.end(), '/', '-');
  if (name.size() == 2) name.insert(1, "0");  // "M7", so that names are in the order of the widths
  return name;
}

}  // namespace artu::sim
