// The frame writer with overlapping passes: what is told of when, and which lines go early.
#include <gtest/gtest.h>

#include <map>

#include "hw/memory/frame_writer.h"
#include "unit/hw/support.h"

namespace artu::hw::test {
namespace {

constexpr Cycle memory_latency = 20;
constexpr std::uint32_t width = 64, height = 32;

struct Writer {
  explicit Writer(std::uint32_t entries = 16)
      : writer(bench.block<FrameWriter>("writer", selective, registers, image, entries)),
        memory(bench.block<ScriptedMemory>("memory", link, 1, memory_latency)),
        passes(bench.block<Source<PassSize>>("passes", pass)),
        finished(bench.block<Sink<PassSize>>("finished", done)),
        pixels(bench.block<Source<PixelToken>>("pixels", jobs)),
        told(bench.block<Sink<LineWritten>>("told", visible)) {
    FrameDescriptor& frame = registers.descriptor;
    frame.width = frame.pitch = width;
    frame.height = height;
    frame.frame_buffer = image.allocate(width * height * 4);
    frame.hit_classes = image.allocate(width * height);
    link.bind(writer, memory);
    pass.bind(passes, writer);
    done.bind(writer, finished);
    jobs.bind(pixels, writer);
    visible.bind(writer, told);
    writer.bind(link, pass, done);
    writer.add_source(jobs);
    writer.flag_sources();
    writer.bind_visible(visible);
  }
  Address color_line(std::uint32_t x, std::uint32_t y) const {
    return line_of(registers.descriptor.frame_buffer + (y * width + x) * 4);
  }
  Address class_line(std::uint32_t x, std::uint32_t y) const {
    return line_of(registers.descriptor.hit_classes + y * width + x);
  }
  Bench bench;
  const SelectiveConfig selective;
  MemoryImage image;
  FrameRegisters registers;
  MemoryLink& link = bench.link("link", 4, 1, 1);
  Fifo<PassSize>& pass = bench.fifo<PassSize>("pass", 2);
  Fifo<PassSize>& done = bench.fifo<PassSize>("done", 2);
  Fifo<PixelToken>& jobs = bench.fifo<PixelToken>("jobs", 4);
  Fifo<LineWritten>& visible = bench.fifo<LineWritten>("visible", 4);
  FrameWriter& writer;
  ScriptedMemory& memory;
  Source<PassSize>& passes;
  Sink<PassSize>& finished;
  Source<PixelToken>& pixels;
  Sink<LineWritten>& told;
};

PixelToken pixel(std::uint32_t x, std::uint32_t y) {
  PixelToken token;
  token.x = static_cast<std::uint16_t>(x);
  token.y = static_cast<std::uint16_t>(y);
  return token;
}

TEST(FrameWriterOverlap, ALineGoesWhenAPassOfATileIsCompleteInIt) {
  Writer w;
  w.passes.push_at(1, {width * height, 512});
  for (std::uint32_t x = 0; x < 16; x += 2) w.pixels.push_at(9, pixel(x, 0));
  w.bench.run(100);
  // The eighth pixel in 17: colours in that cycle, classes in the next.
  EXPECT_EQ(w.memory.lines(), (std::vector<Address>{w.color_line(0, 0), w.class_line(0, 0)}));
  EXPECT_EQ(w.memory.cycles, (std::vector<Cycle>{18, 19}));
  EXPECT_EQ(w.memory.requests[0].bytes, 0x0f0f0f0f0f0f0f0fu);
  EXPECT_EQ(w.memory.requests[1].bytes, 0x5555u);
  // Told in the cycle of the acknowledgement.
  EXPECT_EQ(w.told.cycles, (std::vector<Cycle>{18 + memory_latency + 1, 19 + memory_latency + 1}));
  EXPECT_EQ(w.told.tokens[0].line, w.color_line(0, 0));
  EXPECT_EQ(w.told.tokens[0].bytes, 0x0f0f0f0f0f0f0f0fu);
  EXPECT_EQ(w.told.tokens[1].bytes, 0x5555u);
}

TEST(FrameWriterOverlap, AnIncompleteLineGoesWhenItsPatienceIsOver) {
  Writer w;
  w.passes.push_at(1, {width * height, 512});
  w.pixels.push_at(9, pixel(0, 0)).push_at(109, pixel(2, 0));
  w.bench.run(1000);
  // Touched last in 110.
  EXPECT_EQ(w.memory.cycles, (std::vector<Cycle>{111 + FrameWriter::patience, 112 + FrameWriter::patience}));
  EXPECT_EQ(w.memory.requests[0].bytes, 0xf0fu);
}

TEST(FrameWriterOverlap, PixelsOfTheLastPassAreNotTold) {
  Writer w;
  w.passes.push_at(1, {width * height, 512});
  for (std::uint32_t x = 0; x < 16; ++x) w.pixels.push_at(9, pixel(x, 1));  // vertical
  w.bench.run(100);
  EXPECT_EQ(w.memory.requests.size(), 2u);
  EXPECT_TRUE(w.told.tokens.empty());
}

TEST(FrameWriterOverlap, TellsTheEndOfTheSamplingPixelsAndOfAll) {
  Writer w;
  w.passes.push_at(1, {3, 2});
  w.pixels.push_at(9, pixel(0, 0)).push_at(19, pixel(2, 0)).push_at(400, pixel(1, 0));
  w.bench.run(1000);
  ASSERT_EQ(w.finished.tokens.size(), 2u);
  EXPECT_EQ(w.finished.tokens[0].pixels, 2u);
  EXPECT_EQ(w.finished.cycles[0], 21u) << "when it has come";
  EXPECT_EQ(w.finished.tokens[1].pixels, 3u);
  EXPECT_EQ(w.finished.cycles[1], 404u + memory_latency + 1) << "when it is acknowledged";
}

TEST(FrameWriterOverlap, EveryByteIsToldOfOnceThoughLinesAreThrownOutAndMemoryIsSlow) {
  for (std::uint32_t entries : {2u, 3u, 16u}) {
    Writer w(entries);
    w.memory.latency = [](const MemoryRequest& r) -> Cycle { return 5 + r.line / 64 % 97; };
    w.memory.open = [](Cycle now) { return now % 3 == 0; };
    w.told.open = [](Cycle now) { return now % 5 == 0; };
    w.passes.push_at(1, {width * height, 512});
    // Tiles by turns, so that lines are needed again after they went.
    for (std::uint32_t i = 0; i < width * height; ++i) {
      const std::uint32_t j = i * 37 % (width * height);
      w.pixels.push_at(9, pixel(j % width, j / width));
    }
    w.bench.run(60000);
    ASSERT_EQ(w.finished.tokens.size(), 2u);
    std::map<Address, std::uint64_t> told;
    for (const LineWritten& line : w.told.tokens) {
      ASSERT_EQ(told[line.line] & line.bytes, 0u) << "twice";
      told[line.line] |= line.bytes;
    }
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; x += 64) {
        ASSERT_EQ(told[w.class_line(x, y)], y % 2 == 0 ? whole_line : 0u);
      }
      for (std::uint32_t x = 0; x < width; x += 16) {
        ASSERT_EQ(told[w.color_line(x, y)], y % 2 == 0 ? whole_line : 0u);
      }
    }
  }
}

}  // namespace
}  // namespace artu::hw::test
