#include "sim/compare/attribution.h"

#include <fmt/format.h>

#include <algorithm>

namespace artu::sim {
namespace {

Cause cause_of(Area first, Area second, Area pixel) {
  if (first != second) return Cause::edge;
  return pixel == first ? Cause::within : Cause::missed;
}

Decided decided(const hw::PixelRecord& pixel, std::size_t index, const FullRender& full, bool average) {
  const Area own = area_of(full.classes[index]);
  if (pixel.decision != hw::Decision::interpolated) return {pixel.pass, Cause::traced, own, own, own};
  const Sources sources = sources_of(index, full.image.width, average);
  Area first = area_of(full.classes.at(sources.pixels[0])), second = first;
  for (std::size_t i = 1; i < sources.count; ++i) {
    const Area area = area_of(full.classes.at(sources.pixels[i]));
    first = std::min(first, area);
    second = std::max(second, area);
  }
  return {pixel.pass, cause_of(first, second, own), first, second, own};
}

}  // namespace

std::string Decided::pair() const {
  return fmt::format("{}-{}", area_names[static_cast<std::size_t>(first)],
                     area_names[static_cast<std::size_t>(second)]);
}

Sources sources_of(std::size_t index, std::uint32_t width, bool average) {
  const std::size_t x = index % width, y = index / width;
  // The distance to the sources is the largest power of two that divides both: a level's sampling pixels lie at
  // multiples of twice as much.
  const std::size_t both = x | y, distance = both & (~both + 1);
  const bool across = x & distance, down = y & distance;
  const std::size_t left = index - distance, right = index + distance;
  const std::size_t above = index - distance * width, below = index + distance * width;
  if (across && down && average) return {{left, right, above, below}, 4};
  if (down) return {{above, below}, 2};
  return {{left, right}, 2};
}

void Attribution::add(const FullRender& full, const FrameOutcome& outcome) {
  for (std::size_t i = 0; i < outcome.pixels.size(); ++i) {
    const hw::PixelRecord& p = outcome.pixels[i];
    WrongPixel wrong{outcome.index,
                     static_cast<std::uint32_t>(i % outcome.width),
                     static_cast<std::uint32_t>(i / outcome.width),
                     decided(p, i, full, average_),
                     p.threshold,
                     p.difference,
                     {p.r, p.g, p.b},
                     {full.image.rgb[3 * i], full.image.rgb[3 * i + 1], full.image.rgb[3 * i + 2]}};
    for (std::size_t c = 0; c < 3; ++c) {
      const int d = int{wrong.got[c]} - int{wrong.full[c]};
      wrong.squares += static_cast<std::uint64_t>(d * d);
    }
    Share& share = shares_[wrong.decided];
    ++share.pixels;
    share.squares += wrong.squares;
    if (wrong.squares != 0) keep(wrong);
  }
}

void Attribution::add(const Attribution& later) {
  for (const auto& [what, share] : later.shares_) {
    Share& sum = shares_[what];
    sum.pixels += share.pixels;
    sum.squares += share.squares;
  }
  for (const WrongPixel& pixel : later.worst_) keep(pixel);
}

void Attribution::keep(const WrongPixel& pixel) {
  if (worst_.size() == kept_ && (kept_ == 0 || worst_.back().squares >= pixel.squares)) return;
  const auto place = std::upper_bound(worst_.begin(), worst_.end(), pixel,
                                      [](const auto& a, const auto& b) { return a.squares > b.squares; });
  worst_.insert(place, pixel);
  if (worst_.size() > kept_) worst_.pop_back();
}

std::uint64_t Attribution::squares() const {
  std::uint64_t sum = 0;
  for (const auto& [what, share] : shares_) sum += share.squares;
  return sum;
}

}  // namespace artu::sim
