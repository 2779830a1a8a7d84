// The first rendering unit: which pixels, in which order, when.
#include "hw/selective/first_rendering_unit.h"

#include <gtest/gtest.h>

#include "unit/hw/support.h"

namespace artu::hw::test {
namespace {

struct First {
  First(std::uint32_t width, std::uint32_t height, std::uint32_t tile)
      : unit(bench.block<FirstRenderingUnit>("unit", config(tile), registers)),
        command(bench.block<Source<PassCommand>>("command", commands)),
        sink(bench.block<Sink<PixelJob>>("sink", jobs)) {
    registers.descriptor.width = width;
    registers.descriptor.height = height;
    commands.bind(command, unit);
    jobs.bind(unit, sink);
    unit.bind(commands, jobs);
  }
  static SelectiveConfig config(std::uint32_t tile) {
    SelectiveConfig config;
    config.tile = tile;
    return config;
  }
  Bench bench;
  FrameRegisters registers;
  Fifo<PassCommand>& commands = bench.fifo<PassCommand>("commands", 2);
  Fifo<PixelJob>& jobs = bench.fifo<PixelJob>("jobs", 4);
  FirstRenderingUnit& unit;
  Source<PassCommand>& command;
  Sink<PixelJob>& sink;
};

TEST(FirstRenderingUnit, SendsOnePixelACycleFromTheCycleAfterItsCommand) {
  First f(64, 64, 16);
  f.command.push_at(9, {0, 2});
  f.bench.run(2000);
  // Command in 10, the first pixel leaves in 11 and arrives in 12; no gap between spans and tiles.
  EXPECT_EQ(f.sink.cycles, every(12, 32 * 32));
}

TEST(FirstRenderingUnit, TakesEverySecondPixelOfEverySecondRowTileByTile) {
  First f(5, 5, 4);
  f.command.push_at(1, {0, 2});
  f.bench.run(100);
  std::vector<std::pair<int, int>> order;
  for (const PixelJob& job : f.sink.tokens) order.emplace_back(job.x, job.y);
  EXPECT_EQ(order,
            (std::vector<std::pair<int, int>>{{0, 0}, {2, 0}, {0, 2}, {2, 2}, {4, 0}, {4, 2}, {0, 4}, {2, 4}, {4, 4}}));
}

TEST(FirstRenderingUnit, CountsForOddSizes) {
  for (const auto& [width, height] : {std::pair<std::uint32_t, std::uint32_t>{1, 1}, {3, 5}, {17, 1}, {33, 31}}) {
    First sampled(width, height, 16), all(width, height, 16);
    sampled.command.push_at(1, {0, 2});
    all.command.push_at(1, {0, 1});
    sampled.bench.run(5000);
    all.bench.run(5000);
    EXPECT_EQ(sampled.sink.tokens.size(), (width + 1) / 2 * ((height + 1) / 2));
    EXPECT_EQ(all.sink.tokens.size(), width * height);
  }
}

TEST(FirstRenderingUnit, WaitsForTheDispatcher) {
  First f(16, 16, 16);
  f.command.push_at(1, {0, 2});
  f.sink.open = [](Cycle now) { return now >= 100 && now % 2 == 0; };
  f.bench.run(1000);
  EXPECT_EQ(f.sink.cycles, every(100, 64, 2));
  EXPECT_GT(f.unit.cycles_in(State::stall_out), 90u);
}

}  // namespace
}  // namespace artu::hw::test
