// The sweep over widths and trees, and what is written of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "sim/command/ranges.h"
#include "sim/precision/axis.h"
#include "sim/precision/plot.h"
#include "sim/precision/report.h"
#include "sim/precision/sweep.h"
#include "sim/report/heat.h"
#include "traces/error.h"
#include "traces/trace.h"

namespace artu::sim {
namespace {

using hw::TreeKind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

std::vector<std::string> names_of(const std::vector<hw::PrecisionConfig>& formats) {
  std::vector<std::string> names;
  for (const auto& format : formats) names.push_back(format_name(format));
  return names;
}

TEST(Formats, AreOfAllThreeDatapathsOrOfEach) {
  EXPECT_THAT(names_of(parse_formats("7-9,23")), ElementsAre("7", "8", "9", "23"));
  EXPECT_THAT(names_of(parse_formats("10/15")), ElementsAre("10/15/23"));
  EXPECT_THAT(names_of(parse_formats("10/15/7,8/8/8,12-12")), ElementsAre("10/15/7", "8", "12"));
}

TEST(Formats, WhatIsNoWidthIsRefused) {
  for (const char* text :
       {"", ",", "6", "24", "9-7", "7,", "x", "7/", "/7", "-7", "7-9-11", "7/8/9/10", "7-8/9", "+9"}) {
    EXPECT_THROW(parse_formats(text), InputError) << text;
  }
}

TEST(Trees, AreNamedAndOthersRefused) {
  EXPECT_THAT(parse_trees("kd,bvh4"), ElementsAre(TreeKind::kd, TreeKind::bvh4));
  for (const char* text : {"", "bvh", "kd,", "bvh2 bvh4", "KD"}) EXPECT_THROW(parse_trees(text), InputError) << text;
}

TEST(Sweep, HasEachTreeAndFormatOnceAnd23) {
  SweepPlan plan;
  plan.trees = {TreeKind::kd, TreeKind::bvh2, TreeKind::kd};
  plan.formats = parse_formats("9,8-9");
  plan = completed(plan);
  EXPECT_THAT(plan.trees, ElementsAre(TreeKind::kd, TreeKind::bvh2));
  EXPECT_THAT(names_of(plan.formats), ElementsAre("9", "8", "23"));
  plan.formats = parse_formats("23,7");
  EXPECT_THAT(names_of(completed(plan).formats), ElementsAre("23", "7"));
}

/// A sample trace with all trees, once for all tests.
class SweepTest : public ::testing::Test {
 protected:
  struct Sample {
    traces::Reader reader{std::string(ARTU_SOURCE_DIR) + "/traces/samples/glass_sphere.artu"};
    SweepPlan plan;
    std::vector<SweepRow> rows;
    std::vector<std::string> pictures;
    std::uint64_t steps = 0;

