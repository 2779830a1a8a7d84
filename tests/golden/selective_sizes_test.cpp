// Strides and pass orders on images of any size: no pixel is lost or written twice, and what is smooth is not traced.
#include "golden/candidates.h"

namespace artu::golden_tests {
namespace {

constexpr std::uint32_t strides[] = {2, 4, 8};
constexpr hw::Passes orders[] = {hw::Passes::horizontal_vertical, hw::Passes::average};

hw::UnitConfig config_of(std::uint32_t stride, hw::Passes passes) {
  hw::UnitConfig config;
  config.selective.stride = stride;
  config.selective.passes = passes;
  return config;
}

/// All that can be seen shines with one colour, and there is nothing else to it.
TestScene uniform(std::uint32_t width, std::uint32_t height) {
  TestScene scene = make_scene(attention_recipe(width, height));
  const traces::Vec3 color{0.2f, 0.4f, 0.1f}, none{};
  for (traces::Material& material : scene.scene.materials) {
    material.diffuse = material.specular = material.mirror = none;
    material.emission = color;
  }
  traces::Frame& frame = scene.frames[0];
  frame.sky_nadir = frame.sky_zenith = color;
  return scene;
}

class SelectiveSizes : public testing::TestWithParam<std::tuple<std::uint32_t, hw::Passes>> {
 protected:
  const std::uint32_t stride = std::get<0>(GetParam());
  const hw::UnitConfig config = config_of(stride, std::get<1>(GetParam()));
};

TEST_P(SelectiveSizes, NoPixelIsLostOrWrittenTwice) {
  for (std::uint32_t height = 1; height <= 17; ++height) {
    for (std::uint32_t width = 1; width <= 17; ++width) {
      Recipe recipe = attention_recipe(width, height);
      recipe.mirror = false;
      recipe.subdivisions = 1;
      const Rendered r = run(make_scene(recipe), config);
      ASSERT_TRUE(r.check.passed()) << width << " x " << height << "\n" << sim::describe(r.check);
      for (const hw::PixelRecord& p : r.outcomes[0].pixels) ASSERT_EQ(p.written, 1) << width << " x " << height;
    }
  }
}

TEST_P(SelectiveSizes, OfASmoothSceneTheSamplingPixelsAndTheBorderAreTraced) {
  for (const auto& [width, height] : {std::pair{64u, 32u}, {33u, 49u}, {30u, 31u}}) {
    const Rendered r = run(uniform(width, height), config);
    expect_exact(r);
    std::uint64_t traced = 0;
    for (const SeenCandidate& c : candidates_of(r.outcomes[0], config.selective)) {
      EXPECT_EQ(c.record.decision == hw::Decision::traced, c.pairs.empty()) << at_text(c.x, c.y);
      traced += c.pairs.empty();
    }
    const std::uint64_t samples = std::uint64_t{(width + stride - 1) / stride} * ((height + stride - 1) / stride);
    EXPECT_EQ(r.outcomes[0].rays_primary, samples + traced);
  }
}

// What a record says follows from the records of earlier passes, at every level.
TEST_P(SelectiveSizes, RecordsAgreeWithEachOther) {
  const Rendered r = run(make_scene(attention_recipe(61, 43)), config);
  expect_exact(r);
  int centres = 0;
  for (const SeenCandidate& c : candidates_of(r.outcomes[0], config.selective)) {
    SCOPED_TRACE(at_text(c.x, c.y));
    EXPECT_EQ(c.record.n_static, c.n_static);
    EXPECT_EQ(c.record.n_dynamic, c.n_dynamic);
    int difference = c.pairs.empty() ? -1 : 0;
    int sum = 0;
    for (const auto& [a, b] : c.pairs) {
      EXPECT_LT(std::max(a->pass, b->pass), c.record.pass);
      difference += channel_difference(*a, *b);
      sum += a->r + b->r;
    }
    EXPECT_EQ(c.record.difference, difference);
    const int count = static_cast<int>(c.pairs.size());
    const bool interpolated = count > 0 && difference <= count * c.record.threshold;
    EXPECT_EQ(c.record.decision, interpolated ? hw::Decision::interpolated : hw::Decision::traced);
    if (interpolated) {
      EXPECT_EQ(c.record.r, (sum + count) / (2 * count));
    }
    centres += count == 2;
  }
  EXPECT_EQ(centres > 0, config.selective.passes == hw::Passes::average);
}

// Without a border: 25 %, 6.25 % and 1.56 % of the pixels in the limit of a large image.
TEST_P(SelectiveSizes, TheTracedShareFallsWithTheSquareOfTheStride) {
  for (std::uint32_t size : {17u, 33u, 65u}) {
    const Rendered r = run(uniform(size, size), config);
    expect_exact(r);
    const std::uint64_t along = (size - 1) / stride + 1;
    EXPECT_EQ(r.outcomes[0].rays_primary, along * along) << size;
  }
}

INSTANTIATE_TEST_SUITE_P(Stride, SelectiveSizes,
                         testing::Combine(testing::ValuesIn(strides), testing::ValuesIn(orders)), [](const auto& of) {
                           const bool average = std::get<1>(of.param) == hw::Passes::average;
                           return std::to_string(std::get<0>(of.param)) + (average ? "_average" : "");
                         });

}  // namespace
}  // namespace artu::golden_tests
