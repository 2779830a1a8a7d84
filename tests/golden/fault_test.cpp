// The check can fail: one inverted bit in each datapath, and the right field is named.
#include "golden/harness.h"

namespace artu::golden_tests {
namespace {

sim::CheckResult check_with(hw::Datapath datapath, std::uint32_t bit, const hw::UnitConfig& config = {}) {
  Recipe recipe;
  recipe.mirror = true;
  sim::SimulationOptions options;
  options.fault = {datapath, bit};
  return run(make_scene(recipe), config, options).check;
}

bool differs(const sim::CheckResult& check, sim::PixelField field) {
  return check.differing_fields[static_cast<std::size_t>(field)] != 0;
}

TEST(Fault, NoneIsSeenWhereThereIsNone) { EXPECT_TRUE(check_with(hw::Datapath::none, 0).passed()); }

TEST(Fault, BoxSignBitLosesHits) {
  const sim::CheckResult check = check_with(hw::Datapath::box, 31);
  ASSERT_FALSE(check.passed());
  EXPECT_TRUE(differs(check, sim::PixelField::hit_class));
  EXPECT_TRUE(differs(check, sim::PixelField::primitive));
  EXPECT_NE(sim::describe(check).find("class"), std::string::npos);
}

TEST(Fault, TriangleLastBitOfTChangesOnlyT) {
  Recipe recipe;
  recipe.static_sphere = recipe.moving_sphere = false;
  sim::SimulationOptions options;
  options.fault = {hw::Datapath::triangle, 0};
  const sim::CheckResult check = run(make_scene(recipe), {}, options).check;
  ASSERT_FALSE(check.passed());
  EXPECT_TRUE(differs(check, sim::PixelField::t_bits));
  EXPECT_FALSE(differs(check, sim::PixelField::color));
  EXPECT_FALSE(differs(check, sim::PixelField::primitive));
  EXPECT_NE(sim::describe(check).find("t_bits"), std::string::npos);
}

TEST(Fault, ShadingBitChangesColour) {
  hw::UnitConfig config;
  config.selective.enabled = false;  // or other colours lead to other decisions, and those to other classes
  const sim::CheckResult check = check_with(hw::Datapath::shading, 0, config);
  ASSERT_FALSE(check.passed());
  EXPECT_TRUE(differs(check, sim::PixelField::color));
  EXPECT_FALSE(differs(check, sim::PixelField::t_bits));
  EXPECT_FALSE(differs(check, sim::PixelField::hit_class));
}

TEST(Fault, InterpolationBitChangesOnlyInterpolatedPixels) {
  const sim::CheckResult check = check_with(hw::Datapath::interpolation, 0);
  ASSERT_FALSE(check.passed());
  EXPECT_TRUE(differs(check, sim::PixelField::color));
  ASSERT_TRUE(check.first.has_value());
  EXPECT_EQ(check.first->golden.decision, ref::Decision::interpolated);
}

TEST(Fault, ThresholdBitChangesTheThreshold) {
  hw::UnitConfig config;
  config.selective.adaptive = false;  // 255 becomes 254: no decision changes, so no count does
  config.selective.reference = 255;
  const sim::CheckResult check = check_with(hw::Datapath::threshold, 0, config);
  ASSERT_FALSE(check.passed());
  EXPECT_TRUE(differs(check, sim::PixelField::threshold));
  EXPECT_FALSE(differs(check, sim::PixelField::n_static));
  EXPECT_NE(sim::describe(check).find("threshold"), std::string::npos);
}

}  // namespace
}  // namespace artu::golden_tests
