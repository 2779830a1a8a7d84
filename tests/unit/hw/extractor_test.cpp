// The candidate-pixel extractor on a frame buffer made by hand: neighbourhoods, borders, latency and throughput.
#include <gtest/gtest.h>

#include "hw/selective/candidate_pixel_extractor.h"
#include "unit/hw/support.h"

namespace artu::hw::test {
namespace {

constexpr Cycle memory_latency = 20;

/// A pass begins when it is told to.
SelectiveConfig one_by_one() {
  SelectiveConfig config;
  config.overlap = false;
  return config;
}

struct Extractor {
  Extractor(std::uint32_t width, std::uint32_t height, const SelectiveConfig& selective = one_by_one())
      : config(selective),
        cache(bench.block<Cache>("cache", config.pixel_cache)),
        memory(bench.block<ScriptedMemory>("memory", below, 1, memory_latency)),
        extractor(bench.block<CandidatePixelExtractor>("extractor", config, registers, image, cache)),
        command(bench.block<Source<PassCommand>>("command", commands)),
        sink(bench.block<Sink<Candidate>>("sink", out)) {
    FrameDescriptor& frame = registers.descriptor;
    frame.width = width;
    frame.height = height;
    frame.pitch = (width + 63) / 64 * 64;
    frame.frame_buffer = image.allocate(std::uint64_t{frame.pitch} * height * 4);
    frame.hit_classes = image.allocate(std::uint64_t{frame.pitch} * height);
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        std::uint8_t* rgba = &image.at<std::uint8_t>(frame.frame_buffer + (y * frame.pitch + x) * 4);
        rgba[0] = static_cast<std::uint8_t>(x);
        rgba[1] = static_cast<std::uint8_t>(y);
        rgba[2] = 5;
        set_class(x, y, HitClass::static_geometry);
      }
    }
    link.bind(extractor, cache);
    below.bind(cache, memory);
    cache.add_client(link);
    cache.bind_below(below);
    commands.bind(command, extractor);
    out.bind(extractor, sink);
    extractor.bind(commands, out, link);
    finished.bind(told, extractor);
    if (config.overlap) extractor.bind_finished(finished);
  }
  /// From `at` on: row `y` of the pass is finished, as far as it lies between `left` and `right`.
  void finish(Cycle at, std::uint32_t pass, std::uint32_t left, std::uint32_t right, std::uint32_t y) {
    const FrameDescriptor& frame = registers.descriptor;
    for (std::uint32_t x = left; x < std::min(right, frame.width); ++x) {
      if (PassPlan(config).pass_of(x, y) != pass) continue;
      const std::uint64_t index = std::uint64_t{y} * frame.pitch + x;
      const Address color = frame.frame_buffer + index * 4, hit_class = frame.hit_classes + index;
      told.push_at(at, {line_of(color), std::uint64_t{0xf} << (color % 64)});
      told.push_at(at, {line_of(hit_class), std::uint64_t{1} << (hit_class % 64)});
    }
  }
  void set_class(std::uint32_t x, std::uint32_t y, HitClass hit_class) {
    image.at<HitClass>(registers.descriptor.hit_classes + y * registers.descriptor.pitch + x) = hit_class;
  }
  const std::vector<Candidate>& run(std::uint8_t pass) {
    command.push_at(9, {pass, 2});
    bench.run(20000);
    return sink.tokens;
  }
  /// Lines asked for, wherever they came from.
  std::uint64_t extractor_requests() const { return cache.hits() + cache.misses(); }
  const Candidate& at(std::uint32_t x, std::uint32_t y) const {
    for (const Candidate& c : sink.tokens) {
      if (c.x == x && c.y == y) return c;
    }
    static const Candidate missing;
    ADD_FAILURE() << "no candidate " << x << ", " << y;
    return missing;
  }

  const SelectiveConfig config;
  Bench bench;
  MemoryImage image;
  FrameRegisters registers;
  MemoryLink& link = bench.link("link", 4, 1, 2);
  MemoryLink& below = bench.link("below", 8, 1, 1);
  Fifo<PassCommand>& commands = bench.fifo<PassCommand>("commands", 2);
  Fifo<Candidate>& out = bench.fifo<Candidate>("out", 4);
  Fifo<LineWritten>& finished = bench.fifo<LineWritten>("finished", 4);
  Source<LineWritten>& told = bench.block<Source<LineWritten>>("told", finished);
  Cache& cache;
  ScriptedMemory& memory;
  CandidatePixelExtractor& extractor;
  Source<PassCommand>& command;
  Sink<Candidate>& sink;
};

