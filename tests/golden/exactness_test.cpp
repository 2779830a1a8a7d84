// Every pixel of the unit is the golden model's, to the bit, whatever the scene, size or configuration.
#include "golden/harness.h"

namespace artu::golden_tests {
namespace {

TEST(Exactness, StaticAndDynamicGeometry) { expect_exact(run(make_scene({}))); }

TEST(Exactness, StaticOnly) {
  Recipe recipe;
  recipe.moving_sphere = false;
  expect_exact(run(make_scene(recipe)));
}

TEST(Exactness, DynamicOnly) {
  Recipe recipe;
  recipe.ground = recipe.static_sphere = false;
  expect_exact(run(make_scene(recipe)));
}

TEST(Exactness, NoGeometryAtAll) {
  Recipe recipe;
  recipe.ground = recipe.static_sphere = recipe.moving_sphere = false;
  const Rendered r = run(make_scene(recipe));
  expect_exact(r);
  EXPECT_EQ(r.outcomes[0].node_visits, 0u);
}

TEST(Exactness, NoLights) {
  Recipe recipe;
  recipe.point_lights = recipe.directional_lights = 0;
  const Rendered r = run(make_scene(recipe));
  expect_exact(r);
  EXPECT_EQ(r.outcomes[0].rays_shadow, 0u);
}

TEST(Exactness, AllLightKinds) {
  Recipe recipe;
  recipe.point_lights = 2;
  recipe.spot_lights = 2;
  expect_exact(run(make_scene(recipe)));
}

TEST(Exactness, AsManyLightsAsThereIsRoomFor) {
  Recipe recipe;
  recipe.width = 8;
  recipe.height = 8;
  recipe.point_lights = 60;
  recipe.spot_lights = 3;
  expect_exact(run(make_scene(recipe)));
  recipe.point_lights = 61;
  EXPECT_THROW(run(make_scene(recipe)), std::runtime_error);
}

TEST(Exactness, MirrorAndGlassAtEveryDepth) {
  Recipe recipe;
  recipe.mirror = recipe.glass = true;
  recipe.subdivisions = 3;
  const TestScene scene = make_scene(recipe);
  std::uint64_t before = 0;
  for (std::uint32_t depth : {0u, 1u, 2u, 5u, 16u}) {
    hw::UnitConfig config;
    config.shading.max_depth = depth;
    const Rendered r = run(scene, config);
    expect_exact(r);
    const std::uint64_t secondary = r.outcomes[0].rays_reflection + r.outcomes[0].rays_refraction;
    if (depth == 0) {
      EXPECT_EQ(secondary, 0u);
    } else {
      EXPECT_GE(secondary, before);
    }
    before = secondary;
  }
  EXPECT_GT(before, 0u);
}

TEST(Exactness, WeightsOfNothingAreStillTracedIfAsked) {
  Recipe recipe;
  recipe.glass = true;
  hw::UnitConfig config;
  config.shading.min_weight = 0;
  expect_exact(run(make_scene(recipe), config));
}

TEST(Exactness, AcrossASequence) {
  Recipe recipe;
  recipe.frames = 4;
  recipe.mirror = true;
  expect_exact(run(make_scene(recipe)));
}

TEST(Exactness, FarFromTheOrigin) {
  for (float offset : {1000.0f, 100000.0f}) {
    Recipe recipe;
    recipe.offset = offset;
    recipe.mirror = recipe.glass = true;
    expect_exact(run(make_scene(recipe)));
  }
}

class OddSizes : public testing::TestWithParam<std::pair<std::uint32_t, std::uint32_t>> {};

TEST_P(OddSizes, AreExact) {
  Recipe recipe;
  std::tie(recipe.width, recipe.height) = GetParam();
  recipe.mirror = true;
  const TestScene scene = make_scene(recipe);
  expect_exact(run(scene));
  hw::UnitConfig config;
  config.selective.enabled = false;
  expect_exact(run(scene, config));
  config.selective.enabled = true;
  config.selective.tile = 4;
  expect_exact(run(scene, config));
}

INSTANTIATE_TEST_SUITE_P(Sizes, OddSizes,
                         testing::Values(std::pair{1u, 1u}, std::pair{2u, 1u}, std::pair{1u, 2u}, std::pair{3u, 5u},
                                         std::pair{5u, 3u}, std::pair{1u, 67u}, std::pair{131u, 1u},
                                         std::pair{16u, 16u}, std::pair{17u, 33u}, std::pair{65u, 31u}));

class Cores : public testing::TestWithParam<std::uint32_t> {};

TEST_P(Cores, DoNotChangeAPixel) {
  Recipe recipe;
  recipe.mirror = recipe.glass = true;
  hw::UnitConfig config;
  config.core.count = GetParam();
  expect_exact(run(make_scene(recipe), config));
}

INSTANTIATE_TEST_SUITE_P(OneToEight, Cores, testing::Range(1u, 9u));

TEST(Exactness, WithTheSmallestUnit) {
  hw::UnitConfig config;
  config.core.count = config.core.contexts = config.core.queue_depth = 1;
  config.core.stack_entries = 24;
  for (hw::CacheConfig* cache : {&config.core.node_cache, &config.core.triangle_cache, &config.core.texture_cache,
                                 &config.selective.pixel_cache, &config.memory.l2}) {
    *cache = {256, 1, 1, 1, 1};
  }
  config.memory.dram.channels = config.memory.dram.banks = config.memory.dram.queue_depth = 1;
  config.memory.interconnect_latency = config.tree_builder.outstanding = 1;
  Recipe recipe;
  recipe.mirror = recipe.glass = true;
  recipe.frames = 2;
  expect_exact(run(make_scene(recipe), config));
}

TEST(Exactness, WithALargeUnit) {
  hw::UnitConfig config;
  config.core.count = 16;
  config.core.contexts = 256;
  config.core.queue_depth = 64;
  config.memory.l2 = {1u << 22, 16, 40, 256, 64};
  config.memory.dram.channels = 8;
  Recipe recipe;
  recipe.mirror = recipe.glass = true;
  expect_exact(run(make_scene(recipe), config));
}

}  // namespace
}  // namespace artu::golden_tests
