// Comparison: each field that differs is named, and nothing else.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "hw/selective/policy.h"
#include "ref/policy.h"
#include "sim/compare/frame_compare.h"
#include "sim/compare/golden_settings.h"
#include "sim/compare/image_metrics.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

using ::testing::HasSubstr;

ref::Pixel golden_pixel() {
  ref::Pixel pixel;
  pixel.pass = 1;
  pixel.hit_class = ref::HitClass::dynamic_geometry;
  pixel.n_static = 2;
  pixel.n_dynamic = 3;
  pixel.threshold = 14;
  pixel.difference = 40;
  pixel.decision = ref::Decision::traced;
  pixel.r = 10, pixel.g = 20, pixel.b = 30;
  pixel.primitive = 5000000000;
  pixel.t_bits = 0x3f800000;
  return pixel;
}

hw::PixelRecord unit_pixel() {
  hw::PixelRecord pixel;
  pixel.pass = 1;
  pixel.hit_class = hw::HitClass::dynamic_geometry;
  pixel.n_static = 2;
  pixel.n_dynamic = 3;
  pixel.threshold = 14;
  pixel.difference = 40;
  pixel.decision = hw::Decision::traced;
  pixel.r = 10, pixel.g = 20, pixel.b = 30;
  pixel.written = 1;
  pixel.primitive = 5000000000;
  pixel.t_bits = 0x3f800000;
  return pixel;
}

struct Fault {
  PixelField field;
  std::function<void(hw::PixelRecord&)> inject;
};

std::vector<Fault> faults() {
  return {
      {PixelField::color, [](auto& p) { p.r ^= 1; }},
      {PixelField::color, [](auto& p) { p.g ^= 128; }},
      {PixelField::color, [](auto& p) { p.b ^= 1; }},
      {PixelField::hit_class, [](auto& p) { p.hit_class = hw::HitClass::static_geometry; }},
      {PixelField::n_static, [](auto& p) { ++p.n_static; }},
      {PixelField::n_dynamic, [](auto& p) { --p.n_dynamic; }},
      {PixelField::threshold, [](auto& p) { p.threshold = -1; }},
      {PixelField::difference, [](auto& p) { ++p.difference; }},
      {PixelField::decision, [](auto& p) { p.decision = hw::Decision::interpolated; }},
      {PixelField::pass, [](auto& p) { p.pass = 2; }},
      {PixelField::t_bits, [](auto& p) { p.t_bits ^= 1; }},
      {PixelField::primitive, [](auto& p) { p.primitive -= std::int64_t{1} << 32; }},
      {PixelField::written, [](auto& p) { p.written = 0; }},
      {PixelField::written, [](auto& p) { p.written = 2; }},
  };
}

FrameOutcome outcome_of(std::vector<hw::PixelRecord> pixels, std::uint32_t width) {
  FrameOutcome outcome;
  outcome.index = 7;
  outcome.width = width;
  outcome.height = static_cast<std::uint32_t>(pixels.size() / width);
  outcome.pixels = std::move(pixels);
  return outcome;
}

ref::Result golden_of(std::size_t pixels, std::uint32_t width) {
  ref::Result result;
  result.width = width;
  result.height = static_cast<std::uint32_t>(pixels / width);
  result.pixels.assign(pixels, golden_pixel());
  return result;
}

TEST(PixelCompare, EqualRecordsDifferInNothing) { EXPECT_TRUE(differing_fields(golden_pixel(), unit_pixel()).none()); }

TEST(PixelCompare, EachFlippedFieldIsNamedAndNoOther) {
  for (const Fault& fault : faults()) {
    hw::PixelRecord unit = unit_pixel();
    fault.inject(unit);
    PixelFields expected;
    expected.set(static_cast<std::size_t>(fault.field));
    EXPECT_EQ(differing_fields(golden_pixel(), unit), expected) << field_name(fault.field);
    EXPECT_NE(field_text(fault.field, unit), field_text(fault.field, golden_pixel()));
    const std::string table = comparison_table(golden_pixel(), unit);
    EXPECT_THAT(table, HasSubstr(std::string("* ") + field_name(fault.field) + " "));
    EXPECT_EQ(table.find('*'), table.rfind('*')) << table;
  }
}

