// Every format of box test, triangle test and shading: the unit is the golden model's, to the bit.
#include "golden/harness.h"

namespace artu::golden_tests {
namespace {

hw::UnitConfig unit_with(unsigned box, unsigned triangle, unsigned shading) {
  hw::UnitConfig config;
  config.precision = {box, triangle, shading};
  return config;
}

Recipe everything() {
  Recipe recipe;
  recipe.mirror = recipe.glass = true;
  recipe.subdivisions = 3;
  recipe.spot_lights = 1;
  return recipe;
}

class Width : public testing::TestWithParam<unsigned> {};

TEST_P(Width, OfAllDatapathsIsExact) {
  expect_exact(run(make_scene(everything()), unit_with(GetParam(), GetParam(), GetParam())));
}

TEST_P(Width, OfOneDatapathIsExact) {
  const TestScene scene = make_scene(everything());
  expect_exact(run(scene, unit_with(GetParam(), 23, 23)));
  expect_exact(run(scene, unit_with(23, GetParam(), 23)));
  expect_exact(run(scene, unit_with(23, 23, GetParam())));
}

INSTANTIATE_TEST_SUITE_P(Every, Width, testing::Range(7u, 24u));

TEST(Formats, PairsOfWidthsAreExactFarFromTheOriginAndForEveryTree) {
  Recipe recipe = everything();
  recipe.offset = 100;
  const TestScene scene = make_scene(recipe);
  for (const auto& [box, triangle, shading] :
       {std::array{7u, 12u, 9u}, {12u, 7u, 23u}, {16u, 15u, 10u}, {22u, 23u, 8u}}) {
    std::string pixels;
    for (hw::TreeKind kind : {hw::TreeKind::bvh2, hw::TreeKind::bvh4, hw::TreeKind::bvh8, hw::TreeKind::kd}) {
      hw::UnitConfig config = unit_with(box, triangle, shading);
      config.accel.static_kind = config.accel.dynamic_kind = kind;
      const Rendered r = run(scene, config);
      expect_exact(r);
      if (pixels.empty()) pixels = all_pixels(r.outcomes[0]);
      EXPECT_EQ(all_pixels(r.outcomes[0]), pixels);
    }
  }
}

TEST(Formats, EachDatapathChangesPixels) {
  const TestScene scene = make_scene(everything());
  const std::string wide = all_pixels(run(scene).outcomes[0]);
  EXPECT_NE(all_pixels(run(scene, unit_with(7, 23, 23)).outcomes[0]), wide);
  EXPECT_NE(all_pixels(run(scene, unit_with(23, 7, 23)).outcomes[0]), wide);
  EXPECT_NE(all_pixels(run(scene, unit_with(23, 23, 7)).outcomes[0]), wide);
}

}  // namespace
}  // namespace artu::golden_tests
