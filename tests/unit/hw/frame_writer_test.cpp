// The frame writer: combines, evicts the oldest line, is done when all is acknowledged.
#include "hw/memory/frame_writer.h"

#include <gtest/gtest.h>

#include "unit/hw/support.h"

namespace artu::hw::test {
namespace {

constexpr Cycle memory_latency = 20;
constexpr std::uint32_t width = 128, height = 40;

struct Writer {
  explicit Writer(std::uint32_t entries, std::size_t source_count = 1)
      : writer(bench.block<FrameWriter>("writer", selective, registers, image, entries)),
        memory(bench.block<ScriptedMemory>("memory", link, 1, memory_latency)),
        passes(bench.block<Source<PassSize>>("passes", pass)),
        finished(bench.block<Sink<PassSize>>("finished", done)) {
    FrameDescriptor& frame = registers.descriptor;
    frame.width = width;
    frame.height = height;
    frame.pitch = width;
    frame.frame_buffer = image.allocate(width * height * 4);
    frame.hit_classes = image.allocate(width * height);
    link.bind(writer, memory);
    pass.bind(passes, writer);
    done.bind(writer, finished);
    writer.bind(link, pass, done);
    for (std::size_t i = 0; i < source_count; ++i) {
      const std::string name = "pixels" + std::to_string(i);
      auto& fifo = bench.fifo<PixelToken>(name.c_str(), 4);
      sources.push_back(&bench.block<Source<PixelToken>>((name + "_source").c_str(), fifo));
      fifo.bind(*sources.back(), writer);
      writer.add_source(fifo);
    }
    writer.flag_sources();
    records.resize(width * height);
    writer.observe(&records);
  }
  Address color_line(std::uint32_t x, std::uint32_t y) const {
    return registers.descriptor.frame_buffer + (y * width + x) / 16 * 64;
  }
  Address class_line(std::uint32_t x, std::uint32_t y) const {
    return registers.descriptor.hit_classes + (y * width + x) / 64 * 64;
  }
  /// The bytes that were written of a line, in one request.
  std::uint64_t bytes_of(Address line) const {
    for (const MemoryRequest& request : memory.requests) {
      if (request.line == line) return request.bytes;
    }
    return 0;
  }

