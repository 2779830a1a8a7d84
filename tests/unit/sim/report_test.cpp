// Reports: the numbers, JSON, text, CSV and pictures that a run leaves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "sim/report/cycle_table.h"
#include "sim/report/digest.h"
#include "sim/report/file.h"
#include "sim/report/image.h"
#include "sim/report/manifest.h"
#include "sim/report/numbers.h"
#include "sim/report/pictures.h"
#include "sim/report/pixel_csv.h"
#include "sim/report/run_folder.h"
#include "sim/report/stats_json.h"
#include "sim/report/stats_text.h"
#include "sim/report/summary.h"
#include "traces/error.h"
#include "unit/sim/temp_folder.h"

namespace artu::sim {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class ReportTest : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return temporary_.path(name); }

  const test::TempFolder temporary_;
  const fs::path folder_ = temporary_.path();
};

/// Two by two: sampled static, interpolated, traced dynamic, traced miss.
FrameOutcome outcome() {
  FrameOutcome o;
  o.index = 3;
  o.width = o.height = 2;
  o.cycles = 1000;
  o.static_triangles = 10;
  o.dynamic_triangles = 4;
  o.rays_primary = 3;
  o.rays_shadow = 2;
  o.rays_reflection = 1;
  o.node_visits = 60;
  o.triangle_tests = 12;
  o.dram_read_bytes = 640;
  o.dram_write_bytes = 64;
  o.simulation_seconds = 0.5;
  o.pixels.resize(4);
  o.pixels[0] = {0, hw::HitClass::static_geometry, 0, 0, -1, -1, hw::Decision::sampled, 1, 2, 3, 1, 9, 1065353216};
  o.pixels[1] = {1, hw::HitClass::none, 1, 0, 18, 5, hw::Decision::interpolated, 4, 5, 6, 1, -1, 0};
  o.pixels[2] = {2, hw::HitClass::dynamic_geometry, 0, 2, 12, 13, hw::Decision::traced, 7, 8, 9, 1, 11, 7};
  o.pixels[3] = {2, hw::HitClass::miss, 0, 0, 16, -1, hw::Decision::traced, 255, 0, 1, 1, -1, 0};
  for (const char* block : {"core0.traversal", "core1.traversal", "l2"}) {
    o.statistics.push_back({block, "busy", 600, "cycles", "worked"});
    o.statistics.push_back({block, "stall_mem", 400, "cycles", "waited for memory"});
    o.statistics.push_back({block, "peak_queue", 5, "", "largest occupancy"});
  }
  o.statistics.push_back({"l2", "hits", 30, "", "found"});
  o.statistics.push_back({"l2", "misses", 10, "", "not found"});
  o.statistics.push_back({"core0.intersection", "hits", 3, "", "tests that were hits"});  // no cache
  return o;
}

double number(const std::vector<Number>& numbers, const std::string& name) {
  for (const Number& n : numbers) {
    if (n.name == name) return std::visit([](auto v) { return static_cast<double>(v); }, n.value);
  }
  ADD_FAILURE() << "no " << name;
  return -1;
}

TEST(Numbers, AreCountedFromTheOutcome) {
  const auto numbers = frame_numbers(totals_of(outcome()));
  EXPECT_EQ(number(numbers, "cycles"), 1000);
  EXPECT_EQ(number(numbers, "rays.primary"), 3);
  EXPECT_EQ(number(numbers, "rays.reflection"), 1);
  EXPECT_EQ(number(numbers, "candidates.interpolated"), 1);
  EXPECT_EQ(number(numbers, "candidates.traced"), 2);
  EXPECT_EQ(number(numbers, "pixels.sampled"), 1);
  EXPECT_EQ(number(numbers, "pixels.static"), 1);
  EXPECT_EQ(number(numbers, "pixels.dynamic"), 1);
  EXPECT_EQ(number(numbers, "pixels.miss"), 1);
  EXPECT_EQ(number(numbers, "traced_share"), 0.75);
}

