// What theory says of a whole core: throughput and latency of independent pixels, and Little's law between them.
#include <gtest/gtest.h>

#include "unit/hw/tiny_frame.h"

namespace artu::hw::test {
namespace {

/// A unit with one core and nothing but sky: every pixel takes the same way, and no memory is read.
struct Sky {
  std::uint64_t first_pass = 0, context_cycles = 0, pixels = 0;
};

Sky sky(std::uint32_t width, std::uint32_t height, std::uint32_t contexts) {
  UnitConfig config;
  config.core.count = 1;
  config.core.contexts = contexts;
  config.core.queue_depth = 16;
  config.selective.enabled = false;
  TinyUnit u(width, height, {}, config);
  u.tiny.frame().static_root = u.tiny.frame().dynamic_root = NodeReference::none;
  u.tiny.frame().dynamic_moved = 0;
  const FrameResult result = u.run();
  EXPECT_THAT(result.violations, testing::IsEmpty());
  return {u.statistic(result, "control_unit", "cycles_first"),
          u.statistic(result, "core0.ray_generator", "context_cycles"), std::uint64_t{width} * height};
}

/// Cycles that 1024 more pixels take.
std::uint64_t of_a_thousand(std::uint32_t contexts) {
  return sky(64, 48, contexts).first_pass - sky(64, 32, contexts).first_pass;
}

/// From a pixel's start to its context's being free again: set-up, root boxes, shading of the sky, channels.
std::uint64_t unloaded_latency() {
  const Sky s = sky(64, 32, 1);
  EXPECT_EQ(s.context_cycles % s.pixels, 0u) << "every pixel takes as long as the others";
  return s.context_cycles / s.pixels;
}

TEST(ClosedForms, WithOneContextPixelsTakeTheirLatencyOneAfterTheOther) {
  EXPECT_EQ(of_a_thousand(1), 1024 * unloaded_latency());
}

TEST(ClosedForms, LittlesLawHoldsForPixelsInFlight) {
  const std::uint64_t latency = unloaded_latency();
  // L = lambda W: with n pixels in flight and an unchanged latency, n of them end in a latency.
  for (std::uint32_t contexts : {2u, 4u, 8u, 16u}) {
    ASSERT_LE(contexts, latency);
    EXPECT_EQ(of_a_thousand(contexts), 1024 / contexts * latency) << contexts;
    EXPECT_EQ(sky(64, 32, contexts).context_cycles, 2048 * latency) << contexts;
  }
}

TEST(ClosedForms, MoreContextsThanTheLatencyGiveOnePixelAnInitiationInterval) {
  const std::uint64_t latency = unloaded_latency();
  ASSERT_LT(latency, 240u);
  EXPECT_EQ(of_a_thousand(static_cast<std::uint32_t>(latency)), 1024u);
  EXPECT_EQ(of_a_thousand(static_cast<std::uint32_t>(latency) + 16), 1024u);
}

}  // namespace
}  // namespace artu::hw::test
