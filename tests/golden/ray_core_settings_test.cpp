// Short stacks, ray and pixel orders, dispatch, banks: other cycles, the same pixels to the bit.
#include "golden/harness.h"

namespace artu::golden_tests {
namespace {

constexpr hw::TreeKind kinds[] = {hw::TreeKind::bvh2, hw::TreeKind::bvh4, hw::TreeKind::bvh8, hw::TreeKind::kd};

TestScene everything() {
  Recipe recipe;
  recipe.mirror = recipe.glass = true;
  recipe.frames = 2;
  recipe.subdivisions = 3;
  recipe.spot_lights = 1;
  return make_scene(recipe);
}

struct Setting {
  std::string name;
  hw::UnitConfig config;
};

/// Every setting of the issue that changes the order of work, with each kind of tree where it matters.
std::vector<Setting> settings() {
  std::vector<Setting> all;
  const auto add = [&](std::string name, auto change) {
    hw::UnitConfig config;
    change(config);
    all.push_back({std::move(name), config});
  };
  for (hw::TreeKind kind : kinds) {
    const std::string tree = " with tree " + std::to_string(static_cast<unsigned>(kind));
    for (std::uint32_t entries : {1u, 2u, 5u}) {
      add("restart trail, " + std::to_string(entries) + " entries" + tree, [&](hw::UnitConfig& c) {
        c.accel.static_kind = c.accel.dynamic_kind = kind;
        c.core.stack_overflow = hw::StackOverflow::restart;
        c.core.stack_entries = entries;
      });
    }
    add("spilling" + tree, [&](hw::UnitConfig& c) {
      c.accel.static_kind = kind;
      c.accel.dynamic_kind = hw::TreeKind::bvh8;
      c.core.stack_overflow = hw::StackOverflow::spill;
      c.core.stack_entries = 8;
    });
  }
  add("primary rays first", [](hw::UnitConfig& c) { c.core.ray_order = hw::RayOrder::primary_first; });
  add("first come", [](hw::UnitConfig& c) { c.core.ray_order = hw::RayOrder::first_come; });
  add("Morton", [](hw::UnitConfig& c) { c.core.pixel_order = hw::PixelOrder::morton; });
  add("tiles to cores", [](hw::UnitConfig& c) { c.core.dispatch = hw::Dispatch::tiles; });
  add("slow testers", [](hw::UnitConfig& c) { c.core.node_interval = c.core.triangle_interval = 5; });
  add("little combining", [](hw::UnitConfig& c) { c.memory.write_combining = 2; });
  for (std::uint32_t banks : {2u, 8u}) {
    add(std::to_string(banks) + " banks", [&](hw::UnitConfig& c) { c.memory.l2_banks = banks; });
  }
  add("overlapped build", [](hw::UnitConfig& c) { c.tree_builder.overlap = true; });
  add("overlapped build and a restart trail", [](hw::UnitConfig& c) {
    c.tree_builder.overlap = true;
    c.tree_builder.cycles_per_triangle = 100;
    c.core.stack_overflow = hw::StackOverflow::restart;
    c.core.stack_entries = 1;
  });
  add("all at once", [](hw::UnitConfig& c) {
    c.accel.static_kind = hw::TreeKind::bvh4;
    c.core.stack_overflow = hw::StackOverflow::restart;
    c.core.stack_entries = 3;
    c.core.ray_order = hw::RayOrder::first_come;
    c.core.pixel_order = hw::PixelOrder::morton;
    c.core.dispatch = hw::Dispatch::tiles;
    c.memory.l2_banks = 4;
    c.core.triangle_interval = 2;
  });
  return all;
}

TEST(RayCoreSettings, ChangeNoPixel) {
  const TestScene scene = everything();
  const Rendered reference = run(scene);
  for (const Setting& setting : settings()) {
    SCOPED_TRACE(setting.name);
    const Rendered r = run(scene, setting.config);
    expect_exact(r);
    for (std::size_t i = 0; i < scene.frames.size(); ++i) {
      EXPECT_EQ(all_pixels(r.outcomes[i]), all_pixels(reference.outcomes[i]));
    }
  }
}

TEST(RayCoreSettings, AreTheSameClockedShuffledAndStalled) {
  Recipe recipe;
  recipe.mirror = true;
  recipe.subdivisions = 3;
  const TestScene scene = make_scene(recipe);
  for (const Setting& setting : settings()) {
    SCOPED_TRACE(setting.name);
    sim::SimulationOptions clocked, stalled;
    clocked.fidelity = sim::Fidelity::clocked;
    clocked.shuffle_ticks = true;
    stalled.random_stall = true;
    EXPECT_EQ(all_counters(run(scene, setting.config).outcomes[0]),
              all_counters(run(scene, setting.config, clocked).outcomes[0]));
    const Rendered slow = run(scene, setting.config, stalled);
    expect_exact(slow);
    stalled.fidelity = sim::Fidelity::clocked;
    EXPECT_EQ(all_counters(slow.outcomes[0]), all_counters(run(scene, setting.config, stalled).outcomes[0]));
  }
}

std::uint64_t of_cores(const sim::FrameOutcome& outcome, const std::string& name) {
  std::uint64_t sum = 0;
  for (const hw::Statistic& s : outcome.statistics) {
    if (s.name == name) sum += s.value;
  }
  return sum;
}

TEST(RayCoreSettings, WithAnOverlappedBuildRaysWaitForTheTreeAndNotTheFrame) {
  const TestScene scene = everything();
  hw::UnitConfig config;
  config.tree_builder.cycles_per_triangle = 20;
  const sim::FrameOutcome before = run(scene, config).outcomes[0];
  config.tree_builder.overlap = true;
  const sim::FrameOutcome after = run(scene, config).outcomes[0];
  EXPECT_GT(counter(before, "control_unit", "cycles_build"), 0u);
  EXPECT_EQ(counter(after, "control_unit", "cycles_build"), 0u);
  EXPECT_GT(of_cores(after, "tree_waits"), 0u);
  EXPECT_EQ(of_cores(before, "tree_waits"), 0u);
}

TEST(RayCoreSettings, ATreeThatNobodyNeedsIsBuiltBeforeTheFrameEnds) {
  Recipe recipe;
  recipe.width = recipe.height = 1;
  const TestScene scene = make_scene(recipe);
  hw::UnitConfig config;
  config.tree_builder.overlap = true;
  config.tree_builder.cycles_per_triangle = 1000;
  const Rendered r = run(scene, config);
  expect_exact(r);
  EXPECT_EQ(counter(r.outcomes[0], "tree_builder", "builds"), 1u);
}

TEST(RayCoreSettings, AShortStackWithARestartTrailVisitsMoreNodesTheFewerItsEntries) {
  const TestScene scene = everything();
  std::uint64_t visits = run(scene).outcomes[0].node_visits;
  const std::uint64_t leaves = of_cores(run(scene).outcomes[0], "leaves");
  EXPECT_EQ(of_cores(run(scene).outcomes[0], "restarts"), 0u);
  for (std::uint32_t entries : {4u, 2u, 1u}) {
    hw::UnitConfig config;
    config.core.stack_overflow = hw::StackOverflow::restart;
    config.core.stack_entries = entries;
    const Rendered r = run(scene, config);
    EXPECT_GT(of_cores(r.outcomes[0], "restarts"), 0u);
    EXPECT_GT(r.outcomes[0].node_visits, visits);
    // No leaf is visited again: what was done is skipped.
    EXPECT_EQ(of_cores(r.outcomes[0], "leaves"), leaves);
    visits = r.outcomes[0].node_visits;
  }
}

/// Many triangles behind each other, whose boxes every ray enters and whose halves most rays miss.
TestScene sheets() {
  Recipe recipe;
  recipe.subdivisions = 1;
  TestScene test = make_scene(recipe);
  traces::Mesh& mesh = test.scene.static_geometry;
  for (int i = 0; i < 400; ++i) {
    const float z = -4.0f + 0.02f * static_cast<float>(i);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (traces::Vec3 p : {traces::Vec3{-4, -2, z}, traces::Vec3{4, -2, z}, traces::Vec3{-4, 3, z}}) {
      mesh.positions.push_back(p);
      mesh.normals.push_back({0, 0, 1});
      mesh.uvs.push_back({0, 0});
      mesh.colors.push_back(0xffffffffu);
    }
    mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
    mesh.materials.push_back(0);
  }
  return test;
}

TEST(RayCoreSettings, SpillingVisitsTheSameNodesAndEveryLineThatIsReadBackWasWritten) {
  const TestScene scene = sheets();
  for (hw::TreeKind kind : kinds) {
    SCOPED_TRACE(static_cast<unsigned>(kind));
    hw::UnitConfig config;
    config.accel.static_kind = config.accel.dynamic_kind = kind;
    const Rendered enough = run(scene, config);
    config.core.stack_overflow = hw::StackOverflow::spill;
    config.core.stack_entries = 8;
    sim::SimulationOptions stalled;
    stalled.random_stall = true;
    const Rendered spilled = run(scene, config);
    expect_exact(spilled);
    expect_exact(run(scene, config, stalled));
    if (kind != hw::TreeKind::kd) {
      EXPECT_GT(of_cores(spilled.outcomes[0], "spilled_lines"), 0u);
    }
    EXPECT_EQ(spilled.outcomes[0].node_visits, enough.outcomes[0].node_visits);
    // What a blocked shadow ray has written it leaves there.
    EXPECT_LE(of_cores(spilled.outcomes[0], "refilled_lines"), of_cores(spilled.outcomes[0], "spilled_lines"));
    EXPECT_EQ(of_cores(enough.outcomes[0], "spilled_lines"), 0u);
  }
}

TEST(RayCoreSettings, AStackThatIsTooSmallIsRefusedUnlessItMayOverflow) {
  const TestScene scene = everything();
  hw::UnitConfig config;
  config.core.stack_entries = 2;
  EXPECT_THROW(run(scene, config), std::runtime_error);
  config.core.stack_overflow = hw::StackOverflow::restart;
  expect_exact(run(scene, config));
}

}  // namespace
}  // namespace artu::golden_tests