TEST(Totals, OfTreesTheLargestSizesAndTheCostliestsTestsAreKept) {
  Totals sum, small, large;
  small.dynamic_tree = {3, 4, 2, 9, 10, 1};
  large.dynamic_tree = {5, 6, 3, 8, 2, 6};  // 14 box tests' worth, against 12
  for (const Totals* frame : {&small, &large, &small}) add(sum, *frame);
  EXPECT_EQ(number(frame_numbers(sum), "tree.nodes"), 5);
  EXPECT_EQ(number(frame_numbers(sum), "tree.leaves"), 6);
  EXPECT_EQ(number(frame_numbers(sum), "tree.depth"), 3);
  EXPECT_EQ(number(frame_numbers(sum), "tree.references"), 9);
  EXPECT_EQ(number(frame_numbers(sum), "tree.box_tests"), 2);
  EXPECT_EQ(number(frame_numbers(sum), "tree.triangle_tests"), 6);
  EXPECT_EQ(number(frame_numbers(sum), "tree.sah_cost"), 14);
}

TEST(Numbers, AddUpOverFramesAndPeaksStayPeaks) {
  Totals sum;
  add(sum, totals_of(outcome()));
  FrameOutcome second = outcome();
  second.statistics[2].value = 9;                              // core0.traversal.peak_queue
  second.statistics.push_back({"new", "counter", 1, "", ""});  // counters that only some frames have
  add(sum, totals_of(second));
  EXPECT_EQ(sum.frames, 2u);
  EXPECT_EQ(sum.cycles, 2000u);
  EXPECT_EQ(sum.static_triangles, 10u);
  EXPECT_EQ(sum.statistics[0].value, 1200u);
  EXPECT_EQ(sum.statistics[2].value, 9u);
  EXPECT_EQ(sum.statistics.back().block, "new");
}

TEST(Numbers, APeakIsKnownByItsName) {
  for (const char* name : {"peak_queue", "max_depth", "queue_peak", "depth_max"}) EXPECT_TRUE(is_peak(name)) << name;
  for (const char* name : {"speak_queue", "maximum", "peaks", "max", "misses"}) EXPECT_FALSE(is_peak(name)) << name;
}

TEST(Numbers, RatesAreAtTheConfiguredClock) {
  const auto derived = derived_numbers(totals_of(outcome()), 500);
  EXPECT_DOUBLE_EQ(number(derived, "fps"), 500e6 / 1000);
  EXPECT_DOUBLE_EQ(number(derived, "mrays_per_second"), 6 / (1000 / 500e6) / 1e6);
  EXPECT_DOUBLE_EQ(number(derived, "dram_gb_per_second"), 704 / (1000 / 500e6) / 1e9);
  EXPECT_DOUBLE_EQ(number(derived, "hit_rate.l2"), 0.75);
  for (const Number& n : derived) EXPECT_NE(n.name, "hit_rate.intersection");
  EXPECT_DOUBLE_EQ(number(derived, "node_visits_per_ray"), 10);
}

TEST(Numbers, NothingIsDividedByZero) {
  for (const Number& n : derived_numbers(Totals(), 500)) EXPECT_EQ(std::get<double>(n.value), 0) << n.name;
  for (const Number& n : simulation_numbers(Totals(), -1)) EXPECT_EQ(value_text(n), "0") << n.name;
}

TEST(CycleTable, CoresAreAveragedAndSharesAddUpToAHundred) {
  const auto shares = cycle_shares(outcome().statistics);
  ASSERT_EQ(shares.size(), 2u);
  EXPECT_EQ(shares[0].block, "core.traversal");
  EXPECT_DOUBLE_EQ(shares[0].percent[0], 60);
  EXPECT_DOUBLE_EQ(shares[0].percent[3], 40);
  EXPECT_THAT(format_cycle_table(outcome().statistics), HasSubstr("60.0%"));
  EXPECT_EQ(without_number("core12.shading"), "core.shading");
  EXPECT_EQ(without_number("corelation"), "corelation");
  EXPECT_EQ(without_number("core1x"), "core1x");
  EXPECT_EQ(without_number("l2"), "l2");
  EXPECT_EQ(without_number("l2_bank3"), "l2");
  EXPECT_EQ(without_number("l2_to_dram"), "l2_to_dram");
}

