// A frame's candidates as a test sees them: counts and pairs found anew from the records of the other pixels.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "golden/harness.h"

namespace artu::golden_tests {

struct SeenCandidate {
  const hw::PixelRecord& record;
  std::uint32_t x, y, h;  // h: distance of its neighbours
  int n_static = 0, n_dynamic = 0;
  std::vector<std::pair<const hw::PixelRecord*, const hw::PixelRecord*>> pairs;  // empty where one is incomplete
};

inline const hw::PixelRecord& record_at(const sim::FrameOutcome& outcome, std::uint32_t x, std::uint32_t y) {
  return outcome.pixels[std::size_t{y} * outcome.width + x];
}

inline std::string at_text(std::uint32_t x, std::uint32_t y) {
  return "pixel " + std::to_string(x) + ", " + std::to_string(y);
}

namespace detail {

inline void count(const sim::FrameOutcome& outcome, SeenCandidate& seen) {
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const std::int64_t x = std::int64_t{seen.x} + dx * std::int64_t{seen.h};
      const std::int64_t y = std::int64_t{seen.y} + dy * std::int64_t{seen.h};
      if (x < 0 || y < 0 || x >= outcome.width || y >= outcome.height) continue;
      const hw::PixelRecord& p = record_at(outcome, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
      if (p.pass >= seen.record.pass || p.decision == hw::Decision::interpolated) continue;
      seen.n_static += p.hit_class == hw::HitClass::static_geometry;
      seen.n_dynamic += p.hit_class == hw::HitClass::dynamic_geometry;
    }
  }
}

inline void find_pairs(const sim::FrameOutcome& outcome, hw::Passes passes, SeenCandidate& seen) {
  const std::uint32_t x = seen.x, y = seen.y, h = seen.h;
  const bool between_columns = x % (2 * h) != 0, between_rows = y % (2 * h) != 0;
  const bool horizontal = between_columns && (!between_rows || passes == hw::Passes::average);
  if ((horizontal && x + h >= outcome.width) || (between_rows && y + h >= outcome.height)) return;
  if (horizontal) seen.pairs.emplace_back(&record_at(outcome, x - h, y), &record_at(outcome, x + h, y));
  if (between_rows) seen.pairs.emplace_back(&record_at(outcome, x, y - h), &record_at(outcome, x, y + h));
}

}  // namespace detail

/// In the order of rows.  A candidate's level is the largest power of two that divides both its coordinates.
inline std::vector<SeenCandidate> candidates_of(const sim::FrameOutcome& outcome,
                                                const hw::SelectiveConfig& config = {}) {
  std::vector<SeenCandidate> all;
  for (std::uint32_t y = 0; y < outcome.height; ++y) {
    for (std::uint32_t x = 0; x < outcome.width; ++x) {
      if (x % config.stride == 0 && y % config.stride == 0) continue;
      std::uint32_t h = 1;
      while ((x | y) % (2 * h) == 0) h *= 2;
      SeenCandidate seen{record_at(outcome, x, y), x, y, h, 0, 0, {}};
      detail::count(outcome, seen);
      detail::find_pairs(outcome, config.passes, seen);
      all.push_back(std::move(seen));
    }
  }
  return all;
}

/// The largest of the channels' differences, which is the default metric.
inline int channel_difference(const hw::PixelRecord& a, const hw::PixelRecord& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

inline bool same_color(const hw::PixelRecord& a, const hw::PixelRecord& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

/// Static ground and sphere, which is a mirror, and a moving sphere; every candidate that has a pair in the image's
/// width and height finds it, as both are one more than a multiple of 8.
inline Recipe attention_recipe(std::uint32_t width = 65, std::uint32_t height = 49) {
  Recipe recipe;
  recipe.width = width;
  recipe.height = height;
  recipe.mirror = true;
  return recipe;
}

}  // namespace artu::golden_tests
