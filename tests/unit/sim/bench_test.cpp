// `artu bench`: what is measured, what is made of it, and how it is printed.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "sim/bench/report.h"
#include "sim/bench/terrain.h"
#include "sim/compare/frame_compare.h"
#include "sim/compare/golden_settings.h"
#include "sim/driver/frame_simulator.h"
#include "sim/report/numbers.h"
#include "traces/validate.h"

namespace artu::sim {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

ModeResult mode(const std::string& name, std::vector<double> seconds, std::optional<double> cycles = {},
                std::optional<Interval> interval = {}) {
  ModeResult result;
  result.mode = name;
  result.seconds = std::move(seconds);
  result.cycles = cycles;
  result.interval = interval;
  result.primary_rays = 1000;
  result.peak_bytes = 5'000'000;
  return result;
}

BenchScene scene(double golden, double event, double sampled_cycles) {
  BenchScene s;
  s.name = "scene, \"quoted\".glb";
  s.triangles = 12;
  s.width = 64;
  s.height = 48;
  s.results = {mode("golden", {golden}), mode("functional", {2 * golden}),
               mode("sampled", {event / 20}, sampled_cycles, Interval{sampled_cycles - 10, sampled_cycles + 10}),
               mode("event", {event}, 1000)};
  return s;
}

TEST(Quantile, IsLinearBetweenTwo) {
  EXPECT_EQ(quantile({3, 1, 2}, 0.5), 2);
  EXPECT_EQ(quantile({4, 1, 2, 3}, 0.5), 2.5);
  EXPECT_EQ(quantile({4, 1, 2, 3}, 0), 1);
  EXPECT_EQ(quantile({4, 1, 2, 3}, 1), 4);
  EXPECT_EQ(quantile({7}, 0.75), 7);
  EXPECT_DOUBLE_EQ(mode("m", {1, 2, 3, 4, 5}).spread(), 2.0 / 3);
  EXPECT_EQ(mode("m", {5}).spread(), 0);
}

TEST(PowerLaw, IsFoundWhereThereIsOne) {
  const std::vector<double> x{1, 2, 4, 9, 30};
  std::vector<double> y;
  for (const double v : x) y.push_back(3 * std::pow(v, 1.7));
  const PowerLaw law = fit_power_law(x, y);
  EXPECT_NEAR(law.exponent, 1.7, 1e-12);
  EXPECT_NEAR(law.factor, 3, 1e-12);
  // Least squares: what is off by a factor up and down in turns keeps the exponent.
  EXPECT_NEAR(fit_power_law({1, 10, 100, 1000}, {2, 5, 50, 2000}).exponent, 1, 1e-12);
}

TEST(PowerLaw, NeedsAFigureEverywhere) {
  Growth growth;
  growth.points = {{1, {mode("event", {1})}}, {2, {}}};
  EXPECT_TRUE(std::isnan(growth.time("event").exponent));
  growth.points[1].results = {mode("event", {4})};
  EXPECT_DOUBLE_EQ(growth.time("event").exponent, 2);
  EXPECT_DOUBLE_EQ(growth.memory("event").exponent, 0);
}

TEST(BenchScene, RatiosAndErrors) {
  const BenchScene s = scene(2, 40, 1020);
  EXPECT_EQ(s.ratio(s.results[3], golden_mode), 20);
  EXPECT_EQ(s.ratio(s.results[3], "functional"), 10);
  EXPECT_FALSE(s.ratio(s.results[3], "analytic").has_value());
  EXPECT_NEAR(*s.error(s.results[2]), 0.02, 1e-12);
  EXPECT_EQ(s.error(s.results[3]), 0);
  EXPECT_FALSE(s.error(s.results[0]).has_value()) << "no cycles";
  EXPECT_EQ(s.covered(s.results[2]), false);
  EXPECT_EQ(scene(2, 40, 1005).covered(s.results[2]), false);
  EXPECT_EQ(scene(2, 40, 1005).covered(mode("sampled", {1}, 1005, Interval{995, 1015})), true);
  EXPECT_FALSE(s.covered(s.results[3]).has_value()) << "no estimate";
}

TEST(BenchSummary, IsOverAllScenesThatHaveTheMode) {
  std::vector<BenchScene> scenes{scene(2, 40, 1020), scene(1, 10, 995), scene(1, 30, 1000)};
  scenes[2].results.erase(scenes[2].results.begin() + 2);
  const auto rows = summaries(scenes, {"golden", "functional", "analytic", "sampled", "event"});
  ASSERT_EQ(rows.size(), 4u) << "analytic was not measured";
  EXPECT_EQ(rows[3].mode, "event");
  EXPECT_EQ(rows[3].golden_median, 20);
  EXPECT_EQ(rows[3].golden_worst, 30);
  EXPECT_EQ(rows[3].mean_error, 0);
  EXPECT_EQ(rows[2].scenes, 2u);
  EXPECT_NEAR(*rows[2].mean_error, 0.0125, 1e-12);
  EXPECT_NEAR(*rows[2].worst_error, 0.02, 1e-12);
  EXPECT_EQ(rows[2].covered, 0.5);
  EXPECT_EQ(rows[2].event_median, 0.05);
  EXPECT_FALSE(rows[0].mean_error.has_value());
}

BenchReport report_of(std::vector<BenchScene> scenes) {
  BenchReport report;
  report.plan.modes = {"golden", "functional", "sampled", "event"};
  report.scenes = std::move(scenes);
  Growth growth;
  growth.what = "pixels";
  growth.of = "a scene";
  growth.points = {{100, {mode("event", {1})}}, {200, {mode("event", {2})}}};
  report.growth = {growth};
  return report;
}

TEST(BenchReport, TablesAreNarrow) {
  const std::string text = format_bench(report_of({scene(2, 40, 1020), scene(1, 10, 995)}));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120u) << line;
  EXPECT_THAT(text, HasSubstr("+1.00 +3.00 !"));
  EXPECT_THAT(text, HasSubstr("all scenes"));
  EXPECT_THAT(text, HasSubstr("pixels: a scene"));
  EXPECT_THAT(text, ::testing::ContainsRegex("event ms +1000 +2000 +2.00 +1.00"));
}

