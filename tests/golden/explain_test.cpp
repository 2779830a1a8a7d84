// Planted bottlenecks: configurations that are bound by one thing each.  What is named, what is advised, what that
// gains against what it can gain at most, and what another parameter does not gain.
#include <gmock/gmock.h>

#include "golden/drawn.h"
#include "golden/harness.h"
#include "sim/config/configuration.h"
#include "sim/explain/explain.h"
#include "sim/report/numbers.h"
#include "traces/error.h"

namespace artu::golden_tests {
namespace {

using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

using Settings = std::vector<std::string>;

struct Planted {
  const char* name;
  sim::Bound bound;
  Recipe recipe;
  Settings settings;
  const char* advice;     // the parameter that is to be turned
  const char* unrelated;  // one that hardly helps
};

/// Names the test, and the value in its messages.
void PrintTo(const Planted& planted, std::ostream* out) { *out << planted.name; }

Recipe still(unsigned subdivisions) {
  Recipe recipe;
  recipe.width = 96;
  recipe.height = 64;
  recipe.moving_sphere = false;
  recipe.subdivisions = subdivisions;
  return recipe;
}

Recipe moving(unsigned subdivisions) {
  Recipe recipe = still(subdivisions);
  recipe.static_sphere = false;
  recipe.moving_sphere = true;
  return recipe;
}

/// Spots that shine at the sky: shading looks at each and finds that it adds nothing.
Recipe many_lights() {
  Recipe recipe = still(1);
  recipe.directional_lights = recipe.point_lights = 0;
  recipe.spot_lights = 60;
  return recipe;
}

const Planted planted[] = {
    {"Traversal",
     sim::Bound::traversal,
     still(3),
     {"core.node_interval=12"},
     "core.node_interval",
     "memory.dram.channels=4"},
    {"BoxTesters",
     sim::Bound::traversal,
     still(3),
     {"core.box_testers=1", "core.count=1", "accel.static.kind=bvh8", "core.contexts=128"},
     "core.box_testers",
     "memory.l2_banks=8"},
    {"Intersection",
     sim::Bound::intersection,
     still(3),
     {"core.triangle_interval=40"},
     "core.triangle_interval",
     "core.box_testers=4"},
    {"L1",
     sim::Bound::l1,
     still(4),
     {"core.node_cache.size=256", "core.node_cache.ways=1", "core.node_cache.mshrs=1",
      "memory.interconnect_latency=12"},
     "core.node_cache.mshrs",
     "core.triangle_interval=2"},
    {"L2",
     sim::Bound::l2,
     still(4),
     {"memory.l2_banks=1", "core.count=24", "core.node_cache.size=256", "core.node_cache.ways=1",
      "core.triangle_cache.size=256", "core.triangle_cache.ways=1"},
     "memory.l2_banks",
     "core.contexts=64"},
    {"DramBandwidth",
     sim::Bound::dram_bandwidth,
     still(5),
     {"memory.dram.channels=1", "memory.dram.clock_mhz=400", "memory.l2.size=16KiB", "core.node_cache.size=1KiB"},
     "memory.dram.channels",
     "core.contexts=48"},
    {"DramLatency",
     sim::Bound::dram_latency,
     still(5),
     {"memory.dram.t_cl=900", "memory.l2.size=16KiB", "core.contexts=4", "core.count=2", "core.node_cache.size=1KiB"},
     "core.contexts",
     "core.box_testers=4"},
    {"Shading", sim::Bound::shading, many_lights(), {"core.count=2"}, "core.count", "core.node_cache.mshrs=16"},
    {"TreeBuild",
     sim::Bound::tree_build,
     moving(4),
     {"tree_builder.cycles_per_triangle=16"},
     "tree_builder.binning_units",
     "core.count=8"},
    {"QueueDepth",
     sim::Bound::queue_depth,
     still(5),
     {"memory.dram.queue_depth=1", "memory.l2.size=16KiB", "core.node_cache.size=1KiB"},
     "memory.dram.queue_depth",
     "core.box_testers=4"},
    {"CandidateExtraction",
     sim::Bound::candidate_extraction,
     still(1),
     {"selective.reference=255", "selective.minimum=255", "selective.stride=4", "selective.tile=8",
      "selective.pixel_cache.hit_latency=60"},
     "selective.pixel_cache.hit_latency",
     "memory.dram.channels=4"},
    // Beyond the ten.
    {"PixelsInFlight",
     sim::Bound::pipeline_latency,
     still(3),
     {"core.contexts=2"},
     "core.contexts",
     "memory.l2.mshrs=64"},
    {"L2Misses",
     sim::Bound::l2,
     still(5),
     {"memory.l2.mshrs=2", "memory.l2_banks=1", "memory.l2.size=16KiB", "core.node_cache.size=1KiB"},
     "memory.l2.mshrs",
     "core.box_testers=4"},
};

hw::UnitConfig configured(const Settings& settings) { return sim::Configuration::of({}, settings).unit(); }

TestScene scene_of(const Planted& planted) {
  TestScene test = make_scene(planted.recipe);
  for (traces::Frame& frame : test.frames) {
    for (traces::Light& light : frame.lights) {
      if (light.kind == traces::LightKind::spot) light.direction = {0, 1, 0};
    }
  }
  return test;
}

sim::Totals simulate(const TestScene& test, const hw::UnitConfig& unit) {
  sim::Simulator simulator(test.scene, unit, {}, frames_of(test));
  sim::Totals sum;
  for (const traces::Frame& frame : test.frames) sim::add(sum, sim::totals_of(simulator.run(frame)));
  return sum;
}

class PlantedBottleneck : public ::testing::TestWithParam<Planted> {};

TEST_P(PlantedBottleneck, IsNamedAndTheAdviceHelps) {
  const Planted& planted = GetParam();
  const TestScene test = scene_of(planted);
  const hw::UnitConfig unit = configured(planted.settings);
  const sim::Totals totals = simulate(test, unit);
  const sim::Explanation e = sim::explain(totals, unit);
  SCOPED_TRACE(sim::format_explanation(e));
  EXPECT_STREQ(sim::name_of(e.found.at(0).bound), sim::name_of(planted.bound));
  EXPECT_EQ(e.found.size(), 1u);
  ASSERT_FALSE(e.advice.empty());
  const sim::Advice& advice = e.advice[0];
  EXPECT_EQ(advice.parameter, planted.advice);

  const auto before = static_cast<double>(totals.cycles);
  const auto after = static_cast<double>(simulate(test, advice.unit).cycles);
  EXPECT_LT(after, 0.93 * before) << "the advice gains nothing";
  EXPECT_GE(after, 0.995 * advice.floor) << "it gains more than it can";
  Settings other = planted.settings;
  other.push_back(planted.unrelated);
  const auto beside = static_cast<double>(simulate(test, configured(other)).cycles);
  EXPECT_GT(beside, 0.96 * before) << planted.unrelated << " helps as well";
  EXPECT_GT(before - after, 3 * (before - beside));
}

INSTANTIATE_TEST_SUITE_P(All, PlantedBottleneck, ::testing::ValuesIn(planted),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Explain, SaysWhatTies) {
  const TestScene test = make_scene(still(3));
  const hw::UnitConfig unit = configured({"core.node_interval=12", "core.triangle_interval=40"});
  const sim::Explanation e = sim::explain(simulate(test, unit), unit);
  const std::string text = sim::format_explanation(e);
  ASSERT_EQ(e.found.size(), 2u) << text;
  EXPECT_THAT(text, HasSubstr("two things bind: "));
  EXPECT_THAT((std::vector<std::string>{sim::name_of(e.found[0].bound), sim::name_of(e.found[1].bound)}),
              UnorderedElementsAre("traversal", "intersection"));
  // The other one is in the way.
  EXPECT_GT(e.advice.at(0).floor, 0.8 * e.account.cycles);
}

TEST(Explain, ADrawnConfigurationNeverNeedsMoreThanItTook) {
  Recipe recipe;
  recipe.mirror = recipe.glass = true;
  recipe.subdivisions = 3;
  const TestScene test = make_scene(recipe);
  Draw draw(7);
  for (int i = 0; i < 24; ++i) {
    const hw::UnitConfig unit = draw_configuration(draw);
    const sim::Totals totals = simulate(test, unit);
    const sim::Explanation e = sim::explain(totals, unit);
    SCOPED_TRACE("configuration " + std::to_string(i) + "\n" + sim::format_explanation(e));
    const sim::Accounting& a = e.account;
    EXPECT_EQ(a.start + a.build + a.first + a.selective + a.flush, a.cycles);
    for (std::size_t r = 0; r < sim::resource_count; ++r) {
      EXPECT_LE(a.needs[r], a.passes()) << sim::name_of(static_cast<sim::Resource>(r));
    }
    EXPECT_LE(a.in_pipelines, a.resident);
    ASSERT_FALSE(e.found.empty());
    for (const sim::Advice& advice : e.advice) {
      EXPECT_GT(advice.floor, 0);
      EXPECT_LE(advice.floor, a.cycles);
      EXPECT_LE(advice.far, advice.floor);
      EXPECT_NE(sim::value_of(advice.unit, advice.parameter), advice.from);
    }
  }
}

TEST(Explain, NeedsWhatAnExactRunCounts) {
  sim::Totals totals;
  totals.fidelity = sim::Fidelity::functional;
  EXPECT_THROW(sim::explain(totals, {}), InputError);
}

}  // namespace
}  // namespace artu::golden_tests