/// Which of the 8 neighbours, row by row, counts; all are static in the map.
std::string counted(const Candidate& c) {
  std::string text;
  for (const Neighbour& n : c.ring) text += n.hit_class == HitClass::static_geometry ? '#' : '.';
  return text;
}

TEST(Extractor, HorizontalCandidatesLieBetweenSamplingPixels) {
  Extractor e(9, 4);
  EXPECT_EQ(e.run(1).size(), 4u * 2);
  const Candidate& c = e.at(3, 2);
  ASSERT_EQ(c.pairs.count, 1);
  EXPECT_EQ(c.pass, 1);
  EXPECT_EQ(c.pairs.color[0][0].r, 2);
  EXPECT_EQ(c.pairs.color[0][1].r, 4);
  EXPECT_EQ(c.pairs.color[0][0].g, 2);
  EXPECT_EQ(c.pairs.color[0][0].b, 5);
  // Row by row: only the two sampling pixels beside it are of an earlier pass.
  EXPECT_EQ(counted(c), "...##...");
}

TEST(Extractor, VerticalCandidatesSeeBothEarlierPasses) {
  Extractor e(9, 5);
  EXPECT_EQ(e.run(2).size(), 9u * 2);
  const Candidate& c = e.at(4, 3);
  ASSERT_EQ(c.pairs.count, 1);
  EXPECT_EQ(c.pairs.color[0][0].g, 2);
  EXPECT_EQ(c.pairs.color[0][1].g, 4);
  EXPECT_EQ(c.pairs.color[0][0].r, 4);
  EXPECT_EQ(counted(c), "###..###");
}

TEST(Extractor, NeighboursOutsideTheImageDoNotCount) {
  Extractor e(9, 5);
  e.run(2);
  EXPECT_EQ(counted(e.at(0, 1)), ".##...##");
  EXPECT_EQ(counted(e.at(8, 3)), "##...##.");
}

TEST(Extractor, AtTheRightAndLowerBorderThePairIsIncomplete) {
  Extractor right(8, 3), lower(9, 4);
  right.run(1);
  EXPECT_EQ(right.at(7, 2).pairs.count, 0);
  EXPECT_EQ(right.at(5, 2).pairs.count, 1);
  EXPECT_EQ(counted(right.at(7, 2)), "...#....");
  lower.run(2);
  EXPECT_EQ(lower.at(4, 3).pairs.count, 0);
  EXPECT_EQ(lower.at(4, 1).pairs.count, 1);
  EXPECT_EQ(counted(lower.at(4, 3)), "###.....");
}

TEST(Extractor, ClassesAreHandedOnAsTheyAre) {
  Extractor e(9, 5);
  e.set_class(3, 2, HitClass::none);
  e.set_class(4, 2, HitClass::miss);
  e.set_class(5, 2, HitClass::dynamic_geometry);
  e.run(2);
  const auto& n = e.at(4, 1).ring;
  EXPECT_EQ(n[5].hit_class, HitClass::none);
  EXPECT_EQ(n[6].hit_class, HitClass::miss);
  EXPECT_EQ(n[7].hit_class, HitClass::dynamic_geometry);
}

SelectiveConfig with(std::uint32_t stride, Passes passes) {
  SelectiveConfig config = one_by_one();
  config.stride = stride;
  config.passes = passes;
  return config;
}

TEST(Extractor, ACentreHasTwoPairsAndAllNeighbours) {
  Extractor e(9, 9, with(2, Passes::average));
  EXPECT_EQ(e.run(3).size(), 4u * 4);
  const Candidate& c = e.at(3, 5);
  EXPECT_EQ(c.kind, PassKind::centre);
  ASSERT_EQ(c.pairs.count, 2);
  EXPECT_EQ(c.pairs.color[0][0].r, 2);
  EXPECT_EQ(c.pairs.color[0][1].r, 4);
  EXPECT_EQ(c.pairs.color[1][0].g, 4);
  EXPECT_EQ(c.pairs.color[1][1].g, 6);
  EXPECT_EQ(counted(c), "########");
}