TEST(BenchReport, CsvHasARowASceneAndMode) {
  const BenchReport report = report_of({scene(2, 40, 1020)});
  std::istringstream lines(bench_csv(report));
  std::vector<std::string> rows;
  for (std::string line; std::getline(lines, line);) rows.push_back(line);
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_THAT(rows[1], ::testing::StartsWith("\"scene, \"\"quoted\"\".glb\",0,64,48,12,golden,2,0,1,0.5,,,,,,"));
  EXPECT_THAT(rows[3], HasSubstr(",sampled,2,0,1,0.5,1020,1010,1030,0.02"));
  EXPECT_EQ(growth_csv(report),
            "what,value,mode,seconds,spread,peak_bytes\npixels,100,event,1,0,5000000\npixels,200,event,2,0,5000000\n");
}

TEST(BenchReport, JsonHasNullForWhatThereIsNot) {
  const auto json = nlohmann::json::parse(bench_json(report_of({scene(2, 40, 1020)}), {"artu", "bench"}, "1"));
  const auto& modes = json.at("scenes").at(0).at("modes");
  EXPECT_TRUE(modes.at(0).at("error").is_null());
  EXPECT_TRUE(modes.at(0).at("cycles").is_null());
  EXPECT_EQ(modes.at(2).at("interval").at(1), 1030);
  EXPECT_EQ(modes.at(2).at("covered"), false);
  EXPECT_EQ(json.at("summary").at(3).at("golden_median"), 20);
  EXPECT_NEAR(json.at("growth").at(0).at("laws").at("event").at("time").at("exponent").get<double>(), 1, 1e-12);
}

TEST(BenchReport, ThePlotHasEveryModeWithCycles) {
  const Plot plot = bench_plot(report_of({scene(2, 40, 1020)}));
  EXPECT_THAT(plot.data, HasSubstr("0.05 2 \"scene"));
  EXPECT_THAT(plot.script, HasSubstr("title 'sampled'"));
  EXPECT_THAT(plot.script, ::testing::Not(HasSubstr("title 'golden'")));
  EXPECT_EQ(bench_plot(report_of({})).name, "");
}

