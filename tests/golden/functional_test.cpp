// `functional` is `event` without time: every field of every pixel, and every count that does not depend on time.
#include "golden/drawn.h"
#include "golden/harness.h"
#include "sim/driver/functional_simulator.h"
#include "sim/report/cycle_table.h"

namespace artu::golden_tests {
namespace {

/// Of all cores or banks together.
std::uint64_t sum_of(const sim::FrameOutcome& outcome, const std::string& block, const std::string& name) {
  std::uint64_t sum = 0;
  bool found = false;
  for (const hw::Statistic& s : outcome.statistics) {
    if (sim::without_number(s.block) != block || s.name != name) continue;
    sum += s.value;
    found = true;
  }
  EXPECT_TRUE(found) << block << "." << name;
  return sum;
}

void expect_same_pixels(const sim::FrameOutcome& event, const sim::FrameOutcome& functional) {
  ASSERT_EQ(event.pixels.size(), functional.pixels.size());
  for (std::size_t i = 0; i < event.pixels.size(); ++i) {
    const hw::PixelRecord &a = event.pixels[i], &b = functional.pixels[i];
    const bool same = a.pass == b.pass && a.hit_class == b.hit_class && a.n_static == b.n_static &&
                      a.n_dynamic == b.n_dynamic && a.threshold == b.threshold && a.difference == b.difference &&
                      a.decision == b.decision && a.r == b.r && a.g == b.g && a.b == b.b && a.written == b.written &&
                      a.primitive == b.primitive && a.t_bits == b.t_bits;
    ASSERT_TRUE(same) << "pixel " << i % event.width << ", " << i / event.width;
    ASSERT_EQ(b.cycles, 0u);
  }
}

/// Where the build overlaps with the first pass, the order in which a ray visits the trees depends on time.
void expect_same_counts(const sim::FrameOutcome& event, const sim::FrameOutcome& functional, bool overlap) {
  for (const hw::Statistic& s : functional.statistics) {
    // Which triangles behind a shadow ray's first hit are fetched before it is known depends on time; not how many
    // there are.
    if (s.block == "core.intersection") continue;
    if (s.block == "core.traversal" && overlap) continue;
    EXPECT_EQ(sum_of(event, s.block, s.name), s.value) << s.block << "." << s.name;
  }
  if (overlap) return;
  const auto in_leaves = [](const sim::FrameOutcome& outcome) {
    return sum_of(outcome, "core.intersection", "triangle_tests") + sum_of(outcome, "core.intersection", "left_out");
  };
  EXPECT_EQ(in_leaves(event), in_leaves(functional));
  EXPECT_GE(event.triangle_tests, functional.triangle_tests);
  if (event.rays_shadow == 0) {
    EXPECT_EQ(event.triangle_tests, functional.triangle_tests);
  }
  EXPECT_EQ(event.node_visits, functional.node_visits);
}

/// All frames in both modes, with and without SSE2.
void expect_same(const TestScene& test, const hw::UnitConfig& config) {
  const auto event = sim::make_simulator(test.scene, config, {}, frames_of(test));
  sim::SimulationOptions options;
  options.fidelity = sim::Fidelity::functional;
  const auto functional = sim::make_simulator(test.scene, config, options, frames_of(test));
  sim::FunctionalSimulator portable(test.scene, config, options, frames_of(test), true);
  for (const traces::Frame& frame : test.frames) {
    const sim::FrameOutcome expected = event->run(frame);
    for (sim::FrameSimulator* simulator : {functional.get(), static_cast<sim::FrameSimulator*>(&portable)}) {
      const sim::FrameOutcome outcome = simulator->run(frame);
      ASSERT_NO_FATAL_FAILURE(expect_same_pixels(expected, outcome));
      expect_same_counts(expected, outcome, config.tree_builder.overlap);
      EXPECT_EQ(outcome.fidelity, sim::Fidelity::functional);
      EXPECT_EQ(outcome.cycles, 0u);
    }
  }
}

Recipe everything() {
  Recipe recipe;
  recipe.mirror = recipe.glass = true;
  recipe.spot_lights = 1;
  recipe.frames = 2;
  return recipe;
}

class FunctionalOfTrees : public testing::TestWithParam<hw::TreeKind> {};

TEST_P(FunctionalOfTrees, IsEventForEveryPrecision) {
  const TestScene scene = make_scene(everything());
  for (const hw::PrecisionConfig precision :
       {hw::PrecisionConfig{}, {7, 7, 7}, {12, 23, 10}, {23, 11, 23}, {23, 23, 9}}) {
    SCOPED_TRACE(precision.box);
    hw::UnitConfig config;
    config.accel.static_kind = config.accel.dynamic_kind = GetParam();
    config.precision = precision;
    expect_same(scene, config);
  }
}

TEST_P(FunctionalOfTrees, IsEventBesideEveryOtherTreeAndLeafSize) {
  Recipe recipe;
  recipe.offset = 100;
  const TestScene scene = make_scene(recipe);
  for (std::uint32_t other = 0; other < 4; ++other) {
    SCOPED_TRACE(other);
    hw::UnitConfig config;
    config.accel.static_kind = GetParam();
    config.accel.dynamic_kind = static_cast<hw::TreeKind>(other);
    config.accel.leaf_size = 1 + 5 * other;
    expect_same(scene, config);
  }
}

INSTANTIATE_TEST_SUITE_P(All, FunctionalOfTrees,
                         testing::Values(hw::TreeKind::bvh2, hw::TreeKind::bvh4, hw::TreeKind::bvh8, hw::TreeKind::kd));

TEST(Functional, IsEventForDrawnConfigurations) {
  Recipe recipe = everything();
  recipe.width = 21;
  recipe.height = 13;
  recipe.frames = 1;
  const TestScene scene = make_scene(recipe);
  Draw draw(777);
  for (int i = 0; i < 80; ++i) {
    SCOPED_TRACE("configuration " + std::to_string(i));
    hw::UnitConfig config = draw_configuration(draw);
    if (draw(2) != 0) config.precision = {7 + draw(17), 7 + draw(17), 7 + draw(17)};
    config.shading.max_depth = draw(5);
    expect_same(scene, config);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(Functional, IsEventForOddSizes) {
  for (const auto& [width, height] : {std::pair<std::uint32_t, std::uint32_t>{1, 1}, {3, 5}, {1, 17}, {65, 2}}) {
    Recipe recipe = everything();
    recipe.width = width;
    recipe.height = height;
    for (const std::uint32_t stride : {2u, 8u}) {
      hw::UnitConfig config;
      config.selective.stride = stride;
      config.selective.passes = stride == 8 ? hw::Passes::average : hw::Passes::horizontal_vertical;
      expect_same(make_scene(recipe), config);
      config.selective.enabled = false;
      expect_same(make_scene(recipe), config);
    }
  }
}

TEST(Functional, IsEventWithoutLightsOrGeometry) {
  Recipe dark;
  dark.point_lights = dark.directional_lights = 0;
  expect_same(make_scene(dark), {});
  Recipe still;
  still.moving_sphere = false;
  expect_same(make_scene(still), {});
  Recipe moving;
  moving.ground = moving.static_sphere = false;
  expect_same(make_scene(moving), {});
  moving.moving_sphere = false;
  expect_same(make_scene(moving), {});
}

TEST(Functional, IsEventForRefittedAndMortonTrees) {
  Recipe recipe;
  recipe.frames = 3;
  const TestScene scene = make_scene(recipe);
  hw::UnitConfig config;
  config.tree_builder.refit = true;
  config.tree_builder.refit_interval = 2;
  expect_same(scene, config);
  config.tree_builder.algorithm = hw::BuildAlgorithm::morton;
  config.accel.dynamic_kind = hw::TreeKind::bvh4;
  expect_same(scene, config);
}

/// Rays along the axes have slabs without an inverse: a path of its own.
TEST(Functional, IsEventForRaysAlongAxes) {
  TestScene scene = make_scene(everything());
  for (traces::Frame& frame : scene.frames) {
    frame.camera.du = {1, 0, 0};
    frame.camera.dv = {0, 0, 0};
    frame.camera.corner = {-24.5f, 0, -20};
  }
  expect_same(scene, {});
}

TEST(Functional, OptionsThatItCannotHonourAreRefused) {
  const TestScene scene = make_scene({});
  const auto refused = [&scene](auto&& change) {
    sim::SimulationOptions options;
    options.fidelity = sim::Fidelity::functional;
    change(options);
    EXPECT_ANY_THROW(sim::make_simulator(scene.scene, {}, options));
  };
  refused([](sim::SimulationOptions& o) { o.random_stall = true; });
  refused([](sim::SimulationOptions& o) { o.shuffle_ticks = true; });
  refused([](sim::SimulationOptions& o) { o.log.push_back({"*", hw::LogLevel::info}); });
  refused([](sim::SimulationOptions& o) { o.fault.datapath = hw::Datapath::box; });
  refused([](sim::SimulationOptions& o) { o.memory_observer = [](hw::Cycle, const hw::MemoryRequest&) {}; });
}

}  // namespace
}  // namespace artu::golden_tests
