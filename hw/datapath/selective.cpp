#include "hw/datapath/selective.h"

#include <algorithm>
#include <cstdlib>

namespace artu::hw {

namespace {
/// 8 bits, of weights that add up to 256.
int luma(Rgb color) { return (77 * color.r + 150 * color.g + 29 * color.b + 128) >> 8; }
}  // namespace

HitCounts count_hits(const Ring& ring) {
  HitCounts counts;
  for (const Neighbour& neighbour : ring) {
    counts.n_static += neighbour.hit_class == HitClass::static_geometry;
    counts.n_dynamic += neighbour.hit_class == HitClass::dynamic_geometry;
  }
  return counts;
}

std::uint16_t color_difference(Metric metric, Rgb a, Rgb b) {
  const int red = std::abs(a.r - b.r), green = std::abs(a.g - b.g), blue = std::abs(a.b - b.b);
  int difference = 0;
  switch (metric) {
    case Metric::max_channel:
      difference = std::max({red, green, blue});
      break;
    case Metric::sum:
      difference = red + green + blue;
      break;
    case Metric::luma:
      difference = std::abs(luma(a) - luma(b));
      break;
  }
  return static_cast<std::uint16_t>(difference);
}

int color_difference(Metric metric, const Pairs& pairs) {
  if (pairs.count == 0) return -1;
  int sum = 0;
  for (std::size_t i = 0; i < pairs.count; ++i) sum += color_difference(metric, pairs.color[i][0], pairs.color[i][1]);
  return sum;
}

Rgb interpolate(const Pairs& pairs) {
  const auto mean = [&pairs](std::uint8_t Rgb::*channel) {
    unsigned sum = pairs.count;  // half of the number of colours, for the rounding
    for (std::size_t i = 0; i < pairs.count; ++i) sum += pairs.color[i][0].*channel + pairs.color[i][1].*channel;
    return static_cast<std::uint8_t>(sum >> pairs.count);
  };
  return {mean(&Rgb::r), mean(&Rgb::g), mean(&Rgb::b)};
}

}  // namespace artu::hw
