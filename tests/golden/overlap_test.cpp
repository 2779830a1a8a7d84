// Passes that overlap give the bits of passes that do not, for every plan of passes and in every mode.
#include "golden/harness.h"

namespace artu::golden_tests {
namespace {

TestScene scene() {
  Recipe recipe;
  recipe.width = 71;
  recipe.height = 45;
  recipe.frames = 2;
  recipe.mirror = recipe.glass = true;
  return make_scene(recipe);
}

std::vector<sim::FrameOutcome> simulate(const TestScene& test, const hw::UnitConfig& config,
                                        const sim::SimulationOptions& options = {}) {
  sim::Simulator simulator(test.scene, config, options, frames_of(test));
  std::vector<sim::FrameOutcome> outcomes;
  for (const traces::Frame& frame : test.frames) {
    outcomes.push_back(simulator.run(frame));
    EXPECT_TRUE(outcomes.back().violations.empty()) << outcomes.back().violations.front();
  }
  return outcomes;
}

void expect_same_pixels(const std::vector<sim::FrameOutcome>& a, const std::vector<sim::FrameOutcome>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(all_pixels(a[i]), all_pixels(b[i])) << "frame " << i;
    for (std::size_t p = 0; p < a[i].pixels.size(); ++p) {
      ASSERT_EQ(a[i].pixels[p].pass, b[i].pixels[p].pass);
      ASSERT_EQ(b[i].pixels[p].written, 1);
    }
  }
}

TEST(Overlap, ChangesNoBitOfAnyPlanOfPasses) {
  const TestScene test = scene();
  for (std::uint32_t stride : {2u, 4u, 8u}) {
    for (hw::Passes passes : {hw::Passes::horizontal_vertical, hw::Passes::average}) {
      SCOPED_TRACE(std::to_string(stride) + (passes == hw::Passes::average ? " average" : ""));
      hw::UnitConfig config;
      config.selective.stride = stride;
      config.selective.passes = passes;
      const auto apart = simulate(test, config);
      config.selective.overlap = true;
      const auto together = simulate(test, config);
      expect_same_pixels(apart, together);
      sim::SimulationOptions mode;
      mode.fidelity = sim::Fidelity::clocked;
      mode.shuffle_ticks = true;
      mode.seed = stride;
      const auto clocked = simulate(test, config, mode);
      for (std::size_t i = 0; i < together.size(); ++i) EXPECT_EQ(all_counters(clocked[i]), all_counters(together[i]));
      mode = {};
      mode.random_stall = true;
      mode.seed = stride;
      expect_same_pixels(apart, simulate(test, config, mode));
    }
  }
}

TEST(Overlap, GoesWithEveryOrderAndEveryNumberOfCores) {
  const TestScene test = scene();
  const auto apart = simulate(test, {});
  for (std::uint32_t i = 0; i < 12; ++i) {
    hw::UnitConfig config;
    config.selective.overlap = true;
    config.selective.tile = 4u << i % 5;
    config.core.count = 1 + i % 7;
    config.core.pixel_order = static_cast<hw::PixelOrder>(i % 2);
    config.core.dispatch = static_cast<hw::Dispatch>(i / 2 % 2);
    config.tree_builder.overlap = i % 3 == 0;
    config.memory.write_combining = 2 + i;
    sim::SimulationOptions mode;
    mode.random_stall = i % 4 == 1;
    mode.seed = i;
    expect_same_pixels(apart, simulate(test, config, mode));
  }
}

TEST(Overlap, IsExactAgainstTheGoldenModel) {
  hw::UnitConfig config;
  config.selective.overlap = true;
  expect_exact(run(scene(), config));
}

}  // namespace
}  // namespace artu::golden_tests