TEST(PixelCompare, TheTableHoldsAllFieldsOfBothSides) {
  hw::PixelRecord unit = unit_pixel();
  unit.primitive = 17;
  const std::string table = comparison_table(golden_pixel(), unit);
  for (std::size_t f = 0; f < pixel_field_count; ++f) {
    EXPECT_THAT(table, HasSubstr(field_name(static_cast<PixelField>(f))));
  }
  EXPECT_THAT(table, HasSubstr("1065353216 (0x3f800000 = 1)"));
  EXPECT_THAT(table, HasSubstr("17 "));
  EXPECT_THAT(table, HasSubstr("5000000000"));
}

TEST(FrameCompare, FindsTheFirstMismatchAndCountsAllByField) {
  std::vector<hw::PixelRecord> pixels(12, unit_pixel());
  pixels[6].g = 0;
  pixels[6].pass = 2;
  pixels[11].g = 0;
  CheckResult result;
  compare_frame(golden_of(12, 4), outcome_of(pixels, 4), result);
  EXPECT_FALSE(result.passed());
  EXPECT_EQ(result.pixels, 12u);
  EXPECT_EQ(result.differing_pixels, 2u);
  EXPECT_EQ(result.differing_fields[static_cast<std::size_t>(PixelField::color)], 2u);
  EXPECT_EQ(result.differing_fields[static_cast<std::size_t>(PixelField::pass)], 1u);
  ASSERT_TRUE(result.first);
  EXPECT_EQ(result.first->frame, 7u);
  EXPECT_EQ(result.first->x, 2u);
  EXPECT_EQ(result.first->y, 1u);
  const std::string text = describe(result);
  EXPECT_THAT(text, HasSubstr("frame 7, x 2, y 1"));
  EXPECT_THAT(text, HasSubstr("2 of 12 pixels differ (colour in 2, pass in 1)"));
}

TEST(FrameCompare, TheFirstMismatchIsThatOfTheEarliestPass) {
  // A fault of an early pass changes the decisions of later ones, and their pixels may lie above it.
  std::vector<hw::PixelRecord> pixels(4, unit_pixel());
  pixels[1].r = 0;
  pixels[3].r = 0;
  ref::Result golden = golden_of(4, 2);
  golden.pixels[3].pass = 0;
  golden.pixels[1].pass = 2;
  CheckResult result;
  compare_frame(golden, outcome_of(pixels, 2), result);
  ASSERT_TRUE(result.first);
  EXPECT_EQ(result.first->x, 1u);
  EXPECT_EQ(result.first->y, 1u);
}

TEST(FrameCompare, TheFirstOfSeveralFramesStaysTheFirst) {
  std::vector<hw::PixelRecord> pixels(4, unit_pixel());
  pixels[3].r = 0;
  CheckResult result;
  compare_frame(golden_of(4, 2), outcome_of(pixels, 2), result);
  pixels[0].r = 0;
  compare_frame(golden_of(4, 2), outcome_of(pixels, 2), result);
  EXPECT_EQ(result.first->x, 1u);
  EXPECT_EQ(result.pixels, 8u);
  EXPECT_EQ(result.differing_pixels, 3u);
}

TEST(FrameCompare, RayCountsAreComparedByKind) {
  std::uint64_t FrameOutcome::*kinds[] = {&FrameOutcome::rays_primary, &FrameOutcome::rays_shadow,
                                          &FrameOutcome::rays_reflection, &FrameOutcome::rays_refraction};
  const char* names[] = {"primary", "shadow", "reflection", "refraction"};
  for (int kind = 0; kind < 4; ++kind) {
    FrameOutcome outcome = outcome_of({unit_pixel()}, 1);
    outcome.*kinds[kind] = 9;
    CheckResult result;
    compare_frame(golden_of(1, 1), outcome, result);
    EXPECT_FALSE(result.passed());
    EXPECT_EQ(result.differing_pixels, 0u);
    EXPECT_THAT(describe(result), HasSubstr(std::string("frame 7: ") + names[kind] + " rays: unit 9, golden 0"));
  }
}

