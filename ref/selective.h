// Selective rendering (docs/selective-rendering.md): integers only, independent of how a pixel is traced.
#pragma once

#include <cstdint>
#include <vector>

#include "ref/golden.h"
#include "ref/policy.h"

namespace artu::ref {

struct Image {
  std::uint32_t width, height;
  std::vector<Pixel>& pixels;  // row by row

  Pixel& at(std::uint32_t x, std::uint32_t y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

/// Throws std::invalid_argument where the settings of selective rendering are not ones of docs/selective-rendering.md.
void check(const Settings& settings);

/// The colour difference of two pixels.
int difference_of(Metric metric, Color a, Color b);

/// What the image says of a candidate before its decision.
Candidate candidate_at(const Settings& settings, const Image& image, std::uint32_t x, std::uint32_t y);

/// Fills in what is known of a candidate before any ray: pass, counts, threshold, difference and decision, and the
/// colour if that is to interpolate.  Throws std::logic_error where the policy leaves its range.
void decide(const Settings& settings, Policy policy, const Image& image, std::uint32_t x, std::uint32_t y);

/// Renders the passes in their order; `trace(x, y, pixel)` ray traces a pixel and fills in colour and hit.
template <class Trace>
void render_passes(const Settings& settings, const Image& image, Trace&& trace) {
  check(settings);
  const Policy policy = policy_named(settings.policy);
  const int passes = pass_count(settings);
  for (int pass = 0; pass < passes; ++pass) {
    for (std::uint32_t y = 0; y < image.height; ++y) {
      for (std::uint32_t x = 0; x < image.width; ++x) {
        if (place_of(settings, x, y).pass != pass) continue;
        Pixel& pixel = image.at(x, y);
        if (pass > 0) decide(settings, policy, image, x, y);
        if (pixel.decision != Decision::interpolated) trace(x, y, pixel);
      }
    }
  }
}

}  // namespace artu::ref