    Sample() {
      plan.trees = {TreeKind::bvh2, TreeKind::bvh4, TreeKind::bvh8, TreeKind::kd};
      plan.formats = parse_formats("8,12/23/9");
      plan = completed(plan);
      rows = run_sweep(reader.scene(), plan, hooks());
    }
    SweepHooks hooks() {
      SweepHooks hooks;
      hooks.frame = [this](std::uint32_t index) { return reader.frame(index); };
      hooks.picture = [this](const std::string& name, std::uint32_t, const Image&) { pictures.push_back(name); };
      hooks.progress = [this] { ++steps; };
      return hooks;
    }
  };
  static Sample& sample() {
    static Sample once;
    return once;
  }
  static const std::vector<SweepRow>& rows() { return sample().rows; }
};

TEST_F(SweepTest, RowsComeTreeByTree) {
  ASSERT_EQ(rows().size(), 12u);
  EXPECT_EQ(rows()[2].tree, TreeKind::bvh2);
  EXPECT_EQ(rows()[3].tree, TreeKind::bvh4);
  EXPECT_EQ(format_name(rows()[3].format), "8");
  EXPECT_EQ(format_name(rows()[4].format), "12/23/9");
  EXPECT_EQ(format_name(rows()[11].format), "23");
  EXPECT_EQ(sample().steps, sweep_steps(sample().plan));
  EXPECT_THAT(sample().pictures, ElementsAre("binary64", "M23", "M8", "M12/23/9")) << "of the first tree alone";
}

TEST_F(SweepTest, TwentyThreeBitsAreTheirOwnReference) {
  for (const SweepRow& row : rows()) {
    EXPECT_EQ(std::isinf(row.from_binary32.psnr()), is_binary32(row.format));
    EXPECT_EQ(row.from_binary32.differing() == 0, is_binary32(row.format));
    EXPECT_EQ(row.from_binary32.ssim() == 1, is_binary32(row.format));
    EXPECT_GT(row.run_time, 0);
  }
  EXPECT_EQ(rows()[2].run_time, 1);
}

TEST_F(SweepTest, TheErrorIsTheFormatsAndTheCostTheTrees) {
  for (std::size_t i = 3; i < rows().size(); ++i) {
    EXPECT_EQ(rows()[i].from_binary64.psnr(), rows()[i % 3].from_binary64.psnr());
    EXPECT_EQ(rows()[i].rays, rows()[i % 3].rays) << "shadow rays and all depend on the pixel alone";
    EXPECT_NE(rows()[i].cycles, rows()[i % 3].cycles);
    EXPECT_NE(rows()[i].node_visits, rows()[i % 3].node_visits);
  }
  EXPECT_LT(rows()[0].from_binary64.psnr(), rows()[2].from_binary64.psnr());
}

TEST_F(SweepTest, WithoutSelectiveRendering23BitsAreNearlyBinary64) {
  SweepPlan plan;
  plan.unit.selective.enabled = false;
  plan.trees = {TreeKind::bvh4};
  const auto without = run_sweep(sample().reader.scene(), completed(plan), sample().hooks());
  ASSERT_EQ(without.size(), 1u);
  EXPECT_LT(without[0].from_binary64.differing_share(), 0.001);
  EXPECT_EQ(without[0].traced_share, 1);
}

TEST_F(SweepTest, TreesThatShowDifferentPicturesAreAnInternalError) {
  SweepPlan plan;
  plan.trees = {TreeKind::bvh2, TreeKind::kd};
  SweepHooks hooks = sample().hooks();
  int asked = 0;
  hooks.frame = [&](std::uint32_t index) {
    traces::Frame frame = sample().reader.frame(index);
    if (++asked == 3) frame.sky_zenith.x += 0.5f;  // as if the second tree had lost something
    return frame;
  };
  try {
    run_sweep(sample().reader.scene(), completed(plan), hooks);
    FAIL() << "accepted";
  } catch (const std::logic_error& error) {
    EXPECT_STREQ(error.what(), "frame 0, M 23: kd shows another picture than bvh2");
  }
}

TEST_F(SweepTest, TheTableIsAlignedAndNarrow) {
  std::istringstream table(format_table(rows(), 1));
  std::size_t width = 0, lines = 0;
  for (std::string line; std::getline(table, line); ++lines) {
    EXPECT_LE(line.size(), 120u);
    if (lines < 3 || line.empty()) continue;
    if (width == 0) width = line.size();
    EXPECT_EQ(line.size(), width) << line;
  }
  EXPECT_EQ(lines, 3 + 12 + 3u) << "headings, rows, blank lines between trees";
  EXPECT_THAT(format_table(rows(), 1), HasSubstr("   same  1.00000   0.000"));
}

TEST_F(SweepTest, EveryLineOfTheCsvHasTheSameColumns) {
  std::istringstream csv(format_csv(rows()));
  std::string line;
  std::getline(csv, line);
  const auto columns = std::count(line.begin(), line.end(), ',');
  int lines = 0;
  for (; std::getline(csv, line); ++lines) EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns) << line;
  EXPECT_EQ(lines, 12);
  EXPECT_THAT(format_csv(rows()), HasSubstr("\nbvh4,12,23,9,"));
  EXPECT_THAT(format_csv(rows()), HasSubstr(",inf,1,0,0,"));
}

TEST_F(SweepTest, TheJsonSaysWhatWasRun) {
  Manifest manifest;
  manifest.input = "scene\xff.glb";  // no UTF-8
  manifest.width = 128;
  const auto json = nlohmann::json::parse(format_json(rows(), sample().plan, manifest));
  EXPECT_EQ(json.at("schema"), precision_schema);
  EXPECT_EQ(json.at("scene").at("width"), 128);
  ASSERT_EQ(json.at("rows").size(), 12u);
  EXPECT_EQ(json.at("rows")[1].at("shading_bits"), 9);
  EXPECT_TRUE(json.at("rows")[2].at("from_binary32").at("psnr").is_null());
  EXPECT_GT(json.at("rows")[2].at("from_binary64").at("psnr"), 20);
  EXPECT_EQ(json.at("configuration").at("core").at("count"), 6);
  EXPECT_EQ(json.at("configuration").at("core").at("node_cache").at("size"), 16384);
  EXPECT_EQ(json.at("configuration").at("selective").at("magnitude"), "proportional");
  EXPECT_FALSE(json.at("configuration").contains("precision")) << "the rows have it";
}

TEST_F(SweepTest, ThePlotHasABlockATreeAndPanelsWithSomethingIn) {
  const std::string script = plot_script(rows(), 1, "it's");
  EXPECT_THAT(script, HasSubstr("trees = 'bvh2 bvh4 bvh8 kd'"));
  EXPECT_THAT(script, HasSubstr("layout 1,2 title 'it''s"));
  EXPECT_THAT(plot_data(rows(), 1), HasSubstr("\n\n\n# kd\n"));
  EXPECT_THAT(plot_data(rows(), 1), HasSubstr(" nan ")) << "23 bits have no error against themselves";
  const std::vector<SweepRow> one{rows()[2]};
  EXPECT_THAT(plot_script(one, 1, ""), HasSubstr("layout 1,1"));
  EXPECT_THAT(plot_script(one, 1, ""), Not(HasSubstr("against M = 23")));
}

TEST(Axis, HoldsItsValues) {
  for (const std::vector<double>& values : {std::vector<double>{3}, {1, 2}, {1e-7, 1}, {20, 100}, {5, 5}}) {
    const PlotAxis axis(values);
    for (const double value : values) {
      EXPECT_GT(axis.position(value), 0);
      EXPECT_LT(axis.position(value), 1);
    }
  }
  EXPECT_THAT(PlotAxis({0.03, 0.3}).commands('x'), HasSubstr("set xtics (0.05, 0.1, 0.2)"));
  EXPECT_THAT(PlotAxis({1e-4, 1}).commands('x'), HasSubstr("set xtics (0.0001, 0.001, 0.01, 0.1, 1)"));
  EXPECT_THAT(PlotAxis({200, 300}).commands('y'), HasSubstr("unset logscale y"));
}

TEST(HeatMap, IsBlackWherePicturesAreEqual) {
  const Image a{4, 1, {10, 10, 10, 10, 10, 10, 10, 10, 10, 0, 0, 0}},
      b{4, 1, {10, 10, 10, 10, 11, 10, 10, 10, 26, 0, 255, 0}};
  const Image map = heat_map(a, b);
  EXPECT_EQ(map.rgb[0] + map.rgb[1] + map.rgb[2], 0);
  EXPECT_THAT(std::vector<int>(map.rgb.begin() + 3, map.rgb.begin() + 6), ElementsAre(40, 40, 160));
  EXPECT_THAT(std::vector<int>(map.rgb.begin() + 6, map.rgb.begin() + 9), ElementsAre(225, 50, 50)) << "16, half way";
  EXPECT_THAT(std::vector<int>(map.rgb.begin() + 9, map.rgb.end()), ElementsAre(255, 255, 255));
}

TEST(ImageError, TakesAllFramesTogether) {
  const Image black{1, 1, {0, 0, 0}}, grey{1, 1, {30, 30, 30}};
  ImageError error;
  error.add(compare_images(black, black));
  EXPECT_TRUE(std::isinf(error.psnr()));
  error.add(compare_images(black, grey));
  EXPECT_NEAR(error.psnr(), 10 * std::log10(255.0 * 255 / 450), 1e-9);  // half of the pixels, 900 each
  EXPECT_EQ(error.differing_share(), 0.5);
  EXPECT_EQ(error.largest(), 30u);
  EXPECT_TRUE(std::isnan(error.ssim())) << "too small for a window";
}

TEST(PictureNames, AreInTheOrderOfTheWidths) {
  EXPECT_EQ(file_name("M7"), "M07");
  EXPECT_EQ(file_name("M12/23/9"), "M12-23-9");
  EXPECT_EQ(file_name("binary64"), "binary64");
}

}  // namespace
}  // namespace artu::sim