TEST(FrameCompare, AFineResultIsOneLine) {
  CheckResult result;
  compare_frame(golden_of(4, 2), outcome_of(std::vector<hw::PixelRecord>(4, unit_pixel()), 2), result);
  EXPECT_TRUE(result.passed());
  const std::string text = describe(result);
  EXPECT_THAT(text, HasSubstr("4 pixels compared with the golden model, 0 differing"));
  EXPECT_EQ(text.find('\n'), text.size() - 1);
}

TEST(FrameCompare, PicturesOfDifferentSizesAreAnInternalError) {
  CheckResult result;
  const FrameOutcome outcome = outcome_of(std::vector<hw::PixelRecord>(4, unit_pixel()), 2);
  EXPECT_THROW(compare_frame(golden_of(4, 4), outcome, result), std::logic_error);
}

TEST(GoldenSettings, MapsEveryField) {
  hw::UnitConfig unit;
  unit.selective.enabled = false;
  unit.selective.adaptive = false;
  unit.selective.stride = 8;
  unit.selective.passes = hw::Passes::average;
  unit.selective.count = hw::Count::merged;
  unit.selective.compare = hw::Compare::reference_count;
  unit.selective.reference_count = 6;
  unit.selective.metric = hw::Metric::luma;
  unit.selective.policy = 1;
  unit.selective.policy_registers = {9, 8, 7, 6};
  unit.selective.magnitude = hw::Magnitude::progressive;
  unit.selective.reference = 31;
  unit.selective.minimum = 3;
  unit.selective.maximum = 99;
  unit.selective.step = 7;
  unit.selective.table = {8, 7, 6, 5, 4, 3, 2, 1};
  unit.shading.max_depth = 9;
  unit.shading.min_weight = 0.5f;
  const ref::Settings settings = golden_settings(unit);
  EXPECT_FALSE(settings.selective);
  EXPECT_FALSE(settings.adaptive);
  EXPECT_EQ(settings.stride, 8);
  EXPECT_EQ(settings.passes, ref::Passes::average);
  EXPECT_EQ(settings.count, ref::Count::merged);
  EXPECT_EQ(settings.compare, ref::Compare::reference_count);
  EXPECT_EQ(settings.reference_count, 6);
  EXPECT_EQ(settings.metric, ref::Metric::luma);
  EXPECT_EQ(settings.policy, hw::policy_names()[1]);
  EXPECT_THAT(settings.policy_registers, ::testing::ElementsAre(9, 8, 7, 6));
  EXPECT_EQ(settings.magnitude, ref::Magnitude::progressive);
  EXPECT_EQ(settings.reference, 31);
  EXPECT_EQ(settings.minimum, 3);
  EXPECT_EQ(settings.maximum, 99);
  EXPECT_EQ(settings.step, 7);
  EXPECT_THAT(settings.table, ::testing::ElementsAre(8, 7, 6, 5, 4, 3, 2, 1));
  EXPECT_EQ(settings.max_depth, 9u);
  EXPECT_EQ(settings.min_weight, 0.5f);
}

TEST(GoldenSettings, TheDefaultsOfTheTwoRoomsAgree) {
  const ref::Settings mapped = golden_settings(hw::UnitConfig()), own;
  EXPECT_EQ(mapped.selective, own.selective);
  EXPECT_EQ(mapped.adaptive, own.adaptive);
  EXPECT_EQ(mapped.stride, own.stride);
  EXPECT_EQ(mapped.passes, own.passes);
  EXPECT_EQ(mapped.count, own.count);
  EXPECT_EQ(mapped.compare, own.compare);
  EXPECT_EQ(mapped.reference_count, own.reference_count);
  EXPECT_EQ(mapped.metric, own.metric);
  EXPECT_EQ(mapped.policy, own.policy);
  EXPECT_EQ(mapped.policy_registers, own.policy_registers);
  EXPECT_EQ(mapped.magnitude, own.magnitude);
  EXPECT_EQ(mapped.reference, own.reference);
  EXPECT_EQ(mapped.minimum, own.minimum);
  EXPECT_EQ(mapped.maximum, own.maximum);
  EXPECT_EQ(mapped.step, own.step);
  EXPECT_EQ(mapped.table, own.table);
  EXPECT_EQ(mapped.max_depth, own.max_depth);
  EXPECT_EQ(mapped.min_weight, own.min_weight);
}

