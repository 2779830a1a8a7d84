#include "unit/ref/canvas.h"

namespace artu::ref {
namespace {

TEST(Selective, OnePixelIsSampled) {
  Canvas c(1, 1);
  c.render({}, "d", {7});
  c.expect(0, 0, 0, 0, 0, -1, -1, sampled, 7);
}

TEST(Selective, SingleRowAndColumnTraceTheirIncompletePairs) {
  Canvas row(2, 1);
  row.render({}, "sd", {10, 20});
  row.expect(0, 0, 0, 0, 0, -1, -1, sampled, 10);
  row.expect(1, 0, 1, 1, 0, 18, -1, traced, 20);  // 16 + 2 * 1
  Canvas column(1, 2);
  column.render({}, "ds", {10, 20});
  column.expect(0, 1, 2, 0, 1, 14, -1, traced, 20);
}

// d . s      200 . 100
// . . .          .
// s . m      100 . 102
TEST(Selective, ThreeByThree) {
  Settings s;  // reference 16, step 2, proportional
  Canvas c(3, 3);
  c.render(s, "dsssssssm", {200, 50, 100, 51, 52, 53, 100, 54, 102});
  c.expect(0, 0, 0, 0, 0, -1, -1, sampled, 200);
  // Between d and s: equal counts, difference 100 (red; green's is 50).
  c.expect(1, 0, 1, 1, 1, 16, 100, traced, 50);
  // Between s and a miss, which counts nothing.
  c.expect(1, 2, 1, 1, 0, 18, 2, interpolated, 101);
  EXPECT_EQ(c.image.at(1, 2).g, 51);  // (50 + 51 + 1) / 2
  // Left: d above, the traced static beside it, s below; the interpolated neighbour counts nothing.
  c.expect(0, 1, 2, 2, 1, 18, 100, traced, 51);
  // Centre: the same three rows of neighbours; (0, 1) and (2, 1) are of its own pass.  d, s, s, s; miss, interpolated.
  c.expect(1, 1, 2, 3, 1, 20, 51, traced, 52);
  // Right: s and the traced s above it, a miss below: 100 against 102.
  c.expect(2, 1, 2, 2, 0, 20, 2, interpolated, 101);
  EXPECT_EQ(c.traced, 4 + 1 + 2);
}

TEST(Selective, DifferenceEqualToTheThresholdInterpolates) {
  Settings s;
  s.adaptive = false;
  s.reference = 10;
  Canvas c(5, 1);
  c.render(s, "sssss", {10, 0, 20, 0, 31});
  c.expect(1, 0, 1, 2, 0, 10, 10, interpolated, 15);
  c.expect(3, 0, 1, 2, 0, 10, 11, traced, 0);
}

TEST(Selective, InterpolationRoundsUp) {
  Canvas c(3, 1);
  c.render({}, "mmm", {10, 0, 13});
  c.expect(1, 0, 1, 0, 0, 16, 3, interpolated, 12);
}

TEST(Selective, AnyChannelDecides) {
  Settings s;
  s.adaptive = false;
  s.reference = 5;
  std::vector<Pixel> pixels(3);
  const Image image{3, 1, pixels};
  render_passes(s, image, [](std::uint32_t x, std::uint32_t, Pixel& pixel) {
    pixel.hit_class = HitClass::miss;
    pixel.b = static_cast<std::uint8_t>(x == 0 ? 9 : 3);
  });
  EXPECT_EQ(pixels[1].difference, 6);
  EXPECT_EQ(pixels[1].decision, traced);
}

// Samples at y = 0, 2, 4; vertical candidates at y = 1, 3.  Width 3: x = 1 has a complete pair on even rows.
TEST(Selective, ThreeByFiveInAllMagnitudes) {
  const std::string classes = "dmddmddmddmddmd";
  const std::vector<int> codes = {10, 90, 10, 91, 92, 93, 10, 94, 10, 95, 96, 97, 10, 98, 10};
  for (const auto& [magnitude, two, six] :
       {std::tuple{Magnitude::fixed, 2, 2}, {Magnitude::proportional, 4, 8}, {Magnitude::progressive, 2, 7}}) {
    Settings s;
    s.magnitude = magnitude;
    Canvas c(3, 5);
    c.render(s, classes, codes);
    for (std::uint32_t y : {0u, 2u, 4u}) c.expect(1, y, 1, 0, 2, 16 - two, 0, interpolated, 10);
    for (std::uint32_t y : {1u, 3u}) {
      c.expect(0, y, 2, 0, 2, 16 - two, 0, interpolated, 10);
      c.expect(1, y, 2, 0, 4, 16 - six, 0, interpolated, 10);
      c.expect(2, y, 2, 0, 2, 16 - two, 0, interpolated, 10);
    }
    EXPECT_EQ(c.traced, 6);
  }
}

TEST(Selective, EvenHeightTracesItsLastRow) {
  Canvas c(3, 2);
  c.render({}, "sssddd", {1, 1, 1, 5, 6, 7});
  c.expect(1, 0, 1, 2, 0, 20, 0, interpolated, 1);
  c.expect(0, 1, 2, 1, 0, 18, -1, traced, 5);
  c.expect(1, 1, 2, 2, 0, 20, -1, traced, 6);  // of three above, the middle one is interpolated
  c.expect(2, 1, 2, 1, 0, 18, -1, traced, 7);
}

TEST(Selective, OffTracesEveryPixelInPassZero) {
  Settings s;
  s.selective = false;
  Canvas c(3, 2);
  c.render(s, "sdmsdm", {1, 2, 3, 4, 5, 6});
  for (std::uint32_t y = 0; y < 2; ++y) {
    for (std::uint32_t x = 0; x < 3; ++x) {
      c.expect(x, y, 0, 0, 0, -1, -1, sampled, static_cast<int>(y * 3 + x + 1));
    }
  }
  EXPECT_EQ(c.traced, 6);
}

}  // namespace
}  // namespace artu::ref