TEST_F(ReportTest, StatsJsonHasTheKeysOfItsSchema) {
  const Totals totals = totals_of(outcome());
  Totals sum;
  add(sum, totals);
  add(sum, totals);
  StatsJson writer(path("stats.json"));
  writer.add_frame(3, totals, {});
  writer.add_frame(4, totals, {"l2: a law"});
  writer.finish(sum, 500, nullptr);
  const auto json = nlohmann::json::parse(read_file(path("stats.json")));
  EXPECT_EQ(json.at("schema"), 1);
  ASSERT_EQ(json.at("frames").size(), 2u);
  const auto& frame = json.at("frames").at(0);
  EXPECT_EQ(frame.at("index"), 3);
  EXPECT_EQ(frame.at("cycles"), 1000);
  EXPECT_EQ(frame.at("rays").at("shadow"), 2);
  EXPECT_EQ(frame.at("candidates").at("interpolated"), 1);
  EXPECT_EQ(frame.at("pixels").at("dynamic"), 1);
  EXPECT_EQ(frame.at("blocks").at("core0.traversal").at("stall_mem"), 400);
  EXPECT_EQ(frame.at("blocks").at("l2").at("hits"), 30);
  EXPECT_EQ(frame.at("dram").at("read_bytes"), 640);
  EXPECT_EQ(frame.at("traced_share"), 0.75);
  EXPECT_TRUE(frame.at("violations").empty());
  EXPECT_EQ(json.at("frames").at(1).at("violations").at(0), "l2: a law");
  EXPECT_EQ(json.at("totals").at("frames"), 2);
  EXPECT_EQ(json.at("totals").at("cycles"), 2000);
  EXPECT_EQ(json.at("derived").at("fps"), 500e3);
  EXPECT_TRUE(json.at("derived").contains("mrays_per_second"));
  EXPECT_TRUE(json.at("check").is_null());
  for (const char* name : {"wall_seconds", "rays_per_second", "node_visits_per_second", "cycles_per_second",
                           "peak_bytes", "bytes_per_triangle", "bytes_per_pixel"}) {
    EXPECT_TRUE(json.at("simulation").contains(name)) << name;
  }
  EXPECT_FALSE(json.at("simulation").contains("golden_seconds"));
}

TEST_F(ReportTest, StatsJsonHoldsTheMismatch) {
  ref::Result golden;
  golden.width = golden.height = 2;
  golden.pixels.resize(4);
  golden.rays.primary = 8;
  golden.trace_seconds = 0.25;
  CheckResult check;
  compare_frame(golden, outcome(), check);
  StatsJson writer(path("stats.json"));
  writer.add_frame(3, totals_of(outcome()), {});
  writer.finish(totals_of(outcome()), 500, &check);
  const auto json = nlohmann::json::parse(read_file(path("stats.json")));
  EXPECT_EQ(json.at("check").at("passed"), false);
  EXPECT_EQ(json.at("check").at("pixels"), 4);
  EXPECT_EQ(json.at("check").at("differing").at("colour"), 4);
  EXPECT_EQ(json.at("check").at("first").at("x"), 0);
  EXPECT_EQ(json.at("check").at("first").at("fields").at("primitive").at("unit"), "9");
  EXPECT_EQ(json.at("check").at("rays").at(0).at("golden"), 8);
  EXPECT_EQ(json.at("simulation").at("golden_seconds"), 0.25);
}

