#include "ref/selective.h"

#include <cstdlib>
#include <stdexcept>
#include <utility>

namespace artu::ref {
namespace {

// Places in the ring, which goes row by row without the candidate in its middle.
constexpr std::size_t above = 1, left = 3, right = 4, below = 6;

Color color_of(const Pixel& pixel) { return {pixel.r, pixel.g, pixel.b}; }

int luma(Color c) { return (77 * c.r + 150 * c.g + 29 * c.b + 128) >> 8; }

// Only pixels of an earlier pass: those of the same pass may or may not be there yet, and results must not depend on
// timing.
Neighbour neighbour_at(const Settings& settings, const Image& image, std::uint32_t x, std::uint32_t y,
                       std::uint8_t pass) {
  Neighbour neighbour;
  if (x >= image.width || y >= image.height) return neighbour;  // left of and above the image wraps to large numbers
  if (place_of(settings, x, y).pass >= pass) return neighbour;
  const Pixel& pixel = image.at(x, y);
  neighbour.finished = true;
  neighbour.color = color_of(pixel);
  neighbour.hit_class = pixel.hit_class;
  return neighbour;
}

void gather_ring(const Settings& settings, const Image& image, Candidate& candidate) {
  std::size_t i = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (dx == 0 && dy == 0) continue;
      const std::uint32_t x = candidate.x + static_cast<std::uint32_t>(dx) * candidate.place.h;
      const std::uint32_t y = candidate.y + static_cast<std::uint32_t>(dy) * candidate.place.h;
      candidate.ring[i++] = neighbour_at(settings, image, x, y, candidate.place.pass);
    }
  }
}

void gather_pairs(const Settings& settings, Candidate& candidate) {
  std::array<std::pair<std::size_t, std::size_t>, 2> places;
  std::size_t count = 0;
  if (candidate.place.kind != PassKind::vertical) places[count++] = {left, right};
  if (candidate.place.kind != PassKind::horizontal) places[count++] = {above, below};
  int difference = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Neighbour &a = candidate.ring[places[i].first], &b = candidate.ring[places[i].second];
    if (!a.finished || !b.finished) {
      candidate.pair = {};  // of a centre both or none
      return;
    }
    candidate.pair[i] = {a.color, b.color};
    difference += difference_of(settings.metric, a.color, b.color);
  }
  candidate.pairs = static_cast<int>(count);
  candidate.difference = difference;
}

/// The mean of the pairs' colours, halves rounded up.
void interpolate(const Candidate& candidate, Pixel& pixel) {
  const int pixels = 2 * candidate.pairs;
  int r = candidate.pairs, g = r, b = r;  // half of what is divided by
  for (int i = 0; i < candidate.pairs; ++i) {
    const Pair& pair = candidate.pair[static_cast<std::size_t>(i)];
    r += pair.a.r + pair.b.r;
    g += pair.a.g + pair.b.g;
    b += pair.a.b + pair.b.b;
  }
  pixel.r = static_cast<std::uint8_t>(r / pixels);
  pixel.g = static_cast<std::uint8_t>(g / pixels);
  pixel.b = static_cast<std::uint8_t>(b / pixels);
}

}  // namespace

void check(const Settings& settings) {
  if (settings.stride != 2 && settings.stride != 4 && settings.stride != 8) {
    throw std::invalid_argument("stride is " + std::to_string(settings.stride) + ", not 2, 4 or 8");
  }
  if (settings.count == Count::merged && settings.compare != Compare::reference_count) {
    throw std::invalid_argument(
        "a merged count has no sides to compare: it needs the comparison with a reference count");
  }
  if (settings.reference_count < 0 || settings.reference_count > 8) {
    throw std::invalid_argument("reference_count is " + std::to_string(settings.reference_count) + ", not 0 ... 8");
  }
  policy_named(settings.policy);
}

int difference_of(Metric metric, Color a, Color b) {
  const int red = std::abs(a.r - b.r), green = std::abs(a.g - b.g), blue = std::abs(a.b - b.b);
  switch (metric) {
    case Metric::sum:
      return red + green + blue;
    case Metric::luma:
      return std::abs(luma(a) - luma(b));
    case Metric::max_channel:
      break;
  }
  const int larger = red > green ? red : green;
  return larger > blue ? larger : blue;
}

Candidate candidate_at(const Settings& settings, const Image& image, std::uint32_t x, std::uint32_t y) {
  Candidate candidate;
  candidate.x = x;
  candidate.y = y;
  candidate.place = place_of(settings, x, y);
  gather_ring(settings, image, candidate);
  for (const Neighbour& neighbour : candidate.ring) {
    candidate.n_static += neighbour.hit_class == HitClass::static_geometry;
    candidate.n_dynamic += neighbour.hit_class == HitClass::dynamic_geometry;
  }
  gather_pairs(settings, candidate);
  return candidate;
}

void decide(const Settings& settings, Policy policy, const Image& image, std::uint32_t x, std::uint32_t y) {
  const Candidate candidate = candidate_at(settings, image, x, y);
  const int threshold = policy(candidate, settings);
  if (threshold < 0 || threshold > 255) {
    throw std::logic_error("policy \"" + settings.policy + "\": threshold " + std::to_string(threshold));
  }
  Pixel& pixel = image.at(x, y);
  pixel.pass = candidate.place.pass;
  pixel.n_static = static_cast<std::uint8_t>(candidate.n_static);
  pixel.n_dynamic = static_cast<std::uint8_t>(candidate.n_dynamic);
  pixel.threshold = static_cast<std::int16_t>(threshold);
  pixel.difference = static_cast<std::int16_t>(candidate.difference);
  // The sum over two pairs against twice the threshold: their mean without a division.
  const bool similar = candidate.pairs > 0 && candidate.difference <= candidate.pairs * threshold;
  pixel.decision = similar ? Decision::interpolated : Decision::traced;
  if (similar) interpolate(candidate, pixel);
}

}  // namespace artu::ref
