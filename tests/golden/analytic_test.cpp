// `analytic`: the pixels and counts of `functional`, and cycles that are near those of `event`.
#include <cmath>

#include "golden/drawn.h"
#include "golden/harness.h"
#include "sim/scaling/demand.h"

namespace artu::golden_tests {
namespace {

sim::FrameOutcome render(const TestScene& test, const hw::UnitConfig& config, sim::Fidelity fidelity,
                         std::size_t frame = 0) {
  sim::SimulationOptions options;
  options.fidelity = fidelity;
  return sim::make_simulator(test.scene, config, options, frames_of(test))->run(test.frames[frame]);
}

const sim::Estimate& estimate_of(const sim::FrameOutcome& outcome, const std::string& name) {
  for (const sim::Estimate& e : outcome.estimates) {
    if (e.block.empty() && e.name == name) return e;
  }
  throw std::logic_error("no estimate of " + name);
}

Recipe large() {
  Recipe recipe;
  recipe.width = 160;
  recipe.height = 100;
  recipe.mirror = recipe.glass = true;
  recipe.subdivisions = 4;
  return recipe;
}

TEST(Analytic, HasThePixelsAndCountsOfFunctional) {
  const TestScene test = make_scene(large());
  for (const hw::TreeKind kind : {hw::TreeKind::bvh2, hw::TreeKind::bvh8, hw::TreeKind::kd}) {
    hw::UnitConfig config;
    config.accel.static_kind = config.accel.dynamic_kind = kind;
    const sim::FrameOutcome functional = render(test, config, sim::Fidelity::functional);
    const sim::FrameOutcome analytic = render(test, config, sim::Fidelity::analytic);
    EXPECT_EQ(all_pixels(functional), all_pixels(analytic));
    for (const hw::Statistic& s : functional.statistics) {
      EXPECT_EQ(s.value, counter(analytic, s.block, s.name)) << s.block << "." << s.name;
    }
  }
}

TEST(Analytic, TakesAboutTheCyclesOfEvent) {
  const TestScene test = make_scene(large());
  std::vector<hw::UnitConfig> configs(5);
  configs[1].core.count = 1;
  configs[2].core.count = 16;
  configs[2].accel.static_kind = configs[2].accel.dynamic_kind = hw::TreeKind::bvh4;
  configs[3].selective.enabled = false;
  configs[4].memory.l2.size = 65536;
  configs[4].core.node_cache.size = configs[4].core.triangle_cache.size = 2048;
  double sum = 0;
  for (const hw::UnitConfig& config : configs) {
    const sim::FrameOutcome event = render(test, config, sim::Fidelity::event);
    const sim::FrameOutcome analytic = render(test, config, sim::Fidelity::analytic);
    const double error = static_cast<double>(analytic.cycles) / static_cast<double>(event.cycles) - 1;
    EXPECT_LT(std::fabs(error), 0.3);
    sum += std::fabs(error);
  }
  EXPECT_LT(sum / static_cast<double>(configs.size()), 0.15);
}

TEST(Analytic, RequestsOfTheL1CachesAreExact) {
  const TestScene test = make_scene(large());
  const sim::FrameOutcome event = render(test, {}, sim::Fidelity::event);
  const sim::FrameOutcome analytic = render(test, {}, sim::Fidelity::analytic);
  const auto sum = [](const sim::FrameOutcome& outcome, const std::string& cache) {
    std::uint64_t reads = 0;
    for (const hw::Statistic& s : outcome.statistics) {
      const bool fits = s.block.size() > cache.size() && s.block.substr(s.block.size() - cache.size()) == cache;
      if (s.name == "reads" && (fits || s.block == cache)) reads += s.value;
    }
    return reads;
  };
  for (const char* cache : {"node_cache", "texture_cache", "pixel_cache"}) {
    EXPECT_EQ(sum(event, cache), sum(analytic, cache)) << cache;
  }
}

TEST(Analytic, TheFramesPhasesAddUp) {
  const TestScene test = make_scene(large());
  for (const bool overlap : {false, true}) {
    hw::UnitConfig config;
    config.selective.overlap = overlap;
    const sim::FrameOutcome outcome = render(test, config, sim::Fidelity::analytic);
    std::uint64_t sum = 0;
    for (const char* phase : {"start", "build", "first", "selective", "flush"}) {
      sum += counter(outcome, "control_unit", std::string("cycles_") + phase);
    }
    EXPECT_NEAR(static_cast<double>(sum), static_cast<double>(outcome.cycles), 3);
    const sim::Estimate& cycles = estimate_of(outcome, "cycles");
    EXPECT_EQ(cycles.value, static_cast<double>(outcome.cycles));
    EXPECT_LT(cycles.low, cycles.value);
    EXPECT_GT(cycles.high, cycles.value);
  }
}

TEST(Analytic, IsTheSameAgainAndForAnyOrderOfFrames) {
  Recipe recipe = large();
  recipe.width = 64;
  recipe.height = 40;
  recipe.frames = 2;
  const TestScene test = make_scene(recipe);
  sim::SimulationOptions options;
  options.fidelity = sim::Fidelity::analytic;
  const auto simulator = sim::make_simulator(test.scene, {}, options, frames_of(test));
  const sim::FrameOutcome first = simulator->run(test.frames[0]), second = simulator->run(test.frames[1]);
  EXPECT_EQ(all_counters(first), all_counters(simulator->run(test.frames[0])));
  EXPECT_EQ(all_counters(second), all_counters(render(test, {}, sim::Fidelity::analytic, 1)));
}

TEST(Analytic, MoreOfAResourceTakesNoMoreCycles) {
  const TestScene test = make_scene(large());
  const auto cycles = [&test](const auto& change) {
    hw::UnitConfig config;
    change(config);
    return render(test, config, sim::Fidelity::analytic).cycles;
  };
  EXPECT_GT(cycles([](hw::UnitConfig& c) { c.core.count = 1; }), cycles([](hw::UnitConfig& c) { c.core.count = 4; }));
  EXPECT_GT(cycles([](hw::UnitConfig& c) { c.core.contexts = 2; }), cycles([](hw::UnitConfig&) {}));
  EXPECT_GT(cycles([](hw::UnitConfig& c) { c.memory.dram.channels = 1; }), cycles([](hw::UnitConfig&) {}));
  EXPECT_GT(cycles([](hw::UnitConfig& c) { c.core.node_interval = 20; }), cycles([](hw::UnitConfig&) {}));
}

/// It must give a positive number for everything that can be configured, and its parts must not trap.
TEST(Analytic, GivesANumberForDrawnConfigurations) {
  Recipe recipe = large();
  recipe.width = 21;
  recipe.height = 13;
  recipe.subdivisions = 2;
  const TestScene test = make_scene(recipe);
  Draw draw(99);
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE("configuration " + std::to_string(i));
    const hw::UnitConfig config = draw_configuration(draw);
    const sim::FrameOutcome outcome = render(test, config, sim::Fidelity::analytic);
    EXPECT_GT(outcome.cycles, recipe.width * recipe.height);
    EXPECT_LT(outcome.cycles, 10'000'000u);
    EXPECT_LE(sim::bottleneck(sim::demands(sim::totals_of(outcome), config)).share, 1.2);
  }
}

TEST(Analytic, TakesTheSmallestFrames) {
  for (const bool everything : {false, true}) {
    Recipe recipe;
    recipe.width = recipe.height = 1;
    recipe.ground = recipe.static_sphere = recipe.moving_sphere = everything;
    if (!everything) recipe.point_lights = recipe.directional_lights = 0;
    const TestScene test = make_scene(recipe);
    const sim::FrameOutcome event = render(test, {}, sim::Fidelity::event);
    const sim::FrameOutcome analytic = render(test, {}, sim::Fidelity::analytic);
    EXPECT_GT(analytic.cycles, event.cycles / 3);
    EXPECT_LT(analytic.cycles, event.cycles * 3);
  }
}

}  // namespace
}  // namespace artu::golden_tests
