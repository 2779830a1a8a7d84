// Selective rendering against the golden model, for every parameter value, and what it must do to the counts.
#include "golden/harness.h"

namespace artu::golden_tests {
namespace {

const TestScene& scene() {
  static const TestScene scene = [] {
    Recipe recipe;
    recipe.width = 65;
    recipe.height = 47;
    recipe.mirror = true;
    return make_scene(recipe);
  }();
  return scene;
}

std::uint64_t traced(const hw::UnitConfig& config) {
  const Rendered r = run(scene(), config);
  expect_exact(r);
  return counter(r.outcomes[0], "render_executor", "traced");
}

TEST(Selective, EveryMagnitudeIsExact) {
  for (hw::Magnitude magnitude : {hw::Magnitude::fixed, hw::Magnitude::proportional, hw::Magnitude::progressive}) {
    hw::UnitConfig config;
    config.selective.magnitude = magnitude;
    for (std::uint32_t step : {0u, 2u, 9u, 255u}) {
      config.selective.step = step;
      traced(config);
    }
  }
}

TEST(Selective, AHigherReferenceTracesLess) {
  hw::UnitConfig config;
  config.selective.adaptive = false;
  std::uint64_t before = ~std::uint64_t{0};
  for (std::uint32_t reference : {0u, 4u, 16u, 64u, 255u}) {
    config.selective.reference = reference;
    const std::uint64_t now = traced(config);
    EXPECT_LE(now, before) << reference;
    before = now;
  }
  // At 255 nothing but the candidates without a pair is traced; 65 x 47 has none.
  EXPECT_EQ(before, 0u);
}

TEST(Selective, ClampsHold) {
  hw::UnitConfig config;
  config.selective.minimum = 12;
  config.selective.maximum = 20;
  const Rendered r = run(scene(), config);
  expect_exact(r);
  bool low = false, high = false;
  for (const hw::PixelRecord& p : r.outcomes[0].pixels) {
    if (p.pass == 0) continue;
    EXPECT_GE(p.threshold, 12);
    EXPECT_LE(p.threshold, 20);
    low |= p.threshold == 12;
    high |= p.threshold == 20;
  }
  EXPECT_TRUE(low && high) << "the scene does not reach both clamps, so the test shows nothing";
}

TEST(Selective, AttentionLowersTheThresholdAroundDynamicHits) {
  const Rendered r = run(scene());
  for (const hw::PixelRecord& p : r.outcomes[0].pixels) {
    if (p.pass == 0) continue;
    if (p.n_dynamic > p.n_static) {
      EXPECT_LT(p.threshold, 16);
    }
    if (p.n_dynamic < p.n_static) {
      EXPECT_GT(p.threshold, 16);
    }
    if (p.n_dynamic == p.n_static) {
      EXPECT_EQ(p.threshold, 16);
    }
  }
}

TEST(Selective, OffTracesEveryPixelOnce) {
  hw::UnitConfig config;
  config.selective.enabled = false;
  const Rendered r = run(scene(), config);
  expect_exact(r);
  EXPECT_EQ(r.outcomes[0].rays_primary, 65u * 47u);
}

TEST(Selective, ACandidateWithoutAPairIsTraced) {
  Recipe recipe;
  recipe.width = 10;
  recipe.height = 6;
  hw::UnitConfig config;
  config.selective.reference = 255;
  config.selective.adaptive = false;
  const Rendered r = run(make_scene(recipe), config);
  expect_exact(r);
  for (std::uint32_t y = 0; y < 6; ++y) {
    for (std::uint32_t x = 0; x < 10; ++x) {
      const hw::PixelRecord& p = r.outcomes[0].pixels[y * 10 + x];
      const bool border = (y % 2 == 0 && x == 9) || y == 5;
      const hw::Decision expected = x % 2 == 0 && y % 2 == 0 ? hw::Decision::sampled
                                    : border                 ? hw::Decision::traced
                                                             : hw::Decision::interpolated;
      EXPECT_EQ(p.decision, expected) << x << ", " << y;
    }
  }
}

}  // namespace
}  // namespace artu::golden_tests
