// The parts of a sweep: samples, axes, the grid's file, the front and the table.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "sim/sweep/axis.h"
#include "sim/sweep/front.h"
#include "sim/sweep/grid.h"
#include "sim/sweep/plan.h"
#include "sim/sweep/samples.h"
#include "sim/sweep/table.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// How many samples lie in each of `parts` equal parts of a coordinate.
std::vector<int> counts(const Samples& samples, std::size_t dimension, int parts) {
  std::vector<int> counts(parts, 0);
  for (const auto& sample : samples) ++counts.at(static_cast<std::size_t>(sample[dimension] * parts));
  return counts;
}

TEST(Samples, ALatinHypercubeHasOneInEveryPart) {
  const Samples samples = latin_hypercube(37, 5, 4);
  for (std::size_t d = 0; d < 5; ++d) EXPECT_EQ(counts(samples, d, 37), std::vector<int>(37, 1)) << d;
  EXPECT_EQ(samples, latin_hypercube(37, 5, 4));
  EXPECT_NE(samples, latin_hypercube(37, 5, 5));
  const Samples fewer = latin_hypercube(37, 3, 4);
  for (std::size_t i = 0; i < 37; ++i) EXPECT_EQ(fewer[i][2], samples[i][2]) << "a further axis moves the others";
}

/// The first points of the sequence as Joe and Kuo's program prints them.
TEST(Samples, SobolsSequenceIsThatOfJoeAndKuo) {
  const Samples samples = sobol(8, 3, 0);
  const Samples known = {{0, 0, 0},
                         {0.5, 0.5, 0.5},
                         {0.75, 0.25, 0.25},
                         {0.25, 0.75, 0.75},
                         {0.375, 0.375, 0.625},
                         {0.875, 0.875, 0.125},
                         {0.625, 0.125, 0.875},
                         {0.125, 0.625, 0.375}};
  EXPECT_EQ(samples, known);
}

TEST(Samples, SobolsSequenceIsEvenWithAnyShift) {
  for (const std::uint64_t seed : {0u, 1u, 99u}) {
    const Samples samples = sobol(64, 6, seed);
    for (std::size_t d = 0; d < 6; ++d) EXPECT_EQ(counts(samples, d, 64), std::vector<int>(64, 1)) << seed << " " << d;
    // A (0, 6, 2)-net in the first two: one point in each of 8 x 8 squares.
    std::set<std::pair<int, int>> squares;
    for (const auto& sample : samples) squares.emplace(int(sample[0] * 8), int(sample[1] * 8));
    EXPECT_EQ(squares.size(), 64u) << seed;
  }
  EXPECT_NE(sobol(4, 2, 1), sobol(4, 2, 2));
}

Axis interval(ParameterKind kind, double low, double high, bool logarithmic = false, bool power = false) {
  Axis axis;
  axis.parameter.kind = kind;
  axis.parameter.power_of_two = power;
  axis.low = low;
  axis.high = high;
  axis.logarithmic = logarithmic;
  return axis;
}

TEST(Axis, EveryIntegerHasAnEqualPart) {
  const Axis axis = interval(ParameterKind::integer, 3, 6);
  std::map<std::string, int> seen;
  for (int i = 0; i < 400; ++i) ++seen[value_at(axis, i / 400.0)];
  EXPECT_THAT(seen, ElementsAre(std::pair("3", 100), std::pair("4", 100), std::pair("5", 100), std::pair("6", 100)));
}

TEST(Axis, PowersOfTwoStayPowersOfTwo) {
  const Axis axis = interval(ParameterKind::integer, 16, 128, false, true);
  std::map<std::string, int> seen;
  for (int i = 0; i < 400; ++i) ++seen[value_at(axis, i / 400.0)];
  EXPECT_THAT(seen,
              ElementsAre(std::pair("128", 100), std::pair("16", 100), std::pair("32", 100), std::pair("64", 100)));
}

