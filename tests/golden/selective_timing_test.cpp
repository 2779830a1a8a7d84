// Results follow from the order of passes and never from timing: stalls, cores, tiles and their order change cycles
// and no pixel, at every stride and in both orders of passes.
#include "golden/candidates.h"

namespace artu::golden_tests {
namespace {

struct Order {
  const char* name;
  std::uint32_t stride;
  hw::Passes passes;
};

class SelectiveTiming : public testing::TestWithParam<Order> {
 protected:
  hw::UnitConfig config() const {
    hw::UnitConfig config;
    config.selective.stride = GetParam().stride;
    config.selective.passes = GetParam().passes;
    return config;
  }
  void expect_same_pixels(const hw::UnitConfig& config, const sim::SimulationOptions& options = {}) const {
    const Rendered r = run(scene, config, options);
    expect_exact(r);
    EXPECT_EQ(all_pixels(r.outcomes[0]), pixels);
  }

  const TestScene scene = make_scene(attention_recipe(41, 27));
  const std::string pixels = all_pixels(run(scene, config()).outcomes[0]);
};

TEST_P(SelectiveTiming, RandomStallsAndOrders) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    sim::SimulationOptions options;
    options.random_stall = true;
    options.shuffle_ticks = seed % 2 == 0;
    if (seed % 3 == 0) options.fidelity = sim::Fidelity::clocked;
    options.seed = seed;
    expect_same_pixels(config(), options);
  }
}

TEST_P(SelectiveTiming, PassesOneByOne) {
  hw::UnitConfig changed = config();
  changed.selective.overlap = false;
  expect_same_pixels(changed);
}

TEST_P(SelectiveTiming, OneToEightCores) {
  for (std::uint32_t cores = 1; cores <= 8; ++cores) {
    SCOPED_TRACE(cores);
    hw::UnitConfig changed = config();
    changed.core.count = cores;
    expect_same_pixels(changed);
  }
}

TEST_P(SelectiveTiming, TilesOfAnySizeAndOrder) {
  for (std::uint32_t tile = std::max(4u, GetParam().stride); tile <= 64; tile *= 2) {
    for (hw::PixelOrder order : {hw::PixelOrder::rows, hw::PixelOrder::morton}) {
      SCOPED_TRACE(tile);
      hw::UnitConfig changed = config();
      changed.selective.tile = tile;
      changed.core.pixel_order = order;
      expect_same_pixels(changed);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Order, SelectiveTiming,
                         testing::Values(Order{"stride_2_average", 2, hw::Passes::average},
                                         Order{"stride_4", 4, hw::Passes::horizontal_vertical},
                                         Order{"stride_4_average", 4, hw::Passes::average},
                                         Order{"stride_8", 8, hw::Passes::horizontal_vertical},
                                         Order{"stride_8_average", 8, hw::Passes::average}),
                         [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace artu::golden_tests