class BenchMeasure : public ::testing::Test {
 protected:
  const traces::Scene scene_ = terrain(8, 24, 16);
  const traces::Frame frame_ = terrain_frame(24, 16);
};

TEST_F(BenchMeasure, TheTerrainIsSoundAndExact) {
  EXPECT_EQ(scene_.static_geometry.triangle_count(), 128u);
  EXPECT_NO_THROW(traces::validate(scene_, "terrain"));
  CheckResult check;
  const hw::UnitConfig unit;
  const FrameOutcome outcome = make_simulator(scene_, unit)->run(frame_);
  compare_frame(ref::Golden(scene_, golden_settings(unit)).render(frame_), outcome, check);
  EXPECT_TRUE(check.passed()) << describe(check);
  const Totals totals = totals_of(outcome);
  EXPECT_GT(totals.static_hits, totals.miss) << "it fills the picture";
  EXPECT_GT(totals.rays_shadow, 0u);
}

TEST_F(BenchMeasure, EveryModeIsMeasuredAndOneThatCannotIsANote) {
  BenchPlan plan;
  plan.modes = {"golden", "functional", "event", "clocked"};
  plan.repeats = 3;
  std::vector<std::string> notes;
  hw::UnitConfig unit;
  const auto results = measure({scene_, frame_, unit}, plan, notes);
  EXPECT_THAT(notes, ElementsAre());
  ASSERT_EQ(results.size(), 4u);
  const FrameOutcome outcome = make_simulator(scene_, unit)->run(frame_);
  for (const ModeResult& r : results) {
    EXPECT_EQ(r.seconds.size(), 3u) << r.mode;
    EXPECT_GT(r.median(), 0) << r.mode;
    EXPECT_EQ(r.primary_rays, outcome.rays_primary) << r.mode;
    EXPECT_FALSE(r.interval.has_value()) << r.mode;
    EXPECT_EQ(r.cycles.has_value(), r.mode == "event" || r.mode == "clocked") << r.mode;
  }
  EXPECT_EQ(*results[2].cycles, static_cast<double>(outcome.cycles));
  EXPECT_EQ(*results[3].cycles, static_cast<double>(outcome.cycles));
  EXPECT_EQ(results[1].node_visits, outcome.node_visits);

  unit.core.stack_entries = 1;  // too few, and refused
  EXPECT_EQ(measure({scene_, frame_, unit}, plan, notes).size(), 1u);
  ASSERT_EQ(notes.size(), 3u);
  EXPECT_THAT(notes[0], HasSubstr("terrain: functional left out: "));
  EXPECT_THAT(notes[0], HasSubstr("core.stack_entries"));
}

TEST_F(BenchMeasure, GrowthHasAPointAValue) {
  GrowthPlan plan;
  plan.bench.modes = {"golden", "event"};
  plan.bench.repeats = 1;
  plan.width = 16;
  plan.height = 12;
  plan.scene = "terrain";
  plan.load = [](std::uint32_t width, std::uint32_t height) {
    return GrowthPlan::Loaded{terrain(8, width, height), terrain_frame(width, height)};
  };
  std::vector<std::string> notes;
  const Growth pixels = grow_pixels(plan, notes);
  std::vector<std::uint64_t> values;
  for (const GrowthPoint& point : pixels.points) values.push_back(point.value);
  EXPECT_THAT(values, ElementsAre(48, 88, 192, 391, 768));
  EXPECT_GT(pixels.time("event").exponent, 0);
  EXPECT_EQ(pixels.points[0].results.size(), 2u);

  const Growth idle = grow_idle_cores(plan, notes);
  ASSERT_EQ(idle.points.size(), 5u);
  EXPECT_EQ(idle.points[4].value, 16u);
  ASSERT_EQ(idle.points[0].results.size(), 1u) << "the golden model knows no cores";
  EXPECT_EQ(idle.points[0].results[0].cycles, idle.points[4].results[0].cycles) << "one core has all the work";
  const Growth cores = grow_cores(plan, notes);
  EXPECT_LT(*cores.points[4].results[0].cycles, *cores.points[0].results[0].cycles);
}

}  // namespace
}  // namespace artu::sim
