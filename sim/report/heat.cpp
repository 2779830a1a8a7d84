#include "sim/report/heat.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace artu::sim {

Color heat_color(double x) {
  static constexpr double stops[5][3] = {{40, 40, 160}, {140, 30, 140}, {225, 50, 50}, {250, 190, 40}, {255, 255, 255}};
  const double at = std::clamp(x, 0.0, 1.0) * 4;
  const int i = std::min(static_cast<int>(at), 3);
  const auto code = [&](int c) {
    return static_cast<std::uint8_t>(std::lround(stops[i][c] + (stops[i + 1][c] - stops[i][c]) * (at - i)));
  };
  return {code(0), code(1), code(2)};
}

Color error_heat(int difference) {
  return difference == 0 ? Color{0, 0, 0} : heat_color(std::log(difference) / std::log(255));
}

Color code_heat(int code) { return heat_color(std::log2(1 + code) / 8); }

Color cycles_heat(std::uint32_t cycles) { return heat_color(cycles == 0 ? 0 : std::log10(cycles / 100.0) / 2); }

Image heat_map(const Image& a, const Image& b) {
  Image map = a;
  for (std::size_t i = 0; i < map.rgb.size(); i += 3) {
    int d = 0;
    for (std::size_t c = i; c < i + 3; ++c) d = std::max(d, std::abs(int{a.rgb[c]} - int{b.rgb[c]}));
    const Color color = error_heat(d);
    map.rgb[i] = color.r;
    map.rgb[i + 1] = color.g;
    map.rgb[i + 2] = color.b;
  }
  return map;
}

}  // namespace artu::sim