TEST(GoldenSettings, EveryPolicyHasATwin) {
  const std::vector<const char*>& unit = hw::policy_names();
  const std::vector<std::string> names(unit.begin(), unit.end());
  EXPECT_THAT(ref::policy_names(), ::testing::UnorderedElementsAreArray(names));
  for (const std::string& name : names) EXPECT_EQ(twin_of(name), name);
}

TEST(GoldenSettings, APolicyWithoutATwinIsRefused) {
  try {
    twin_of("no_such_policy");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("selective.policy: the golden model has no \"no_such_policy\""));
    EXPECT_THAT(error.what(), HasSubstr("ref/policies/no_such_policy.cpp"));
    EXPECT_THAT(error.what(), HasSubstr("attention"));
  }
}

template <class Channel>
Image image_of(std::uint32_t width, std::uint32_t height, Channel channel) {
  Image image;
  image.width = width;
  image.height = height;
  for (int y = 0; y < int(height); ++y) {
    for (int x = 0; x < int(width); ++x) {
      for (int c = 0; c < 3; ++c) image.rgb.push_back(static_cast<std::uint8_t>(channel(x, y, c)));
    }
  }
  return image;
}

// The expected values are scikit-image's: peak_signal_noise_ratio and structural_similarity with
// gaussian_weights=True, sigma=1.5, use_sample_covariance=False, channel_axis=2, data_range=255.
TEST(ImageMetrics, AgreesWithScikitImage) {
  const auto wave = [](int x, int y, int c) { return (x * 7 + y * 13 + c * 50) % 256; };
  const Image a = image_of(32, 24, wave);
  const Image b = image_of(32, 24, [&](int x, int y, int c) { return std::min(255, wave(x, y, c) + x * y % 17); });
  const ImageDifference d = compare_images(a, b);
  EXPECT_NEAR(d.psnr, 29.276877259944808, 1e-9);
  EXPECT_NEAR(d.ssim, 0.9818378326518281, 1e-9);
  EXPECT_EQ(d.largest, 16u);
}

TEST(ImageMetrics, AgreesWithScikitImageWhereOneColumnOfWindowsFits) {
  const Image a = image_of(13, 11, [](int x, int y, int c) { return c == 0 ? 10 * x : c == 1 ? 20 * y : 128; });
  const Image b = image_of(13, 11, [](int x, int y, int c) { return c == 0 ? 10 * x + y : c == 1 ? 20 * y : 128 - x; });
  const ImageDifference d = compare_images(a, b);
  EXPECT_NEAR(d.psnr, 33.6078268987328, 1e-9);
  EXPECT_NEAR(d.ssim, 0.9847326904136908, 1e-9);
  EXPECT_EQ(d.largest, 12u);
  EXPECT_EQ(d.differing, 13u * 11u - 1);  // all but (0, 0)
}

TEST(ImageMetrics, EqualPicturesAndTinyOnes) {
  const Image a = image_of(20, 20, [](int x, int y, int c) { return x + y + c; });
  const ImageDifference same = compare_images(a, a);
  EXPECT_TRUE(std::isinf(same.psnr));
  EXPECT_DOUBLE_EQ(same.ssim, 1);
  EXPECT_EQ(same.differing, 0u);
  const Image tiny = image_of(10, 30, [](int, int, int) { return 1; });
  EXPECT_TRUE(std::isnan(compare_images(tiny, tiny).ssim));
}

}  // namespace
}  // namespace artu::sim