  Bench bench;
  const SelectiveConfig selective;
  MemoryImage image;
  FrameRegisters registers;
  PixelRecords records;
  MemoryLink& link = bench.link("link", 4, 1, 1);
  Fifo<PassSize>& pass = bench.fifo<PassSize>("pass", 2);
  Fifo<PassSize>& done = bench.fifo<PassSize>("done", 2);
  FrameWriter& writer;
  ScriptedMemory& memory;
  Source<PassSize>& passes;
  Sink<PassSize>& finished;
  std::vector<Source<PixelToken>*> sources;
};

PixelToken pixel(std::uint32_t x, std::uint32_t y) {
  return {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), static_cast<std::uint8_t>(x), 7, 9,
          HitClass::dynamic_geometry};
}

TEST(FrameWriter, CombinesTheWritesToALine) {
  Writer w(16);
  w.passes.push_at(1, {16});
  for (std::uint32_t x = 0; x < 16; ++x) w.sources[0]->push_at(1, pixel(x, 0));
  w.bench.run(200);
  EXPECT_EQ(w.memory.requests.size(), 2u);
  EXPECT_EQ(w.bytes_of(w.color_line(0, 0)), whole_line);
  EXPECT_EQ(w.bytes_of(w.class_line(0, 0)), 0xffffu);
}

TEST(FrameWriter, WritesOnlyTheBytesOfItsPixels) {
  Writer w(16);
  w.passes.push_at(1, {2});
  w.sources[0]->push_at(1, pixel(18, 1)).push_at(2, pixel(20, 1));
  w.bench.run(200);
  EXPECT_EQ(w.memory.requests.size(), 2u);
  EXPECT_EQ(w.bytes_of(w.color_line(16, 1)), 0xf0f00u);               // pixels 2 and 4 of the line
  EXPECT_EQ(w.bytes_of(w.class_line(0, 1)), std::uint64_t{5} << 18);  // bytes 18 and 20 of the class line
}

TEST(FrameWriter, TakesOnePixelACycleAndIsDoneWhenTheLastLineIsAcknowledged) {
  Writer w(16);
  w.passes.push_at(1, {32});
  for (std::uint32_t x = 0; x < 32; ++x) w.sources[0]->push_at(1, pixel(x, 0));
  w.bench.run(200);
  EXPECT_EQ(w.sources[0]->pushed, every(1, 32));
  // The last pixel in 33; two colour lines and one class line leave in 34, 35, 36, the last is at the memory in 37.
  EXPECT_EQ(w.memory.cycles, (std::vector<Cycle>{35, 36, 37}));
  EXPECT_EQ(w.finished.cycles, std::vector<Cycle>{37 + memory_latency + 1});
  EXPECT_EQ(w.finished.tokens[0].pixels, 32u);
}

TEST(FrameWriter, IsNotDoneBeforeTheSlowestAcknowledgement) {
  Writer w(16);
  w.memory.latency = [&w](const MemoryRequest& r) -> Cycle { return r.line == w.color_line(0, 0) ? 300 : 5; };
  w.passes.push_at(1, {2});
  w.sources[0]->push_at(1, pixel(0, 0)).push_at(2, pixel(0, 1));
  w.bench.run(1000);
  Cycle slow = 0;
  for (std::size_t i = 0; i < w.memory.requests.size(); ++i) {
    if (w.memory.requests[i].line == w.color_line(0, 0)) slow = w.memory.cycles[i];
  }
  EXPECT_EQ(w.finished.cycles, std::vector<Cycle>{slow + 300 + 1});
}

TEST(FrameWriter, TheOldestLineGoesWhereNoneIsFree) {
  Writer w(4);
  // Two lines a pixel: the third pixel throws out the first one's, the fourth the second one's.
  w.passes.push_at(1, {5});
  for (std::uint32_t y : {0u, 1u, 2u, 3u}) w.sources[0]->push_at(1 + 50 * y, pixel(0, y));
  w.bench.run(400);
  EXPECT_EQ(w.memory.lines(),
            (std::vector<Address>{w.color_line(0, 0), w.class_line(0, 0), w.color_line(0, 1), w.class_line(0, 1)}));
  EXPECT_EQ(w.memory.cycles, (std::vector<Cycle>{103, 104, 153, 154})) << "in the cycle of the pixel that needs it";
  EXPECT_TRUE(w.finished.cycles.empty()) << "the fifth pixel has not come";
}

TEST(FrameWriter, WaitsForMemoryWhereAnEntryMustGo) {
  Writer w(2);
  w.memory.open = [](Cycle now) { return now >= 300; };
  w.passes.push_at(1, {20});
  for (std::uint32_t y = 0; y < 20; ++y) w.sources[0]->push_at(1, pixel(0, y));
  w.bench.run(1000);
  EXPECT_EQ(w.memory.requests.size(), 40u) << "no line twice";
  EXPECT_EQ(w.finished.cycles.size(), 1u);
  EXPECT_GT(w.writer.cycles_in(State::stall_mem), 250u);
}

TEST(FrameWriter, SourcesTakeTurnsAndEveryPixelIsWrittenOnce) {
  Writer w(16, 3);
  w.passes.push_at(1, {width * height});
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) w.sources[(x + y) % 3]->push_at(1, pixel(x, y));
  }
  w.bench.run(20000);
  ASSERT_EQ(w.finished.cycles.size(), 1u);
  for (const PixelRecord& record : w.records) ASSERT_EQ(record.written, 1);
  for (std::uint32_t i = 0; i < width * height; ++i) {
    const auto* bytes = &w.image.at<std::uint8_t>(w.registers.descriptor.frame_buffer + 4 * i);
    ASSERT_EQ(bytes[0], i % width);
    ASSERT_EQ(bytes[1], 7);
    ASSERT_EQ(bytes[2], 9);
    ASSERT_EQ(bytes[3], 255);
    ASSERT_EQ(w.image.at<HitClass>(w.registers.descriptor.hit_classes + i), HitClass::dynamic_geometry);
  }
  // Fair: the sources end within a few cycles of each other.
  EXPECT_NEAR(static_cast<double>(w.sources[0]->pushed.back()), static_cast<double>(w.sources[2]->pushed.back()), 10);
  EXPECT_EQ(w.sources[0]->pushed.back() / 100, Cycle{width * height} / 100) << "one pixel a cycle in all";
}

TEST(FrameWriter, EveryPassHasItsOwnEnd) {
  Writer w(16);
  w.passes.push_at(1, {1}).push_at(300, {2});
  w.sources[0]->push_at(1, pixel(0, 0)).push_at(310, pixel(1, 0)).push_at(400, pixel(2, 0));
  w.bench.run(1000);
  // Pixel in 2, two lines at the memory in 4 and 5.
  EXPECT_EQ(w.finished.cycles, (std::vector<Cycle>{5 + memory_latency + 1, 404 + memory_latency + 1}));
}

TEST(FrameWriter, AnEmptyPassIsDoneAtOnce) {
  Writer w(16);
  w.passes.push_at(1, {0});
  w.bench.run(100);
  EXPECT_EQ(w.finished.cycles, std::vector<Cycle>{3});
  EXPECT_TRUE(w.memory.requests.empty());
}

}  // namespace
}  // namespace artu::hw::test
