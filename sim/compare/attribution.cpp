#include "sim/compare/attribution.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace artu::sim {
namespace {

Cause cause_of(Area first, Area second, Area pixel) {
  if (first != second) return Cause::edge;
  return pixel == first ? Cause::within : Cause::missed;
}

Decided decided(const hw::PixelRecord& pixel, std::size_t index, const FullRender& full) {
  const Area own = area_of(full.classes[index]);
  if (pixel.decision != hw::Decision::interpolated) return {pixel.pass, Cause::traced, own, own, own};
  const PairPlace place = pair_of(pixel, index, full.image.width);
  Area first = area_of(full.classes[place.first]), second = area_of(full.classes[place.second]);
  if (second < first) std::swap(first, second);
  return {pixel.pass, cause_of(first, second, own), first, second, own};
}

}  // namespace

std::string Decided::pair() const {
  return fmt::format("{}-{}", area_names[static_cast<std::size_t>(first)],
                     area_names[static_cast<std::size_t>(second)]);
}

PairPlace pair_of(const hw::PixelRecord& pixel, std::size_t index, std::uint32_t width) {
  const std::size_t step = pixel.pass == 1 ? 1 : width;
  return {index - step, index + step};
}

void Attribution::add(const FullRender& full, const FrameOutcome& outcome) {
  for (std::size_t i = 0; i < outcome.pixels.size(); ++i) {
    const hw::PixelRecord& p = outcome.pixels[i];
    WrongPixel wrong{outcome.index,
                     static_cast<std::uint32_t>(i % outcome.width),
                     static_cast<std::uint32_t>(i / outcome.width),
                     decided(p, i, full),
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
