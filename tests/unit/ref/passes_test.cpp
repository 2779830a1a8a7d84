// Levels and passes: which pixel belongs to which, and what a level makes of the one before.
#include <algorithm>

#include "unit/ref/canvas.h"

namespace artu::ref {
namespace {

Settings settings_of(int stride, Passes passes) {
  Settings s;
  s.stride = stride;
  s.passes = passes;
  return s;
}

void expect_map(const Settings& settings, const std::vector<std::string>& rows) {
  for (std::uint32_t y = 0; y < rows.size(); ++y) {
    std::string row;
    for (std::uint32_t x = 0; x < rows[y].size(); ++x) {
      row += "0123456789"[place_of(settings, x, y).pass];
    }
    EXPECT_EQ(row, rows[y]) << "row " << y;
  }
}

TEST(Passes, OfStrideTwo) {
  expect_map(settings_of(2, Passes::horizontal_vertical), {"01010", "22222", "01010"});
  expect_map(settings_of(2, Passes::average), {"01010", "23232", "01010"});
}

TEST(Passes, OfStrideFour) {
  expect_map(settings_of(4, Passes::horizontal_vertical), {"03130313", "44444444", "23232323", "44444444", "03130313"});
  expect_map(settings_of(4, Passes::average), {"04140414", "56565656", "24342434", "56565656", "04140414"});
}

TEST(Passes, OfStrideEight) {
  expect_map(settings_of(8, Passes::horizontal_vertical),
             {"053515350", "666666666", "454545454", "666666666", "253525352", "666666666", "454545454", "666666666",
              "053515350"});
  expect_map(settings_of(8, Passes::average), {"074717470", "898989898", "576757675", "898989898", "274737472",
                                               "898989898", "576757675", "898989898", "074717470"});
  EXPECT_EQ(pass_count(settings_of(8, Passes::horizontal_vertical)), 7);
  EXPECT_EQ(pass_count(settings_of(8, Passes::average)), 10);
}

// Whatever the setting and the size, each pixel is rendered once, and in no pass before its pair.
TEST(Passes, RenderEveryPixelOnce) {
  for (int stride : {2, 4, 8}) {
    for (Passes passes : {Passes::horizontal_vertical, Passes::average}) {
      const Settings s = settings_of(stride, passes);
      for (std::uint32_t height = 1; height <= 17; ++height) {
        for (std::uint32_t width = 1; width <= 17; ++width) {
          std::vector<Pixel> pixels(std::size_t{width} * height);
          std::vector<int> traced(pixels.size(), 0);
          render_passes(s, Image{width, height, pixels}, [&](std::uint32_t x, std::uint32_t y, Pixel& pixel) {
            ++traced[std::size_t{y} * width + x];
            pixel.hit_class = HitClass::miss;
            pixel.r = 77;
          });
          for (std::size_t i = 0; i < pixels.size(); ++i) {
            const Pixel& p = pixels[i];
            ASSERT_EQ(traced[i], p.decision != Decision::interpolated) << width << " x " << height << " " << i;
            ASSERT_EQ(p.r, 77) << "a pair that was not finished";
            ASSERT_EQ(p.pass == 0, p.decision == Decision::sampled);
            ASSERT_EQ(p.decision == Decision::traced, p.difference < 0 && p.pass > 0) << "uniform: only the border";
          }
        }
      }
    }
  }
}

// With nothing between sampling pixels and border, S = 4 interpolates from what it interpolated before.
TEST(Levels, InterpolatedPixelsAreSamplesOfTheNext) {
  Settings s = settings_of(4, Passes::horizontal_vertical);
  Canvas c(5, 1);
  c.render(s, "d000d", {10, 0, 0, 0, 20});
  c.expect(2, 0, 1, 0, 2, 12, 10, interpolated, 15);
  // Of its two neighbours one is interpolated, and counts nothing.
  c.expect(1, 0, 3, 0, 1, 14, 5, interpolated, 13);
  c.expect(3, 0, 3, 0, 1, 14, 5, interpolated, 18);
  EXPECT_EQ(c.traced, 2);
}

TEST(Levels, TracedPixelsCountInTheNext) {
  Settings s = settings_of(4, Passes::horizontal_vertical);
  Canvas c(5, 1);
  c.render(s, "d0s0d", {10, 0, 90, 0, 30});
  c.expect(2, 0, 1, 0, 2, 12, 20, traced, 90);
  c.expect(1, 0, 3, 1, 1, 16, 80, traced, 0);
}

TEST(Levels, ABorderCandidateOfACoarseLevelIsTraced) {
  Settings s = settings_of(4, Passes::horizontal_vertical);
  Canvas c(4, 1);
  c.render(s, "ssss", {10, 0, 20, 30});
  c.expect(2, 0, 1, 1, 0, 18, -1, traced, 20);
  c.expect(1, 0, 3, 2, 0, 20, 10, interpolated, 15);
  c.expect(3, 0, 3, 1, 0, 18, -1, traced, 30);
}

TEST(Average, TheMeanOfBothDifferencesDecides) {
  Settings s = settings_of(2, Passes::average);
  s.adaptive = false;
  s.reference = 255;
  Canvas c(3, 3);
  // Pairs of the centre: 15 and 24 left and right, 10 and 30 above and below: 9 + 20 = 29.
  const std::string misses(9, 'm');
  const std::vector<int> codes = {0, 0, 20, 0, 99, 0, 30, 0, 29};
  c.render(s, misses, codes);
  c.expect(1, 0, 1, 0, 0, 255, 20, interpolated, 10);
  c.expect(1, 2, 1, 0, 0, 255, 1, interpolated, 30);
  c.expect(0, 1, 2, 0, 0, 255, 30, interpolated, 15);
  c.expect(2, 1, 2, 0, 0, 255, 9, interpolated, 25);
  c.expect(1, 1, 3, 0, 0, 255, 10 + 20, interpolated, 20);  // (15 + 25 + 10 + 30 + 2) >> 2
}

TEST(Average, TwiceTheThresholdIsTheLimit) {
  Settings s = settings_of(2, Passes::average);
  s.adaptive = false;
  s.reference = 10;
  // The pairs of the borders are at 10, so all but the centre are interpolated; its differences are 10 and 10 or less.
  Canvas at(3, 3), above(3, 3);
  const std::string misses(9, 'm');
  at.render(s, misses, {0, 0, 10, 0, 99, 0, 10, 0, 20});
  at.expect(1, 1, 3, 0, 0, 10, 20, interpolated, 10);
  // Now the upper and the left candidate are traced, and the pairs are 50 to 15 and 6 to 15.
  above.render(s, misses, {0, 6, 11, 50, 99, 0, 11, 0, 20});
  above.expect(1, 0, 1, 0, 0, 10, 11, traced, 6);
  above.expect(0, 1, 2, 0, 0, 10, 11, traced, 50);
  above.expect(1, 1, 3, 0, 0, 10, 34 + 10, traced, 99);
}

TEST(Average, ACentreWithoutOneOfItsPairsIsTraced) {
  Settings s = settings_of(2, Passes::average);
  Canvas c(2, 3), d(3, 2);
  c.render(s, "sssdss", {1, 1, 1, 9, 1, 1});
  c.expect(1, 1, 3, 4, 0, 24, -1, traced, 9);
  d.render(s, "ssssdm", {1, 1, 1, 1, 9, 1});
  d.expect(1, 1, 3, 3, 0, 22, -1, traced, 9);
}

// Where the scene is smooth, what is traced are the sampling pixels and the border.
TEST(Passes, TheTracedShareOfASmoothImage) {
  for (const auto& [stride, samples] : {std::pair{2, 32 * 32}, {4, 16 * 16}, {8, 8 * 8}}) {
    for (Passes passes : {Passes::horizontal_vertical, Passes::average}) {
      const Settings s = settings_of(stride, passes);
      std::vector<Pixel> pixels(std::size_t{64} * 64);
      render_passes(s, Image{64, 64, pixels}, [](std::uint32_t, std::uint32_t, Pixel& pixel) { pixel.r = 3; });
      EXPECT_EQ(std::count_if(pixels.begin(), pixels.end(), [](const Pixel& p) { return p.pass == 0; }), samples);
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        const std::size_t x = i % 64, y = i / 64, last = static_cast<std::size_t>(64 - stride);
        if (pixels[i].decision == Decision::traced) {
          EXPECT_TRUE(x > last || y > last) << x << ", " << y;
        }
      }
    }
  }
}

}  // namespace
}  // namespace artu::ref
