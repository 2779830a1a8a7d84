// Metrics: FLIP, the map of SSIM, errors by area, and what they come from.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim/compare/attribution.h"
#include "sim/compare/flip.h"
#include "sim/compare/image_metrics.h"

namespace artu::sim {
namespace {

using hw::HitClass;

Image one_color(std::uint32_t width, std::uint32_t height, std::uint8_t r, std::uint8_t g, std::uint8_t b) {
  Image image{width, height, {}};
  for (std::uint32_t i = 0; i < width * height; ++i) image.rgb.insert(image.rgb.end(), {r, g, b});
  return image;
}

Image grey(std::uint32_t width, const std::vector<std::uint8_t>& codes) {
  Image image{width, static_cast<std::uint32_t>(codes.size() / width), {}};
  for (const std::uint8_t code : codes) image.rgb.insert(image.rgb.end(), {code, code, code});
  return image;
}

TEST(Flip, EqualPicturesHaveNone) {
  const Image image = one_color(9, 7, 10, 200, 30);
  EXPECT_EQ(flip_map(image, image), std::vector<double>(63, 0.0));
}

TEST(Flip, OfFlatPicturesIsTheColorDifferenceAlone) {
  // Green and blue are as far apart as two colours can be by the definition: exactly 1.
  EXPECT_NEAR(flip_of(one_color(5, 5, 0, 255, 0), one_color(5, 5, 0, 0, 255)), 1, 1e-9);
  // Black and white: 100 in L alone, which is 25.12 to the power 0.7, beyond the knee at 0.4 of 41.28.
  EXPECT_NEAR(flip_of(one_color(5, 5, 0, 0, 0), one_color(5, 5, 255, 255, 255)), 0.95 + (25.12 - 16.51) / 24.77 * 0.05,
              1e-4);
}

TEST(Flip, IsSymmetricAndWithinZeroAndOne) {
  Image a = one_color(40, 30, 90, 90, 90), b = a;
  for (std::size_t i = 0; i < b.rgb.size(); i += 7) b.rgb[i] = static_cast<std::uint8_t>(i * 13);
  const std::vector<double> map = flip_map(a, b);
  EXPECT_EQ(map, flip_map(b, a));
  for (const double v : map) {
    EXPECT_GE(v, 0);
    EXPECT_LE(v, 1);
  }
}

TEST(Flip, WhatIsSeenFromFarAwayDiffersLess) {
  Image a = one_color(32, 32, 128, 128, 128), b = a;
  for (std::uint32_t i = 0; i < 32 * 32; ++i) {
    for (std::uint32_t c = 0; c < 3; ++c) b.rgb[3 * i + c] = (i + i / 32) % 2 == 0 ? 118 : 138;
  }
  EXPECT_LT(flip_of(a, b, 120), flip_of(a, b, 20));
}

TEST(Ssim, TheMapsMeanIsTheMetric) {
  Image a = one_color(20, 15, 50, 60, 70), b = a;
  for (std::size_t i = 0; i < b.rgb.size(); i += 11) b.rgb[i] = static_cast<std::uint8_t>(i);
  const std::vector<double> map = ssim_map(a, b);
  ASSERT_EQ(map.size(), 10u * 5u);
  double sum = 0;
  for (const double v : map) sum += v;
  EXPECT_NEAR(compare_images(a, b).ssim, sum / 50, 1e-12);
}

TEST(Errors, EveryAreaHasItsPixels) {
  const FullRender full{grey(3, {10, 10, 10, 10, 10, 10}),
                        {HitClass::miss, HitClass::static_geometry, HitClass::static_geometry,
                         HitClass::dynamic_geometry, HitClass::dynamic_geometry, HitClass::dynamic_geometry}};
  Errors errors;
  errors.add(full, grey(3, {10, 12, 10, 10, 10, 13}));
  EXPECT_EQ(errors.of(Area::whole).pixels, 6u);
  EXPECT_EQ(errors.of(Area::whole).squares, 3u * (4 + 9));
  EXPECT_EQ(errors.of(Area::background).pixels, 1u);
  EXPECT_EQ(errors.of(Area::background).psnr(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(errors.of(Area::static_geometry).pixels, 2u);
  EXPECT_NEAR(errors.of(Area::static_geometry).psnr(), 10 * std::log10(255.0 * 255 / 2), 1e-9);
  EXPECT_EQ(errors.of(Area::dynamic_geometry).squares, 27u);
  EXPECT_TRUE(std::isnan(errors.of(Area::whole).mean_ssim()));  // smaller than the window

  // Of two frames: from the mean of all squares, not the mean of two PSNR.
  errors.add(full, full.image);
  EXPECT_NEAR(errors.of(Area::static_geometry).psnr(), 10 * std::log10(255.0 * 255), 1e-9);
  double flip = 0;
  for (std::size_t i = 1; i < area_count; ++i) flip += errors.areas[i].flip;
  EXPECT_NEAR(flip, errors.of(Area::whole).flip, 1e-12);
}

TEST(Errors, AnAreaWithoutAPixelHasNoNumbers) {
  Errors errors;
  errors.add({grey(1, {5}), {HitClass::miss}}, grey(1, {9}));
  EXPECT_TRUE(std::isnan(errors.of(Area::dynamic_geometry).psnr()));
  EXPECT_TRUE(std::isnan(errors.of(Area::dynamic_geometry).mean_flip()));
}

TEST(Errors, AWindowBelongsToTheAreaOfItsCentre) {
  FullRender full{one_color(12, 11, 90, 90, 90), std::vector<HitClass>(12 * 11, HitClass::static_geometry)};
  full.classes[5 * 12 + 6] = HitClass::dynamic_geometry;  // the centre of the second of the two windows
  Errors errors;
  errors.add(full, full.image);
  EXPECT_EQ(errors.of(Area::whole).windows, 2u);
  EXPECT_EQ(errors.of(Area::static_geometry).windows, 1u);
  EXPECT_EQ(errors.of(Area::dynamic_geometry).windows, 1u);
  EXPECT_DOUBLE_EQ(errors.of(Area::dynamic_geometry).mean_ssim(), 1);
}

hw::PixelRecord interpolated(std::uint8_t pass, std::uint8_t code) {
  hw::PixelRecord pixel;
  pixel.pass = pass;
  pixel.decision = hw::Decision::interpolated;
  pixel.threshold = 9;
  pixel.difference = 4;
  pixel.r = pixel.g = pixel.b = code;
  return pixel;
}

hw::PixelRecord sampled(std::uint8_t code) {
  hw::PixelRecord pixel;
  pixel.hit_class = HitClass::static_geometry;
  pixel.r = pixel.g = pixel.b = code;
  return pixel;
}

TEST(Attribution, EveryCauseHasItsPixels) {
  // A row: sampled, missed, sampled, edge, sampled; below it one that was interpolated from above and below.
  const HitClass s = HitClass::static_geometry, d = HitClass::dynamic_geometry;
  const FullRender full{grey(5, {1, 9, 1, 5, 8, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}),
                        {s, d, s, d, d, s, s, s, s, s, s, s, s, s, s}};
  FrameOutcome outcome;
  outcome.index = 3;
  outcome.width = 5;
  outcome.height = 3;
  outcome.pixels.assign(15, sampled(1));
  outcome.pixels[1] = interpolated(1, 1);
  outcome.pixels[3] = interpolated(1, 4);
  outcome.pixels[4] = sampled(8);
  outcome.pixels[5] = interpolated(2, 3);
  Attribution attribution(2);
  attribution.add(full, outcome);

  const auto& shares = attribution.shares();
  const Decided missed{1, Cause::missed, Area::static_geometry, Area::static_geometry, Area::dynamic_geometry};
  const Decided edge{1, Cause::edge, Area::dynamic_geometry, Area::static_geometry, Area::dynamic_geometry};
  const Decided within{2, Cause::within, Area::static_geometry, Area::static_geometry, Area::static_geometry};
  EXPECT_EQ(edge.pair(), "dynamic-static");
  EXPECT_EQ(shares.at(missed).squares, 3u * 64);
  EXPECT_EQ(shares.at(edge).squares, 3u);
  EXPECT_EQ(shares.at(within).squares, 12u);
  EXPECT_EQ(attribution.squares(), 192u + 3 + 12);
  std::uint64_t pixels = 0;
  for (const auto& [what, share] : shares) pixels += share.pixels;
  EXPECT_EQ(pixels, 15u);

  ASSERT_EQ(attribution.worst().size(), 2u);
  const WrongPixel& worst = attribution.worst()[0];
  EXPECT_EQ(worst.frame, 3u);
  EXPECT_EQ(worst.x, 1u);
  EXPECT_EQ(worst.y, 0u);
  EXPECT_EQ(worst.full[0], 9);
  EXPECT_EQ(attribution.worst()[1].squares, 12u);
}

std::vector<std::size_t> sources(std::size_t x, std::size_t y, bool average = false) {
  const Sources s = sources_of(y * 100 + x, 100, average);
  return {s.pixels.begin(), s.pixels.begin() + static_cast<std::ptrdiff_t>(s.count)};
}

TEST(Attribution, AnInterpolatedPixelsPlaceSaysWhatItIsMadeOf) {
  using Places = std::vector<std::size_t>;
  EXPECT_EQ(sources(3, 4), (Places{402, 404}));  // sampling pixels two apart
  EXPECT_EQ(sources(4, 3), (Places{204, 404}));
  EXPECT_EQ(sources(3, 3), (Places{203, 403}));
  EXPECT_EQ(sources(3, 3, true), (Places{302, 304, 203, 403}));
  EXPECT_EQ(sources(2, 0), (Places{0, 4}));  // four apart
  EXPECT_EQ(sources(8, 6), (Places{408, 808}));
  EXPECT_EQ(sources(6, 2), (Places{6, 406}));
  EXPECT_EQ(sources(12, 8), (Places{808, 816}));  // eight apart
}

TEST(Attribution, AmongEqualPixelsTheFirstAreKept) {
  FullRender full{grey(5, {1, 2, 1, 2, 1}), std::vector<HitClass>(5, HitClass::miss)};
  FrameOutcome outcome;
  outcome.width = 5;
  outcome.height = 1;
  outcome.pixels = {sampled(1), interpolated(1, 1), sampled(1), interpolated(1, 1), sampled(1)};
  Attribution one(1), none(0);
  one.add(full, outcome);
  none.add(full, outcome);
  ASSERT_EQ(one.worst().size(), 1u);
  EXPECT_EQ(one.worst()[0].x, 1u);
  EXPECT_TRUE(none.worst().empty());
}

}  // namespace
}  // namespace artu::sim
