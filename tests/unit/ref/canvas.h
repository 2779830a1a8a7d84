// An image to render selectively, whose pixels' rays see what a test says.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "ref/selective.h"

namespace artu::ref {

struct Canvas {
  std::vector<Pixel> pixels;
  Image image;
  int traced = 0;

  Canvas(std::uint32_t width, std::uint32_t height)
      : pixels(std::size_t{width} * height), image{width, height, pixels} {}

  /// `classes`: a letter a pixel, s d m; `codes`: the colour of red, green half of it, blue 0.
  void render(const Settings& settings, const std::string& classes, const std::vector<int>& codes) {
    render_passes(settings, image, [&](std::uint32_t x, std::uint32_t y, Pixel& pixel) {
      ++traced;
      const std::size_t i = std::size_t{y} * image.width + x;
      const char c = classes[i];
      pixel.hit_class = c == 's' ? HitClass::static_geometry : c == 'd' ? HitClass::dynamic_geometry : HitClass::miss;
      pixel.r = static_cast<std::uint8_t>(codes[i]);
      pixel.g = static_cast<std::uint8_t>(codes[i] / 2);
    });
  }

  void expect(std::uint32_t x, std::uint32_t y, int pass, int n_static, int n_dynamic, int threshold, int difference,
              Decision decision, int r) const {
    const Pixel& p = image.at(x, y);
    SCOPED_TRACE("pixel " + std::to_string(x) + ", " + std::to_string(y));
    EXPECT_EQ(p.pass, pass);
    EXPECT_EQ(p.n_static, n_static);
    EXPECT_EQ(p.n_dynamic, n_dynamic);
    EXPECT_EQ(p.threshold, threshold);
    EXPECT_EQ(p.difference, difference);
    EXPECT_EQ(p.decision, decision);
    EXPECT_EQ(p.r, r);
    EXPECT_EQ(p.hit_class == HitClass::none, decision == Decision::interpolated);
  }
};

inline constexpr Decision sampled = Decision::sampled, interpolated = Decision::interpolated, traced = Decision::traced;

}  // namespace artu::ref
