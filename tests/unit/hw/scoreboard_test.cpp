// The scoreboard: a tile's pass is finished when colour and class of all its pixels have arrived, and not before.
#include "hw/selective/scoreboard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace artu::hw::test {
namespace {

struct Board {
  Board(std::uint32_t width, std::uint32_t height, std::uint32_t tile, SelectiveConfig config = {})
      : plan(config), board(plan, tile), tile(tile) {
    frame.width = width;
    frame.height = height;
    frame.pitch = (width + 63) / 64 * 64;
    frame.frame_buffer = 0x10000;
    frame.hit_classes = frame.frame_buffer + std::uint64_t{frame.pitch} * height * 4;
    board.begin(frame);
  }
  std::uint64_t index(std::uint32_t x, std::uint32_t y) const { return std::uint64_t{y} * frame.pitch + x; }
  void color(std::uint32_t x, std::uint32_t y) {
    const Address a = frame.frame_buffer + index(x, y) * 4;
    board.count({line_of(a), std::uint64_t{0xf} << (a % line_bytes)});
  }
  void hit_class(std::uint32_t x, std::uint32_t y) {
    const Address a = frame.hit_classes + index(x, y);
    board.count({line_of(a), std::uint64_t{1} << (a % line_bytes)});
  }
  bool finished(std::uint32_t pass, std::uint32_t x, std::uint32_t y) const {
    return board.finished_before(pass, {x, x, y, y});
  }
  FrameDescriptor frame{};
  const PassPlan plan;
  Scoreboard board;
  const std::uint32_t tile;
};

TEST(Scoreboard, ATileIsFinishedWithItsLastColourAndClass) {
  Board b(32, 32, 8);
  for (std::uint32_t y = 8; y < 16; y += 2) {
    for (std::uint32_t x = 16; x < 24; x += 2) {
      EXPECT_FALSE(b.finished(1, 16, 8));
      b.hit_class(x, y);
      EXPECT_FALSE(b.finished(1, 23, 15));
      b.color(x, y);
    }
  }
  EXPECT_TRUE(b.finished(1, 16, 8));
  EXPECT_TRUE(b.finished(1, 23, 15));
  EXPECT_FALSE(b.finished(2, 16, 8));
  EXPECT_FALSE(b.finished(1, 15, 8)) << "another tile";
  EXPECT_FALSE(b.board.finished_before(1, {16, 24, 8, 8})) << "looks into the next one";
}

TEST(Scoreboard, ALineCountsForAllTilesThatItCrosses) {
  Board b(64, 4, 4);
  for (std::uint32_t y : {0u, 2u}) {
    b.board.count({b.frame.hit_classes + b.index(0, y), 0x5555555555555555u});
    for (std::uint32_t x = 0; x < 64; x += 16) {
      b.board.count({b.frame.frame_buffer + b.index(x, y) * 4, 0x0f0f0f0f0f0f0f0fu});
    }
  }
  EXPECT_TRUE(b.board.finished_before(1, {0, 63, 0, 3}));
}

TEST(Scoreboard, EveryPassOfEveryTileIsFinishedWithItsLastPixelInAnyOrder) {
  for (std::uint32_t stride : {2u, 4u, 8u}) {
    for (Passes passes : {Passes::horizontal_vertical, Passes::average}) {
      SelectiveConfig config;
      config.stride = stride;
      config.passes = passes;
      Board b(37, 21, 8, config);
      std::mt19937 random(stride);
      for (std::uint32_t top = 0; top < 21; top += 8) {
        for (std::uint32_t left = 0; left < 37; left += 8) {
          for (std::uint32_t pass = 0; pass + 1 < b.plan.passes(); ++pass) {
            std::vector<std::pair<std::uint32_t, std::uint32_t>> pixels;
            for (std::uint32_t y = top; y < std::min(top + 8, 21u); ++y) {
              for (std::uint32_t x = left; x < std::min(left + 8, 37u); ++x) {
                if (b.plan.pass_of(x, y) == pass) pixels.emplace_back(x, y);
              }
            }
            std::shuffle(pixels.begin(), pixels.end(), random);
            for (const auto& [x, y] : pixels) {
              ASSERT_FALSE(b.finished(pass + 1, left, top));
              b.color(x, y);
              ASSERT_FALSE(b.finished(pass + 1, left, top));
              b.hit_class(x, y);
            }
            ASSERT_TRUE(b.finished(pass + 1, left, top)) << left << ", " << top << " pass " << pass;
          }
        }
      }
    }
  }
}

TEST(Scoreboard, TakesACounterATile) {
  EXPECT_EQ(Board(640, 360, 16).board.bytes(), 40u * 23 * 9 / 8);
  EXPECT_EQ(Board(1920, 1080, 16).board.bytes(), 120u * 68 * 9 / 8);
  EXPECT_EQ(Board(64, 64, 4).board.bytes(), 256u * 5 / 8);
  EXPECT_EQ(Board(1, 1, 4).board.bytes(), 1u);
}

}  // namespace
}  // namespace artu::hw::test