TEST(Axis, ALogarithmicScaleHasItsMiddleAtTheGeometricMean) {
  EXPECT_EQ(value_at(interval(ParameterKind::real, 0.01, 100, true), 0.5), "1.0");
  EXPECT_EQ(value_at(interval(ParameterKind::real, 0, 1), 0.123456789), "0.123457");
  EXPECT_EQ(value_at(interval(ParameterKind::integer, 1, 63, true), 0.5), "8");  // the mean of 1 and 64
  EXPECT_EQ(value_at(interval(ParameterKind::integer, 1, 63, true), std::nextafter(1.0, 0.0)), "63");
}

class GridTest : public ::testing::Test {
 protected:
  GridTest() {
    std::string name = (fs::path(::testing::TempDir()) / "artu_grid_XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no folder for the test");
    folder_ = name;
    std::ofstream(folder_ / "a.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  }
  ~GridTest() override { fs::remove_all(folder_); }

  Grid read(const std::string& text) const {
    const fs::path file = folder_ / "grid.toml";
    std::ofstream(file) << text;
    return read_grid(file.string());
  }
  SweepPoints plan(const std::string& text) const { return plan_of(read("scenes = [\"a.obj\"]\n" + text)); }
  /// What is wrong, from the file's name on.
  std::string error(const std::string& text) const {
    try {
      plan_of(read(text));
    } catch (const InputError& error) {
      const std::string what = error.what();
      return what.substr(std::min(what.size(), what.find("grid.toml")));
    }
    return "none";
  }

 private:
  fs::path folder_;
};

std::vector<std::string> values(const SweepPoints& plan, std::size_t axis) {
  std::vector<std::string> values;
  for (const SweepPoint& point : plan.points) values.push_back(point.values[axis]);
  return values;
}

TEST_F(GridTest, AGridIsAProductWhoseLastAxisChangesFastest) {
  const SweepPoints points = plan("[grid]\nmemory.l2.size = [\"64KiB\", 131072]\ncore.count = [1, 2, 3]\n");
  EXPECT_THAT(values(points, 0), ElementsAre("65536", "65536", "65536", "131072", "131072", "131072"));
  EXPECT_THAT(values(points, 1), ElementsAre("1", "2", "3", "1", "2", "3"));
  EXPECT_EQ(points.points[4].unit.core.count, 2u);
  EXPECT_EQ(points.points[4].unit.memory.l2.size, 131072u);
  EXPECT_EQ(points.points[4].name.substr(0, 5), "0004-");
}

TEST_F(GridTest, APointOfAListHasTheBaseWhereItIsSilent) {
  const SweepPoints points = plan(
      "set = [\"core.count=9\"]\n[[point]]\ncore.count = 1\n[[point]]\ncore.contexts = 8\ncore.count = 2\n"
      "[[point]]\n\"core.contexts\" = 16\n");
  EXPECT_THAT(values(points, 0), ElementsAre("1", "2", "9"));
  EXPECT_EQ(points.points[1].unit.core.contexts, 8u);
  EXPECT_EQ(points.points[2].unit.core.contexts, 16u);
  EXPECT_EQ(points.points[0].unit.core.contexts, hw::UnitConfig().core.contexts);
}

TEST_F(GridTest, SamplesStayInTheirIntervals) {
  for (const char* design : {"sobol", "latin_hypercube"}) {
    const SweepPoints points = plan(
        std::string("[") + design +
        "]\nsamples = 50\nseed = 2\ncore.count = [2, 9]\nmemory.l2.size = { low = \"16KiB\", high = \"1MiB\" }\n"
        "accel.static.kind = [\"bvh2\", \"bvh4\"]\nshading.min_weight = { low = 0.01, high = 0.1, scale = \"log\" }\n");
    EXPECT_GT(points.points.size(), 40u);
    for (const SweepPoint& point : points.points) {
      EXPECT_GE(point.unit.core.count, 2u);
      EXPECT_LE(point.unit.core.count, 9u);
      EXPECT_GE(point.unit.memory.l2.size, 16384u);
      EXPECT_LE(point.unit.memory.l2.size, 1048576u);
      EXPECT_THAT(point.values[2], ::testing::AnyOf("\"bvh2\"", "\"bvh4\""));
      EXPECT_GE(point.unit.shading.min_weight, 0.01f);
      EXPECT_LE(point.unit.shading.min_weight, 0.1f);
    }
  }
}

TEST_F(GridTest, SamplesThatFallOnOthersAreLeftOut) {
  const SweepPoints points = plan("[sobol]\nsamples = 64\ncore.count = [1, 4]\n");
  EXPECT_EQ(points.points.size(), 4u);
  EXPECT_EQ(points.repeated, 60u);
}

TEST_F(GridTest, EveryPointIsSimulatedOnEveryScene) {
  const SweepPoints points = plan_of(read(
      "scenes = [\"a.obj\", { file = \"a.obj\", size = \"8x4\" }]\nsize = \"4x4\"\n[grid]\ncore.count = [1, 2]\n"));
  ASSERT_EQ(points.points.size(), 4u);
  EXPECT_EQ(points.grid.scenes[0].size, "4x4");
  EXPECT_EQ(points.grid.scenes[1].size, "8x4");
  EXPECT_EQ(points.points[1].scene, 1u);
  EXPECT_EQ(points.points[1].unit.core.count, 1u);
  std::set<std::string> names;
  for (const SweepPoint& point : points.points) names.insert(point.name.substr(5));
  EXPECT_EQ(names.size(), 4u) << "points are told apart by scene and configuration";
}

TEST_F(GridTest, CombinationsThatTheUnitRefusesAreRefusedOrSkipped) {
  const std::string grid = "[grid]\ncore.node_cache.size = [256, 16384]\ncore.node_cache.ways = [4, 64]\n";
  EXPECT_THAT(error("scenes = [\"a.obj\"]\n" + grid),
              HasSubstr("at most 4 ways would be right; that is the point "
                        "core.node_cache.size = 256, core.node_cache.ways = 64"));
  const SweepPoints points = plan("invalid = \"skip\"\n" + grid);
  ASSERT_EQ(points.points.size(), 4u);
  EXPECT_EQ(points.points[0].refusal, "");
  EXPECT_THAT(points.points[1].refusal, HasSubstr("at most 4 ways"));
  EXPECT_THAT(error("scenes = [\"a.obj\"]\ninvalid = \"skip\"\nset = [\"core.node_cache.size=256\"]\n[grid]\n"
                    "core.node_cache.ways = [32, 64]\n"),
              HasSubstr("no point of the sweep is valid"));
}

TEST_F(GridTest, BadGridsAreRefusedWithTheirLine) {
  const std::string scene = "scenes = [\"a.obj\"]\n";
  EXPECT_EQ(error("[grid\n").substr(0, 12), "grid.toml:1:");
  EXPECT_THAT(error("[grid]\ncore.count = [1]\n"), HasSubstr("has no scenes"));
  EXPECT_THAT(error("scenes = []\n"), HasSubstr("grid.toml:1: scenes is empty"));
  EXPECT_THAT(error("scenes = [\"b.obj\"]\n"), HasSubstr("grid.toml:1: "));
  EXPECT_THAT(error("scenes = [\"a.obj\", \"a.obj\"]\n"), HasSubstr("is there twice"));
  EXPECT_THAT(error(scene), HasSubstr("has no designs"));
  EXPECT_THAT(error(scene + "[grid]\ncore.count = [1]\n[sobol]\nsamples = 1\n"), HasSubstr("has several designs"));
  EXPECT_THAT(error(scene + "[grid]\n"), HasSubstr("grid.toml:2: grid names no parameter"));
  EXPECT_THAT(error(scene + "[grid]\ncore.cuont = [1]\n"),
              HasSubstr("grid.toml:3: unknown parameter core.cuont; did you mean core.count?"));
  EXPECT_THAT(error(scene + "[grid]\ncore.count = 3\n"), HasSubstr("grid.toml:3: core.count = 3 is no list; [3]"));
  EXPECT_THAT(error(scene + "[grid]\ncore.count = []\n"), HasSubstr("grid.toml:3: core.count has no value"));
  EXPECT_THAT(error(scene + "[grid]\ncore.count = [1,\n 65]\n"),
              HasSubstr("grid.toml:4: core.count = 65 is out of range; 1 ... 64 would be right"));
  EXPECT_THAT(error(scene + "[grid]\nmemory.l2.size = [\"64KiB\", 65536]\n"), HasSubstr("the value 65536 twice"));
  EXPECT_THAT(error(scene + "[grid]\ncore.count = [1]\n\"core.count\" = [2]\n"),
              HasSubstr("grid.toml:4: core.count is given twice"));
  EXPECT_THAT(error(scene + "[[point]]\ncore.count = 1\n[[point]]\ncore.count = 1\n"),
              HasSubstr("grid.toml:4: the point is that of line 2 again"));
  EXPECT_THAT(error(scene + "[sobol]\ncore.count = [1, 4]\n"), HasSubstr("grid.toml:2: has no samples"));
  EXPECT_THAT(error(scene + "[sobol]\nsamples = 0\n"), HasSubstr("grid.toml:3: samples = 0"));
  EXPECT_THAT(error(scene + "[sobol]\nsamples = 4\ncore.count = [4, 1]\n"),
              HasSubstr("grid.toml:4: core.count ends at 1"));
  EXPECT_THAT(error(scene + "[sobol]\nsamples = 4\ncore.count = [1, 2, 3]\n"), HasSubstr("has 3 ends"));
  EXPECT_THAT(error(scene + "[sobol]\nsamples = 4\nmemory.l2.size = [1000, 2048]\n"),
              HasSubstr("is not a power of two"));
  EXPECT_THAT(error(scene + "[sobol]\nsamples = 4\ncore.count = { low = 1, high = 4, scale = \"cubic\" }\n"),
              HasSubstr("linear or log would be right"));
  EXPECT_THAT(error(scene + "[sobol]\nsamples = 4\ncore.count = { low = 1, hihg = 4 }\n"),
              HasSubstr("did you mean high?"));
  EXPECT_THAT(error(scene + "frmes = \"0:1\"\n"), HasSubstr("grid.toml:2: unknown key frmes; did you mean frames?"));
  EXPECT_THAT(error(scene + "foo = 1\n"), HasSubstr("grid.toml:2: unknown key foo; there are scenes, frames"));
  EXPECT_THAT(error(scene + "frames = \"x\"\n"), HasSubstr("grid.toml:2: --frames"));
  EXPECT_THAT(error(scene + "fidelity = \"guess\"\n"), HasSubstr("grid.toml:2: --fidelity"));
  EXPECT_THAT(error(scene + "set = [\"core.count=0\"]\n"), HasSubstr("grid.toml:2: core.count = 0 is out of range"));
  EXPECT_THAT(error(scene + "set = \"core.count=1\"\n"), HasSubstr("is no list"));
  EXPECT_THAT(error(scene + "[screen]\nfidelity = \"functional\"\n"), HasSubstr("analytic or sampled would be right"));
  EXPECT_THAT(error(scene + "fidelity = \"analytic\"\n[screen]\n"), HasSubstr("does not confirm"));
  EXPECT_THAT(error(scene + "objectives = [\"speed\"]\n[grid]\ncore.count = [1, 2]\n"),
              HasSubstr("the objective \"speed\""));
  EXPECT_THAT(error(scene + "objectives = [\"energy.frame_uj\"]\n[screen]\n[grid]\ncore.count = [1, 2]\n"),
              HasSubstr("nor a figure that analytic has"));
  EXPECT_THAT(error(scene + "objectives = [\"accel.static.kind\"]\n[grid]\naccel.static.kind = [\"bvh2\"]\n"),
              HasSubstr("is no number"));
  EXPECT_THAT(error(scene + "[grid]\ncore.count = " + "[1, 2]\nmemory.l2.mshrs = 1979-05-27\n"),
              HasSubstr("is no list"));
}

SweepTable table(const std::vector<std::vector<nlohmann::ordered_json>>& rows) {
  return {{"point", "scene", "frames", "size", "status", "cost", "gain"}, rows};
}

TEST(Front, HoldsThePointsThatNoneIsBetterThan) {
  const SweepTable t = table({{0, "a", "", "", "ok", 10, 1.0},
                              {1, "a", "", "", "ok", 5, 1.0},   // better than 0
                              {2, "a", "", "", "ok", 20, 2.0},  // dearer, but gains more
                              {3, "a", "", "", "ok", 20, 2.0},  // as good as 2: both stay
                              {4, "a", "", "", "dead-lock", nullptr, nullptr},
                              {5, "b", "", "", "ok", 30, 0.5},  // of another scene
                              {6, "a", "", "", "violated", 1, 9.0}});
  const std::vector<Objective> objectives{{"cost", false}, {"gain", true}};
  EXPECT_THAT(front_of(t, objectives), ElementsAre(1, 2, 3, 5));
  EXPECT_THAT(front_of(t, {{"cost", false}}), ElementsAre(1, 5));
  EXPECT_THAT(front_of(t, {}), ElementsAre());
}

TEST(Front, AMarginKeepsWhatIsNearlyAsGood) {
  const SweepTable t = table({{0, "a", "", "", "ok", 100, 100.0},
                              {1, "a", "", "", "ok", 104, 96.0},   // worse by 4 % in both
                              {2, "a", "", "", "ok", 120, 100.0},  // as good in one
                              {3, "a", "", "", "ok", 120, 80.0}});
  const std::vector<Objective> objectives{{"cost", false}, {"gain", true}};
  EXPECT_THAT(front_of(t, objectives), ElementsAre(0));
  EXPECT_THAT(front_of(t, objectives, 0.05), ElementsAre(0, 1, 2));
}

TEST(SweepTable, CellsAreQuotedWhereTheyMust) {
  const SweepTable t{{"a", "b, c"}, {{"x\"y", nullptr}, {1.5, "two\nlines"}}};
  EXPECT_EQ(csv_of(t), "a,\"b, c\"\n\"x\"\"y\",\n1.5,\"two\nlines\"\n");
}

TEST(SweepTable, AnEstimateHasItsIntervalBesideIt) {
  const auto stats = nlohmann::ordered_json::parse(R"({"totals": {"frames": 2, "cycles": 10, "dram": {"read_bytes": 7},
    "blocks": {"l2": {"hits": 3}}, "estimates": {"cycles": {"value": 10, "low": 8, "high": 14, "unit": "cycles"}}},
    "derived": {"cycles_per_frame": 5.0}, "energy": {"frame_uj": 2.5, "blocks": {"l2": 1}},
    "demand": {"bottleneck": "DRAM buses", "shares": {"DRAM buses": 0.5}}})");
  std::string text;
  for (const auto& [name, value] : figures_of(stats)) text += name + "=" + value.dump() + " ";
  EXPECT_EQ(text,
            "cycles=10 cycles.low=8.0 cycles.high=14.0 dram.read_bytes=7 cycles_per_frame=5.0 cycles_per_frame.low=4.0 "
            "cycles_per_frame.high=7.0 energy.frame_uj=2.5 energy.blocks.l2=1 demand.DRAM_buses=0.5 "
            "bottleneck=\"DRAM buses\" ");
}

}  // namespace
}  // namespace artu::sim