TEST(Extractor, ACentreOnTheBorderHasNoPairAtAll) {
  Extractor e(8, 7, with(2, Passes::average));
  e.run(3);
  EXPECT_EQ(e.at(7, 3).pairs.count, 0) << "nothing on the right, though above and below";
  EXPECT_EQ(counted(e.at(7, 3)), "##.#.##.");
  EXPECT_EQ(e.at(5, 3).pairs.count, 2);
}

TEST(Extractor, WithAStrideNeighboursLieHalfOfItAway) {
  Extractor e(33, 17, with(8, Passes::horizontal_vertical));
  e.run(2);  // vertical, h = 4
  const Candidate& c = e.at(12, 4);
  EXPECT_EQ(c.h, 4);
  ASSERT_EQ(c.pairs.count, 1);
  EXPECT_EQ(c.pairs.color[0][0].g, 0);
  EXPECT_EQ(c.pairs.color[0][1].g, 8);
  EXPECT_EQ(counted(c), "###..###");
  for (std::size_t i : {0u, 5u}) EXPECT_EQ(c.ring[i].color.r, 8);
  for (std::size_t i : {2u, 7u}) EXPECT_EQ(c.ring[i].color.r, 16);
  EXPECT_EQ(c.ring[7].color.g, 8);
  EXPECT_FALSE(c.ring[3].finished);
  EXPECT_EQ(counted(e.at(32, 12)), "##...##.");
}

TEST(Extractor, ReadsTheRowsThatItsPassNeedsAndNoOthers) {
  // 48 x 48 pixels are 3 x 3 tiles; a row of a span needs one colour line of its own, and those of the tiles beside it
  // into which it looks, and one class line.
  const auto lines = [](std::uint32_t stride, Passes passes, std::uint8_t pass) {
    Extractor e(48, 48, with(stride, passes));
    e.run(pass);
    return e.extractor_requests();
  };
  // Horizontal: the right neighbour's first column, but of the last tile.
  EXPECT_EQ(lines(2, Passes::horizontal_vertical, 1), 24u * (3 + 3 + 2));
  EXPECT_EQ(lines(8, Passes::horizontal_vertical, 1), 6u * (3 + 3 + 2));
  // Vertical: the diagonals lie in both tiles beside it, in two rows; the last row has nothing below.
  EXPECT_EQ(lines(2, Passes::horizontal_vertical, 2), 47u * (3 + 4 + 3));
  // With candidates in every second column alone it looks to the left, and the last one of a tile not to the right.
  EXPECT_EQ(lines(2, Passes::average, 2), 47u * (2 + 3 + 3));
  EXPECT_EQ(lines(2, Passes::average, 3), (2u * 23 + 1 + 24) * (3 + 3 + 2)) << "two rows and its own";
}

TEST(Extractor, VisitsEachCandidateOnceAndInTileOrder) {
  for (std::uint8_t pass : {1, 2}) {
    Extractor e(37, 21);
    const auto candidates = e.run(pass);
    TileWalk walk = PassPlan(e.config).walk(pass, 37, 21, e.config.tile);
    std::size_t i = 0;
    for (; !walk.done(); walk.next()) {
      for (std::uint32_t x = walk.span().begin; x < walk.span().end; x += walk.dx(), ++i) {
        ASSERT_LT(i, candidates.size());
        ASSERT_EQ(candidates[i].x, x);
        ASSERT_EQ(candidates[i].y, walk.span().y);
      }
    }
    EXPECT_EQ(i, candidates.size());
  }
}

TEST(Extractor, TheFirstCandidateWaitsForTheLinesOfItsSpan) {
  Extractor e(16, 1);
  e.run(1);
  // Command in 10; in the same cycle the span is opened and its first line asked for, then the second one (16 pixels:
  // one line of colours, one of classes): in the cache in 12, at the memory in 13, back in 13 + latency, answered two
  // cycles (hit latency) later, and a candidate leaves in that cycle.
  const Cycle first = 13 + memory_latency + 2;
  EXPECT_EQ(e.memory.cycles, (std::vector<Cycle>{12, 13}));
  EXPECT_EQ(e.sink.cycles, every(first + 1, 8));  // one a cycle
}

