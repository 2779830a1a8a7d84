#include "ref/selective.h"

#include <cstdlib>

namespace artu::ref {
namespace {

int clamped(int x, int lowest, int highest) { return x < lowest ? lowest : x > highest ? highest : x; }

int move_of(const Settings& settings, int difference) {
  switch (settings.magnitude) {
    case Magnitude::fixed:
      return settings.step;
    case Magnitude::proportional:
      return settings.step * difference;
    case Magnitude::progressive:
      break;
  }
  return settings.table[static_cast<std::size_t>(difference - 1)];
}

// Neighbours of an earlier pass only: those of the same pass may or may not be there yet, and results must not
// depend on timing.
void count_neighbours(const Image& image, std::uint32_t x, std::uint32_t y, Pixel& pixel) {
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const std::uint32_t nx = x + static_cast<std::uint32_t>(dx), ny = y + static_cast<std::uint32_t>(dy);
      if (nx >= image.width || ny >= image.height) continue;  // -1 wraps to the largest number
      if (pass_of(nx, ny) >= pixel.pass) continue;            // the candidate itself too
      const HitClass hit = image.at(nx, ny).hit_class;        // `none` where interpolated
      if (hit == HitClass::static_geometry) ++pixel.n_static;
      if (hit == HitClass::dynamic_geometry) ++pixel.n_dynamic;
    }
  }
}

int color_difference(const Pixel& a, const Pixel& b) {
  const int r = std::abs(a.r - b.r), g = std::abs(a.g - b.g), bl = std::abs(a.b - b.b);
  const int rg = r > g ? r : g;
  return rg > bl ? rg : bl;
}

std::uint8_t halfway(std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>((a + b + 1) >> 1); }

}  // namespace

int threshold_of(const Settings& settings, int n_static, int n_dynamic) {
  int threshold = settings.reference;
  if (settings.adaptive && n_static != n_dynamic) {
    const int move = move_of(settings, std::abs(n_dynamic - n_static));
    threshold = n_dynamic > n_static ? threshold - move : threshold + move;
  }
  return clamped(threshold, settings.minimum, settings.maximum);
}

void decide(const Settings& settings, const Image& image, std::uint32_t x, std::uint32_t y) {
  Pixel& pixel = image.at(x, y);
  pixel.pass = pass_of(x, y);
  count_neighbours(image, x, y, pixel);
  pixel.threshold = static_cast<std::int16_t>(threshold_of(settings, pixel.n_static, pixel.n_dynamic));
  pixel.decision = Decision::traced;

  // The pair always begins left of or above the candidate, inside the image; its other half may be missing.
  const bool horizontal = pixel.pass == 1;
  if (horizontal ? x + 1 >= image.width : y + 1 >= image.height) return;
  const Pixel& a = horizontal ? image.at(x - 1, y) : image.at(x, y - 1);
  const Pixel& b = horizontal ? image.at(x + 1, y) : image.at(x, y + 1);
  pixel.difference = static_cast<std::int16_t>(color_difference(a, b));
  if (pixel.difference > pixel.threshold) return;
  pixel.decision = Decision::interpolated;
  pixel.r = halfway(a.r, b.r);
  pixel.g = halfway(a.g, b.g);
  pixel.b = halfway(a.b, b.b);
}

}  // namespace artu::ref
