// The walk visits each pixel of its grid exactly once, tile by tile.
#include "hw/selective/tile_walk.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace artu::hw::test {
namespace {

struct Pixel {
  std::uint32_t x, y;
  bool operator==(const Pixel& o) const { return x == o.x && y == o.y; }
};

std::vector<Pixel> visited(TileWalk walk) {
  std::vector<Pixel> pixels;
  for (; !walk.done(); walk.next()) {
    const TileWalk::Span span = walk.span();
    EXPECT_LT(span.begin, span.end) << "no empty span";
    for (std::uint32_t x = span.begin; x < span.end; x += walk.dx()) pixels.push_back({x, span.y});
  }
  return pixels;
}

struct Grid {
  std::uint32_t x0, dx, y0, dy;
};
const Grid grids[] = {{0, 1, 0, 1}, {0, 2, 0, 2}, {1, 2, 0, 2}, {0, 1, 1, 2}, {0, 4, 0, 4}, {2, 4, 2, 4}, {0, 2, 2, 4}};

void expect_each_once(std::uint32_t width, std::uint32_t height, std::uint32_t tile) {
  for (const Grid& g : grids) {
    const TileWalk walk(width, height, tile, g.x0, g.dx, g.y0, g.dy);
    std::vector<int> count(std::size_t{width} * height);
    const auto pixels = visited(walk);
    for (const Pixel& p : pixels) {
      ASSERT_LT(p.x, width);
      ASSERT_LT(p.y, height);
      ++count[p.y * width + p.x];
    }
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        const bool of_grid = x % g.dx == g.x0 % g.dx && x >= g.x0 && y % g.dy == g.y0 % g.dy && y >= g.y0;
        ASSERT_EQ(count[y * width + x], of_grid ? 1 : 0) << width << "x" << height << " tile " << tile << " grid "
                                                         << g.x0 << g.dx << g.y0 << g.dy << ": " << x << "," << y;
      }
    }
    ASSERT_EQ(walk.pixels(), pixels.size());
  }
}

TEST(TileWalk, VisitsEachPixelOnceInSmallImages) {
  for (std::uint32_t tile : {4u, 8u, 16u}) {
    for (std::uint32_t width = 1; width <= 19; ++width) {
      for (std::uint32_t height = 1; height <= 19; ++height) expect_each_once(width, height, tile);
    }
  }
}

TEST(TileWalk, VisitsEachPixelOnceInLargeImages) {
  expect_each_once(1921, 1081, 16);
  expect_each_once(1921, 1081, 256);
  expect_each_once(1, 3000, 4);
  expect_each_once(3000, 1, 4);
}

TEST(TileWalk, GoesTileByTileRowByRowFromLeftToRight) {
  const auto pixels = visited(TileWalk(6, 6, 4, 0, 2, 0, 2));
  const std::vector<Pixel> expected{{0, 0}, {2, 0}, {0, 2}, {2, 2}, {4, 0}, {4, 2}, {0, 4}, {2, 4}, {4, 4}};
  EXPECT_EQ(pixels, expected);
}

TEST(TileWalk, AWalkWithoutPixelsIsDoneAtOnce) {
  EXPECT_TRUE(TileWalk(1, 9, 16, 1, 2, 0, 2).done());
  EXPECT_TRUE(TileWalk(40, 1, 16, 0, 1, 1, 2).done());
  EXPECT_EQ(TileWalk(1, 9, 16, 1, 2, 0, 2).pixels(), 0u);
}

}  // namespace
}  // namespace artu::hw::test
