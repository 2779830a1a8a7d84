// The plan of the passes: every pixel in exactly one, and what a pass needs finished before it.
#include "hw/selective/pass_plan.h"

#include <gtest/gtest.h>

#include <vector>

#include "unit/hw/every_plan.h"

namespace artu::hw::test {
namespace {

SelectiveConfig with(std::uint32_t stride, Passes passes) {
  SelectiveConfig config;
  config.stride = stride;
  config.passes = passes;
  return config;
}

template <class Test>
void for_every_plan(const Test& test) {
  for_every_stride_and_passes([&test](std::uint32_t stride, Passes passes) { test(PassPlan(with(stride, passes))); });
}

TEST(PassPlan, HasTwoOrThreePassesALevel) {
  EXPECT_EQ(PassPlan(with(2, Passes::horizontal_vertical)).passes(), 3u);
  EXPECT_EQ(PassPlan(with(4, Passes::horizontal_vertical)).passes(), 5u);
  EXPECT_EQ(PassPlan(with(8, Passes::horizontal_vertical)).passes(), 7u);
  EXPECT_EQ(PassPlan(with(2, Passes::average)).passes(), 4u);
  EXPECT_EQ(PassPlan(with(4, Passes::average)).passes(), 7u);
  EXPECT_EQ(PassPlan(with(8, Passes::average)).passes(), 10u);
  SelectiveConfig off = with(8, Passes::average);
  off.enabled = false;
  EXPECT_EQ(PassPlan(off).passes(), 1u);
  EXPECT_EQ(PassPlan(off).stride(), 1u);
  EXPECT_EQ(PassPlan(off).pass_of(3, 5), 0u);
}

TEST(PassPlan, PassesAreThoseOfTheTables) {
  const auto expect = [](const Pass& p, std::uint32_t h, PassKind kind, const std::vector<std::uint32_t>& grid) {
    EXPECT_EQ(p.h, h);
    EXPECT_EQ(p.kind, kind);
    EXPECT_EQ((std::vector<std::uint32_t>{p.x0, p.dx, p.y0, p.dy}), grid);
  };
  const PassPlan figure4(with(4, Passes::horizontal_vertical)), average(with(4, Passes::average));
  expect(figure4.pass(1), 2, PassKind::horizontal, {2, 4, 0, 4});
  expect(figure4.pass(2), 2, PassKind::vertical, {0, 2, 2, 4});
  expect(figure4.pass(3), 1, PassKind::horizontal, {1, 2, 0, 2});
  expect(figure4.pass(4), 1, PassKind::vertical, {0, 1, 1, 2});
  expect(average.pass(2), 2, PassKind::vertical, {0, 4, 2, 4});
  expect(average.pass(3), 2, PassKind::centre, {2, 4, 2, 4});
  expect(average.pass(6), 1, PassKind::centre, {1, 2, 1, 2});
}

void expect_each_once(const PassPlan& plan, std::uint32_t width, std::uint32_t height, std::uint32_t tile) {
  std::vector<std::uint8_t> count(std::size_t{width} * height);
  for (std::uint32_t number = 0; number < plan.passes(); ++number) {
    TileWalk walk = plan.walk(number, width, height, tile);
    std::uint64_t pixels = 0;
    for (; !walk.done(); walk.next()) {
      const TileWalk::Span span = walk.span();
      for (std::uint32_t x = span.begin; x < span.end; x += walk.dx(), ++pixels) {
        ASSERT_LT(x, width);
        ASSERT_LT(span.y, height);
        ++count[std::size_t{span.y} * width + x];
        ASSERT_EQ(plan.pass_of(x, span.y), number) << x << ", " << span.y;
      }
    }
    ASSERT_EQ(walk.pixels(), pixels);
  }
  ASSERT_EQ(count, std::vector<std::uint8_t>(count.size(), 1)) << width << " x " << height << ", tile " << tile;
}

TEST(PassPlan, EveryPixelIsInExactlyOnePass) {
  for_every_plan([](const PassPlan& plan) {
    for (const auto& [width, height] :
         {std::pair<std::uint32_t, std::uint32_t>{1, 1}, {3, 5}, {7, 1}, {1, 7}, {16, 16}, {33, 7}, {2, 9}, {17, 65}}) {
      for (std::uint32_t tile : {8u, 16u, 64u}) expect_each_once(plan, width, height, tile);
      if (plan.stride() <= 4) expect_each_once(plan, width, height, 4);
    }
    expect_each_once(plan, 1921, 1081, 16);
  });
}

TEST(PassPlan, TheNeighboursOfAPassThatAreFinishedAreTheSameEverywhere) {
  for_every_plan([](const PassPlan& plan) {
    constexpr std::uint32_t edge = 40;
    for (std::uint32_t y = 8; y < edge; ++y) {
      for (std::uint32_t x = 8; x < edge; ++x) {
        const std::uint32_t number = plan.pass_of(x, y);
        if (number == 0) continue;
        const Pass pass = plan.pass(number);
        unsigned finished = 0, i = 0;
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            if (dx == 0 && dy == 0) continue;
            const auto h = static_cast<int>(pass.h);
            const auto nx = static_cast<std::uint32_t>(static_cast<int>(x) + dx * h);
            const auto ny = static_cast<std::uint32_t>(static_cast<int>(y) + dy * h);
            if (plan.pass_of(nx, ny) < number) finished |= 1u << i;
            ++i;
          }
        }
        ASSERT_EQ(pass.finished_neighbours(), finished) << "pass " << number << " at " << x << ", " << y;
        // The pairs are among them.
        const unsigned compared = (pass.compares_rows() ? 0x18u : 0) | (pass.compares_columns() ? 0x42u : 0);
        ASSERT_EQ(finished & compared, compared);
      }
    }
  });
}

}  // namespace
}  // namespace artu::hw::test