TEST(StatsText, HasSummaryTableAndEveryNumber) {
  const std::string text = format_stats(totals_of(outcome()), 500, 1.5);
  EXPECT_THAT(text, StartsWith("# 1 frame at 500 MHz: 1000 cycles per frame"));
  EXPECT_THAT(text, HasSubstr("core.traversal      60.0%"));
  EXPECT_THAT(text, ::testing::ContainsRegex("core1.traversal.stall_mem +400 +cycles +# waited for memory\n"));
  EXPECT_THAT(text, ::testing::ContainsRegex("simulation.golden_seconds +1.5 +s "));
}

TEST(StatsText, WallTimesDoNotMoveTheColumns) {
  Totals fast = totals_of(outcome()), slow = fast;
  fast.simulation_seconds = 1.23456789e-7;
  slow.simulation_seconds = 10;
  const std::string a = format_stats(fast, 500, -1), b = format_stats(slow, 500, -1);
  EXPECT_EQ(a.substr(0, a.find("simulation.")), b.substr(0, b.find("simulation.")));
}

TEST(StatsText, TheListNamesEveryCounterOnce) {
  const std::string text = format_stats_list(totals_of(outcome()), 500);
  EXPECT_THAT(text, ::testing::ContainsRegex("core0.traversal.busy +cycles +worked\n"));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("core1.")));
  EXPECT_THAT(text, HasSubstr("derived.fps"));
}

TEST(Summary, IsShortAndHoldsTheAnswer) {
  const std::string text = format_summary({"box.glb", 640, 360, 0, 8, 500}, totals_of(outcome()));
  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 10);
  EXPECT_THAT(text, HasSubstr("box.glb, 640x360"));
  EXPECT_THAT(text, HasSubstr("10 static, 4 dynamic"));
  EXPECT_THAT(text, HasSubstr("1,000 per frame"));
  EXPECT_THAT(text, HasSubstr("75.0 % of the pixels"));
}

TEST(PixelCsv, HasTheColumnsOfTheDocumentation) {
  std::string text = pixel_csv_header;
  pixel_csv_rows(outcome(), [&](const std::string& rows) { text += rows; });
  EXPECT_EQ(text,
            "frame,x,y,pass,class,n_static,n_dynamic,threshold,difference,decision,r,g,b,primitive,t_bits\n"
            "3,0,0,0,static,0,0,-1,-1,sampled,1,2,3,9,1065353216\n"
            "3,1,0,1,none,1,0,18,5,interpolated,4,5,6,-1,0\n"
            "3,0,1,2,dynamic,0,2,12,13,traced,7,8,9,11,7\n"
            "3,1,1,2,miss,0,0,16,-1,traced,255,0,1,-1,0\n");
}

TEST_F(ReportTest, APngReadsBackToTheSame) {
  const Image written = frame_picture(outcome());
  EXPECT_THAT(written.rgb, ::testing::ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 255, 0, 1));
  write_png(path("a.png"), written);
  const Image read = read_png(path("a.png"));
  EXPECT_EQ(read.width, 2u);
  EXPECT_EQ(read.height, 2u);
  EXPECT_EQ(read.rgb, written.rgb);
}

TEST_F(ReportTest, WhatIsNoPngIsRefused) {
  write_file(path("a.png"), "no picture");
  EXPECT_THROW(read_png(path("a.png")), InputError);
  EXPECT_THROW(read_png(path("none.png")), InputError);
  EXPECT_THROW(read_png(path("")), InputError);
  write_png(path("whole.png"), class_picture(outcome()));
  const std::string bytes = read_file(path("whole.png"));
  write_file(path("cut.png"), bytes.substr(0, bytes.size() / 2));
  EXPECT_THROW(read_png(path("cut.png")), InputError);
}

