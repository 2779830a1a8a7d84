// `artu quality`: baselines, policies at equal work, and its tables.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/quality/baselines.h"
#include "sim/quality/front.h"
#include "sim/quality/policies.h"
#include "sim/quality/report.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

using ::testing::HasSubstr;

Image grey(std::uint32_t width, const std::vector<std::uint8_t>& codes) {
  Image image{width, static_cast<std::uint32_t>(codes.size() / width), {}};
  for (const std::uint8_t code : codes) image.rgb.insert(image.rgb.end(), {code, code, code});
  return image;
}

std::vector<int> greys_of(const Image& image) {
  std::vector<int> codes;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) codes.push_back(image.rgb[i]);
  return codes;
}

TEST(Baselines, TheCheckerboardKeepsEveryOtherPixel) {
  EXPECT_EQ(greys_of(checkerboard(grey(3, {10, 0, 20, 0, 41, 0, 30, 0, 40}))),
            (std::vector<int>{10, 24, 20, 27, 41, 34, 30, 37, 40}));
  EXPECT_EQ(greys_of(checkerboard(grey(1, {7}))), (std::vector<int>{7}));
  EXPECT_EQ(checkerboard_pixels(3, 3), 5u);
}

TEST(Baselines, LowResolutionKeepsTheSamplingPixels) {
  EXPECT_EQ(greys_of(low_resolution(grey(4, {0, 9, 10, 9, 9, 9, 9, 9, 20, 9, 31, 9, 9, 9, 9, 9}))),
            (std::vector<int>{0, 5, 10, 10, 10, 15, 21, 21, 20, 26, 31, 31, 20, 26, 31, 31}));
  EXPECT_EQ(low_resolution_pixels(5, 4), 6u);
}

QualityRow point(const char* policy, std::uint32_t reference, std::uint64_t traced, std::uint64_t squares) {
  QualityRow row;
  row.policy = policy;
  row.reference = reference;
  row.pixels = 100;
  row.traced = traced;
  row.cycles = 1000;
  row.dram_bytes = 64;
  row.picojoules = 5e6;
  row.errors.areas[0] = {100, squares, 0, 0, 1};
  row.errors.areas[1] = {50, squares, 0, 0, 1};
  return row;
}

TEST(Front, IsLinearBetweenTheNearestPointsAndSilentBeyond) {
  // PSNR of 100 pixels with 300 * 65025 / 10^k squares is 10 k dB.
  const std::vector<QualityRow> rows = {point("fixed", 0, 80, 195075), point("fixed", 8, 40, 19507500),
                                        point("other", 8, 60, 1950750), point("other", 9, 90, 0)};
  EXPECT_NEAR(front_at(rows, "fixed", 0.4).psnr[0], 0, 1e-9);
  EXPECT_NEAR(front_at(rows, "fixed", 0.5).psnr[0], 5, 1e-9);
  EXPECT_NEAR(front_at(rows, "fixed", 0.8).psnr[0], 20, 1e-9);
  EXPECT_TRUE(std::isnan(front_at(rows, "fixed", 0.39).psnr[0]));
  EXPECT_TRUE(std::isnan(front_at(rows, "fixed", 0.81).psnr[0]));
  EXPECT_TRUE(std::isnan(front_at(rows, "fixed", 0.5).psnr[2]));  // no pixel
  EXPECT_NEAR(front_at(rows, "other", 0.6).psnr[0], 10, 1e-9);
  EXPECT_TRUE(std::isnan(front_at(rows, "other", 0.7).psnr[0]));  // towards a picture without error
  EXPECT_TRUE(std::isnan(front_at(rows, "none", 0.5).psnr[0]));

  const std::string table = format_equal_shares(rows, {0.6});
  EXPECT_THAT(table, HasSubstr("60                other    10.00   +0.00"));
  EXPECT_THAT(table, HasSubstr("-"));
}

TEST(Quality, WhatWasNotSimulatedIsADash) {
  QualityRow computed = point("checkerboard", 0, 50, 0);
  computed.reference.reset();
  computed.cycles.reset();
  computed.dram_bytes.reset();
  computed.picojoules.reset();
  const std::string table = format_quality({computed}, 1);
  EXPECT_THAT(table, ::testing::ContainsRegex("checkerboard +50.00 +0.0 +- +- +- +same +same +- +- +-"));
  EXPECT_THAT(quality_csv({computed}), HasSubstr("checkerboard,,0.5,0,,,,100,0,inf,nan,0.01"));
}

TEST(Policies, AreNamedBetweenCommas) {
  EXPECT_EQ(all_policies()[0].name, plain_policy);
  ASSERT_EQ(parse_policies("attention,fixed,attention").size(), 2u);
  EXPECT_EQ(parse_policies("attention,fixed")[1].name, "fixed");
  EXPECT_THROW(parse_policies("fixed,"), InputError);
  EXPECT_THROW(parse_policies("best"), InputError);
}

}  // namespace
}  // namespace artu::sim
