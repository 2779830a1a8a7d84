// A test for each value of each parameter of selective rendering: the golden model's bits in images of odd sizes, and
// other records than the default's, so that no parameter is without effect on both sides.
#include "golden/candidates.h"
#include "golden/drawn.h"
#include "hw/selective/policy.h"

namespace artu::golden_tests {
namespace {

using Selective = hw::SelectiveConfig;

std::uint32_t number_of(const std::string& policy) {
  const std::vector<const char*>& names = hw::policy_names();
  const auto found = std::find(names.begin(), names.end(), policy);
  EXPECT_NE(found, names.end()) << policy;
  return static_cast<std::uint32_t>(found - names.begin());
}

struct Setting {
  std::string name;
  void (*change)(Selective&);
};

const Setting settings[] = {
    {"stride_4", [](Selective& s) { s.stride = 4; }},
    {"stride_8", [](Selective& s) { s.stride = 8; }},
    {"passes_average", [](Selective& s) { s.passes = hw::Passes::average; }},
    {"passes_average_of_stride_4",
     [](Selective& s) {
       s.passes = hw::Passes::average;
       s.stride = 4;
     }},
    {"passes_average_of_stride_8",
     [](Selective& s) {
       s.passes = hw::Passes::average;
       s.stride = 8;
     }},
    {"compare_reference_count", [](Selective& s) { s.compare = hw::Compare::reference_count; }},
    {"reference_count_0",
     [](Selective& s) {
       s.compare = hw::Compare::reference_count;
       s.reference_count = 0;
     }},
    {"reference_count_8",
     [](Selective& s) {
       s.compare = hw::Compare::reference_count;
       s.reference_count = 8;
     }},
    {"count_merged",
     [](Selective& s) {
       s.compare = hw::Compare::reference_count;
       s.count = hw::Count::merged;
     }},
    {"magnitude_fixed", [](Selective& s) { s.magnitude = hw::Magnitude::fixed; }},
    {"magnitude_progressive", [](Selective& s) { s.magnitude = hw::Magnitude::progressive; }},
    {"table_of_its_own",
     [](Selective& s) {
       s.magnitude = hw::Magnitude::progressive;
       s.table = {0, 3, 9, 27, 81, 243, 255, 255};
     }},
    {"metric_sum", [](Selective& s) { s.metric = hw::Metric::sum; }},
    {"metric_luma", [](Selective& s) { s.metric = hw::Metric::luma; }},
    {"metric_sum_of_centres",
     [](Selective& s) {
       s.metric = hw::Metric::sum;
       s.passes = hw::Passes::average;
     }},
    {"metric_luma_of_centres",
     [](Selective& s) {
       s.metric = hw::Metric::luma;
       s.passes = hw::Passes::average;
     }},
    {"reference_0", [](Selective& s) { s.reference = 0; }},
    {"reference_255", [](Selective& s) { s.reference = 255; }},
    {"minimum", [](Selective& s) { s.minimum = 15; }},
    {"maximum", [](Selective& s) { s.maximum = 17; }},
    {"minimum_is_maximum", [](Selective& s) { s.minimum = s.maximum = 40; }},
    {"step_0", [](Selective& s) { s.step = 0; }},
    {"step_255", [](Selective& s) { s.step = 255; }},
    {"not_adaptive", [](Selective& s) { s.adaptive = false; }},
    {"not_enabled", [](Selective& s) { s.enabled = false; }},
    {"policy_fixed", [](Selective& s) { s.policy = number_of("fixed"); }},
};

const std::pair<std::uint32_t, std::uint32_t> sizes[] = {{33, 17}, {3, 5}, {7, 1}, {1, 1}};

std::vector<TestScene> scenes() {
  std::vector<TestScene> all;
  for (const auto& [width, height] : sizes) all.push_back(make_scene(attention_recipe(width, height)));
  return all;
}

class SelectiveParameter : public testing::TestWithParam<Setting> {};

TEST_P(SelectiveParameter, IsExactAndMatters) {
  static const std::vector<TestScene> images = scenes();
  static const std::string default_pixels = all_pixels(run(images[0]).outcomes[0]);
  hw::UnitConfig config;
  GetParam().change(config.selective);
  for (const TestScene& image : images) {
    SCOPED_TRACE(std::to_string(image.scene.width) + " x " + std::to_string(image.scene.height));
    const Rendered r = run(image, config);
    expect_exact(r);
    if (&image == &images[0]) {
      EXPECT_NE(all_pixels(r.outcomes[0]), default_pixels) << "no effect";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Value, SelectiveParameter, testing::ValuesIn(settings),
                         [](const auto& of) { return of.param.name; });

TEST(SelectiveParameter, Default) {
  for (const TestScene& image : scenes()) expect_exact(run(image));
}

// The policy `fixed` is the comparison's baseline, which `adaptive = false` is as well.
TEST(SelectiveParameter, FixedIsNotAdaptive) {
  hw::UnitConfig fixed, not_adaptive;
  fixed.selective.policy = number_of("fixed");
  not_adaptive.selective.adaptive = false;
  const TestScene scene = make_scene(attention_recipe(33, 17));
  EXPECT_EQ(all_pixels(run(scene, fixed).outcomes[0]), all_pixels(run(scene, not_adaptive).outcomes[0]));
}

/// A generator of its own, so that the settings are the same everywhere.
struct Draw {
  std::uint32_t state;
  std::uint32_t operator()(std::uint32_t count) {
    state = state * 1664525u + 1013904223u;
    return (state >> 16) % count;
  }
};

TEST(SelectiveParameter, AnyMixtureIsExact) {
  Draw draw{20201215};
  for (int i = 0; i < 60; ++i) {
    Recipe recipe = attention_recipe(1 + draw(40), 1 + draw(24));
    recipe.glass = draw(4) == 0;
    recipe.static_sphere = draw(4) != 0;
    recipe.subdivisions = 1;
    hw::UnitConfig config;
    Selective& s = config.selective;
    draw_comparison(s, draw);
    s.adaptive = draw(8) != 0;
    s.policy = draw(static_cast<std::uint32_t>(hw::policy_names().size()));
    for (std::uint32_t& value : s.policy_registers) value = draw(256);
    s.reference = draw(2) != 0 ? draw(32) : draw(256);
    s.minimum = draw(4) == 0 ? draw(256) : 0;
    s.maximum = draw(4) == 0 ? s.minimum + draw(256 - s.minimum) : 255;
    s.step = draw(4) == 0 ? draw(256) : draw(6);
    for (std::uint32_t& value : s.table) value = draw(256);
    s.tile = s.stride > 4 ? 8u << draw(3) : 4u << draw(4);
    const Rendered r = run(make_scene(recipe), config);
    expect_exact(r);
    if (testing::Test::HasFailure()) FAIL() << "setting " << i;
  }
}

}  // namespace
}  // namespace artu::golden_tests