TEST(Extractor, HandsOnOneCandidateACycleOnceTheLinesAreThere) {
  // Pass 2 at 16 pixels a span and at most 8 lines a span: the fetches of four spans hide behind the candidates.
  Extractor e(64, 65);
  e.memory.latency = [](const MemoryRequest&) -> Cycle { return 2; };
  const auto count = e.run(2).size();
  EXPECT_EQ(count, 64u * 32);
  EXPECT_EQ(e.sink.cycles.back() - e.sink.cycles.front(), count - 1);
}

TEST(Extractor, ReadsTheFrameAfreshInEveryPass) {
  Extractor e(16, 3);
  e.command.push_at(9, {1, 2}).push_at(1009, {1, 2});
  e.bench.run(3000);
  ASSERT_EQ(e.sink.tokens.size(), 2u * 16);
  EXPECT_EQ(e.memory.requests.size(), 2u * 4) << "two rows of a colour and a class line, fetched twice";
  EXPECT_EQ(e.sink.cycles[16], e.sink.cycles[0] + 1000);
}

SelectiveConfig overlapping() {
  SelectiveConfig config;
  config.overlap = true;
  config.tile = 8;
  return config;
}

TEST(Extractor, WithOverlapASpanOpensWhenItsTileAndThoseThatItLooksIntoAreFinished) {
  Extractor e(16, 8, overlapping());
  e.command.push_at(9, {1, 2, 2});
  for (std::uint32_t y : {0u, 2u, 4u, 6u}) e.finish(1000, 0, 0, 8, y);
  for (std::uint32_t y : {0u, 2u, 4u, 6u}) e.finish(2000, 0, 8, 16, y);
  for (std::uint32_t y : {0u, 2u, 4u, 6u}) e.finish(3000, 1, 0, 8, y);
  for (std::uint32_t y : {0u, 2u, 4u, 6u}) e.finish(4000, 1, 8, 16, y);
  e.bench.run(10000);
  ASSERT_EQ(e.sink.tokens.size(), 16u * 8 - 8 * 4);
  for (std::size_t i = 0; i < e.sink.tokens.size(); ++i) {
    const Candidate& c = e.sink.tokens[i];
    // Both horizontal passes look to the right; the vertical ones of the left tile into the right one, too.
    EXPECT_GT(e.sink.cycles[i], c.pass == 1 ? 2000u : 4000u) << c.x << ", " << c.y;
    if (c.pass == 1) {
      EXPECT_LT(e.sink.cycles[i], 3000u);
    }
  }
}

TEST(Extractor, WithOverlapALaterPassGoesFirstAndEachInTileOrder) {
  Extractor e(64, 64, overlapping());
  e.command.push_at(2000, {1, 2, 2});
  // Everything is finished beforehand: the vertical pass waits for nothing and so goes first.
  for (std::uint32_t pass : {0u, 1u}) {
    for (std::uint32_t y = 0; y < 64; y += 2) e.finish(2010, pass, 0, 64, y);
  }
  e.bench.run(40000);
  ASSERT_EQ(e.sink.tokens.size(), 64u * 64 - 32 * 32);
  for (std::uint8_t pass : {1, 2}) {
    TileWalk walk = PassPlan(e.config).walk(pass, 64, 64, e.config.tile);
    std::uint32_t x = walk.span().begin;
    for (const Candidate& c : e.sink.tokens) {
      if (c.pass != pass) continue;
      ASSERT_EQ(c.x, x);
      ASSERT_EQ(c.y, walk.span().y);
      x += walk.dx();
      if (x < walk.span().end) continue;
      walk.next();
      if (!walk.done()) x = walk.span().begin;
    }
    EXPECT_TRUE(walk.done());
  }
}

TEST(Extractor, StallsTellWhatItWaitsFor) {
  Extractor slow(64, 33);
  slow.memory.latency = [](const MemoryRequest&) -> Cycle { return 200; };
  slow.run(1);
  EXPECT_GT(slow.extractor.cycles_in(State::stall_mem), 500u);
  Extractor blocked(64, 33);
  blocked.sink.open = [](Cycle now) { return now > 5000; };
  blocked.run(1);
  EXPECT_GT(blocked.extractor.cycles_in(State::stall_out), 4000u);
}

}  // namespace
}  // namespace artu::hw::test