TEST(Pictures, EveryKindOfPixelHasItsOwnColour) {
  std::set<std::array<int, 3>> colors;
  const auto insert = [&](Color c) { EXPECT_TRUE(colors.insert({c.r, c.g, c.b}).second); };
  for (const auto decision : {hw::Decision::sampled, hw::Decision::traced}) {
    for (const auto hit : {hw::HitClass::miss, hw::HitClass::static_geometry, hw::HitClass::dynamic_geometry}) {
      insert(decision_color(decision, hit));
    }
  }
  insert(decision_color(hw::Decision::interpolated, hw::HitClass::none));
  EXPECT_EQ(decision_picture(outcome()).rgb.size(), 12u);
}

TEST_F(ReportTest, DigestIsThatOfSha256sum) {
  write_file(path("abc"), "abc");
  EXPECT_EQ(sha256_of_file(path("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(ManifestJson, SaysWhatWasRun) {
  Manifest manifest;
  manifest.command = {"artu", "run", "not \xff utf-8"};
  manifest.input = "box.glb";
  manifest.input_sha256 = "00";
  manifest.last_frame = 4;
  manifest.simulation.seed = 18446744073709551615u;
  const auto json = nlohmann::json::parse(to_json(manifest));
  EXPECT_EQ(json.at("command").at(1), "run");
  EXPECT_EQ(json.at("seed"), 18446744073709551615u);
  EXPECT_EQ(json.at("input").at("kind"), "scene");
  EXPECT_EQ(json.at("frames").at("last"), 4);
}

TEST_F(ReportTest, AFolderIsThereWholeOrNotAtAll) {
  {
    RunFolder folder(path("a/b/run"), false);
    write_file(folder.file("x"), "1");
    EXPECT_FALSE(fs::exists(path("a/b/run")));
  }
  EXPECT_FALSE(fs::exists(path("a"))) << "parents that were made for it go, too";
  RunFolder folder(path("a/b/run"), false);
  write_file(folder.file("manifest.json"), "1");
  folder.commit();
  EXPECT_TRUE(fs::exists(path("a/b/run/manifest.json")));
  EXPECT_FALSE(fs::exists(path("a/b/run.partial")));
}

TEST_F(ReportTest, OnlyARunFolderIsReplacedAndOnlyByForce) {
  fs::create_directories(path("run"));
  write_file(path("run/manifest.json"), "1");
  write_file(path("run/old"), "1");
  EXPECT_THROW(RunFolder(path("run"), false), InputError);
  { RunFolder uncommitted(path("run"), true); }
  EXPECT_TRUE(fs::exists(path("run/old")));
  RunFolder folder(path("run/"), true);
  write_file(folder.file("manifest.json"), "2");
  folder.commit();
  EXPECT_FALSE(fs::exists(path("run/old")));
  EXPECT_EQ(read_file(path("run/manifest.json")), "2");
  fs::create_directories(path("mine"));
  write_file(path("mine/thesis"), "1");
  EXPECT_THROW(RunFolder(path("mine"), true), InputError);
  EXPECT_THROW(RunFolder(path("mine/thesis"), true), InputError);
  EXPECT_TRUE(fs::exists(path("mine/thesis")));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2) << "nothing else is left";
}

TEST_F(ReportTest, AFileIsThereWholeOrNotAtAll) {
  {
    AtomicFile file(path("a.csv"), false);
    file.write("half");
  }
  EXPECT_TRUE(fs::is_empty(folder_));
  AtomicFile file(path("a.csv"), false);
  file.write("whole");
  file.close();
  EXPECT_EQ(read_file(path("a.csv")), "whole");
  EXPECT_THROW(AtomicFile(path("a.csv"), false), InputError);
  EXPECT_NO_THROW(AtomicFile(path("a.csv"), true));
  EXPECT_EQ(read_file(path("a.csv")), "whole");
}

TEST_F(ReportTest, AFullDiskIsAnInputError) {
  EXPECT_THROW(write_file("/dev/full", std::string(1 << 20, 'x')), InputError);
  EXPECT_THROW(write_file("/dev/full", "x"), InputError) << "seen only at close";
  EXPECT_THROW(write_file(path("none/x"), "x"), InputError);
}

}  // namespace
}  // namespace artu::sim
