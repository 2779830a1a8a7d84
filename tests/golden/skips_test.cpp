// Work that a frame does not need: left out or done, the same pixels to the bit, and the saving is counted.
#include "golden/harness.h"

namespace artu::golden_tests {
namespace {

struct Skip {
  const char* name;
  bool hw::SkipConfig::*flag;
  const char *block, *counter;  // of what was left out; a core's block without the core's number
};
constexpr Skip skips[] = {
    {"dynamic_root", &hw::SkipConfig::dynamic_root, "traversal", "dynamic_skipped"},
    {"rebuild", &hw::SkipConfig::rebuild, "control_unit", "builds_skipped"},
    {"shadow", &hw::SkipConfig::shadow, "shading", "lights_skipped"},
    {"texture", &hw::SkipConfig::texture, "shading", "textures_skipped"},
    {"any_hit", &hw::SkipConfig::any_hit, "traversal", "cut_short"},
};

/// Mirrors, glass, lights that reach a part alone; nothing moves in the second frame.
TestScene everything() {
  Recipe recipe;
  recipe.mirror = recipe.glass = true;
  recipe.frames = 2;
  recipe.spot_lights = 1;
  TestScene test = make_scene(recipe);
  test.frames[1].dynamic = test.frames[0].dynamic;
  test.frames[1].dynamic_moved = false;
  return test;
}

std::uint64_t sum(const Rendered& run, const std::string& block, const std::string& name) {
  std::uint64_t total = 0;
  for (const sim::FrameOutcome& outcome : run.outcomes) {
    for (const hw::Statistic& s : outcome.statistics) {
      const std::size_t at = s.block.size() < block.size() ? 0 : s.block.size() - block.size();
      if (s.name == name && s.block.compare(at, std::string::npos, block) == 0) total += s.value;
    }
  }
  return total;
}

void expect_same_pixels(const Rendered& a, const Rendered& b) {
  for (std::size_t f = 0; f < a.outcomes.size(); ++f) {
    EXPECT_TRUE(all_pixels(a.outcomes[f]) == all_pixels(b.outcomes[f])) << "frame " << f;
  }
}

class Skips : public testing::TestWithParam<hw::TreeKind> {
 protected:
  Skips() { config_.accel.static_kind = config_.accel.dynamic_kind = GetParam(); }
  hw::UnitConfig config_;
  const TestScene scene_ = everything();
};

TEST_P(Skips, EachAloneAndAllTogetherChangeNoPixel) {
  const Rendered on = run(scene_, config_);
  expect_exact(on);
  hw::UnitConfig none = config_;
  for (const Skip& skip : skips) {
    SCOPED_TRACE(skip.name);
    hw::UnitConfig config = config_;
    config.skip.*skip.flag = none.skip.*skip.flag = false;
    const Rendered off = run(scene_, config);
    expect_exact(off);
    expect_same_pixels(on, off);
    EXPECT_GT(sum(on, skip.block, skip.counter), 0u);
    if (skip.flag == &hw::SkipConfig::shadow) continue;  // there may be no ray towards a light
    EXPECT_EQ(sum(off, skip.block, skip.counter), 0u);
  }
  const Rendered all_off = run(scene_, none);
  expect_exact(all_off);
  expect_same_pixels(on, all_off);
  EXPECT_GT(all_off.outcomes[0].cycles, on.outcomes[0].cycles);
  EXPECT_GT(all_off.outcomes[1].cycles, on.outcomes[1].cycles);
}

TEST_P(Skips, WithoutThemThereIsMoreToDo) {
  const Rendered on = run(scene_, config_);
  const auto without = [&](bool hw::SkipConfig::*flag) {
    hw::UnitConfig config = config_;
    config.skip.*flag = false;
    return run(scene_, config);
  };
  const auto visits = [](const Rendered& r) { return r.outcomes[0].node_visits + r.outcomes[1].node_visits; };
  EXPECT_GT(visits(without(&hw::SkipConfig::dynamic_root)), visits(on));
  const Rendered rebuilt = without(&hw::SkipConfig::rebuild);
  EXPECT_EQ(sum(on, "tree_builder", "builds"), 1u);
  EXPECT_EQ(sum(rebuilt, "tree_builder", "builds"), 2u);
  EXPECT_EQ(rebuilt.outcomes[0].cycles, on.outcomes[0].cycles);
  EXPECT_GT(rebuilt.outcomes[1].cycles, on.outcomes[1].cycles);
  const Rendered shadows = without(&hw::SkipConfig::shadow);
  EXPECT_EQ(shadows.outcomes[0].rays_shadow - on.outcomes[0].rays_shadow,
            (sum(on, "shading", "lights_skipped") - sum(shadows, "shading", "lights_skipped")) / 2);
  const Rendered textures = without(&hw::SkipConfig::texture);
  const auto looks = [](const Rendered& r) {
    return sum(r, "texture_cache", "hits") + sum(r, "texture_cache", "misses");
  };
  EXPECT_EQ(looks(textures), looks(on) + sum(on, "shading", "textures_skipped"));
  const Rendered nearest = without(&hw::SkipConfig::any_hit);
  EXPECT_EQ(sum(nearest, "intersection", "left_out"), 0u);
  EXPECT_GT(nearest.outcomes[0].triangle_tests, on.outcomes[0].triangle_tests);
}

INSTANTIATE_TEST_SUITE_P(Trees, Skips,
                         testing::Values(hw::TreeKind::bvh2, hw::TreeKind::bvh4, hw::TreeKind::bvh8, hw::TreeKind::kd));

TEST(SkipsWithout, DynamicGeometryThereIsNothingToEnterOrToBuild) {
  Recipe recipe;
  recipe.moving_sphere = false;
  const TestScene scene = make_scene(recipe);
  const Rendered on = run(scene);
  hw::UnitConfig config;
  config.skip.dynamic_root = config.skip.rebuild = false;
  const Rendered off = run(scene, config);
  expect_exact(off);
  EXPECT_EQ(on.outcomes[0].cycles, off.outcomes[0].cycles);
  EXPECT_EQ(counter(on.outcomes[0], "control_unit", "builds_skipped"), 0u);
}

}  // namespace
}  // namespace artu::golden_tests
