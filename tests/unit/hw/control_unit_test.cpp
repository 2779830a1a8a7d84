// The control unit: phases in order, what is skipped, and that the phases' cycles are the frame's.
#include "hw/control_unit.h"

#include <gtest/gtest.h>

#include "unit/hw/support.h"

namespace artu::hw::test {
namespace {

/// Answers each command `delay` cycles after its arrival.
template <class Command>
class Partner : public Block {
 public:
  Partner(sc_core::sc_module_name name, ClockDomain& domain, Fifo<Command>& in, Fifo<Command>& out, std::uint32_t delay)
      : Block(name, domain), in_(in), out_(out), delay_(delay) {}
  std::vector<Command> commands;
  std::vector<Cycle> cycles;
  void reset() override {
    commands.clear();
    cycles.clear();
  }

 private:
  Activity tick(Cycle now) override {
    if (!in_.can_pop()) return {State::stall_in};
    commands.push_back(in_.front());
    cycles.push_back(now);
    in_.pop();
    out_.push(commands.back(), delay_ - 1);
    return {State::busy, now + 1};
  }
  Fifo<Command>&in_, &out_;
  const std::uint32_t delay_;
};

constexpr Cycle memory_latency = 30;
constexpr std::uint32_t build_delay = 100, pass_delay = 50, flush_delay = 70;
constexpr Cycle descriptor_lines = sizeof(FrameDescriptor) / 64;

struct Control {
  Control(std::uint32_t width, std::uint32_t height, bool selective = true)
      : Control(width, height, config(selective)) {}
  Control(std::uint32_t width, std::uint32_t height, const SelectiveConfig& selective)
      : control(bench.block<ControlUnit>("control", selective, ShadingConfig{}, registers, image)),
        memory(bench.block<ScriptedMemory>("memory", link, 1, memory_latency)),
        builder(bench.block<Partner<BuildToken>>("builder", build, built, build_delay)),
        writer(bench.block<Partner<PassSize>>("writer", pass, written, pass_delay)),
        l2(bench.block<Partner<CacheCommand>>("l2", flush, flushed, flush_delay)),
        first_sink(bench.block<Sink<PassCommand>>("first_sink", first)),
        extract_sink(bench.block<Sink<PassCommand>>("extract_sink", extract)) {
    address = image.allocate(sizeof(FrameDescriptor));
    frame().width = width;
    frame().height = height;
    link.bind(control, memory);
    build.bind(control, builder);
    built.bind(builder, control);
    pass.bind(control, writer);
    written.bind(writer, control);
    flush.bind(control, l2);
    flushed.bind(l2, control);
    first.bind(control, first_sink);
    extract.bind(control, extract_sink);
    control.bind({&link, &build, &built, &first, &extract, &pass, &written, {&flush}, {&flushed}});
    control.set_descriptor(address);
  }
  static SelectiveConfig config(bool selective) {
    SelectiveConfig config;
    config.overlap = false;
    config.enabled = selective;
    return config;
  }
  FrameDescriptor& frame() { return image.at<FrameDescriptor>(address); }
  /// Ends by itself; the cycles of start, build, first, selective, flush.
  std::vector<std::uint64_t> run() {
    bench.run_until_quiet();
    std::vector<std::uint64_t> phases;
    for (const char* name : {"cycles_start", "cycles_build", "cycles_first", "cycles_selective", "cycles_flush"}) {
      phases.push_back(counter(control, name));
    }
    return phases;
  }
  std::vector<std::uint64_t> passes() const {
    std::vector<std::uint64_t> sizes;
    for (const PassSize& size : writer.commands) sizes.push_back(size.pixels);
    return sizes;
  }

  Bench bench;
  MemoryImage image;
  Address address;
  FrameRegisters registers;
  MemoryLink& link = bench.link("link", 8, 1, 1);
  Fifo<BuildToken>&build = bench.fifo<BuildToken>("build", 2), &built = bench.fifo<BuildToken>("built", 2);
  Fifo<PassSize>&pass = bench.fifo<PassSize>("pass", 2), &written = bench.fifo<PassSize>("written", 2);
  Fifo<CacheCommand>&flush = bench.fifo<CacheCommand>("flush", 2), &flushed = bench.fifo<CacheCommand>("flushed", 2);
  Fifo<PassCommand>&first = bench.fifo<PassCommand>("first", 2), &extract = bench.fifo<PassCommand>("extract", 2);
  ControlUnit& control;
  ScriptedMemory& memory;
  Partner<BuildToken>& builder;
  Partner<PassSize>& writer;
  Partner<CacheCommand>& l2;
  Sink<PassCommand>&first_sink, &extract_sink;
};

// Lines are asked for one a cycle from cycle 1 on; the last one's way to the memory and back.
constexpr Cycle start = descriptor_lines + 1 + memory_latency;

TEST(ControlUnit, PhasesFollowEachOtherAndSumToTheFrame) {
  Control c(5, 3);
  c.frame().dynamic_moved = 1;
  c.frame().dynamic_triangle_count = 10;
  // A command takes a cycle to its block, and the answer what the block takes.
  EXPECT_EQ(c.run(), (std::vector<std::uint64_t>{start, 1 + build_delay, 1 + pass_delay, 2 * (1 + pass_delay),
                                                 1 + flush_delay}));
  EXPECT_EQ(c.control.finished_at(), start + 1 + build_delay + 3 * (1 + pass_delay) + 1 + flush_delay);
  EXPECT_EQ(c.builder.cycles, std::vector<Cycle>{start + 1});
  EXPECT_EQ(c.passes(), (std::vector<std::uint64_t>{6, 4, 5}));  // 3 x 2, 2 x 2, 5 x 1
  EXPECT_EQ(c.l2.cycles.size(), 1u);
}

TEST(ControlUnit, CommandsNameThePassAndItsStride) {
  Control c(5, 3);
  c.run();
  ASSERT_EQ(c.first_sink.tokens.size(), 1u);
  EXPECT_EQ(c.first_sink.tokens[0].pass, 0);
  EXPECT_EQ(c.first_sink.tokens[0].stride, 2);
  ASSERT_EQ(c.extract_sink.tokens.size(), 2u);
  EXPECT_EQ(c.extract_sink.tokens[0].pass, 1);
  EXPECT_EQ(c.extract_sink.tokens[1].pass, 2);
  // Each begins when the one before is written.
  EXPECT_EQ(c.extract_sink.cycles[0], c.first_sink.cycles[0] + pass_delay + 1);
  EXPECT_EQ(c.extract_sink.cycles[1], c.extract_sink.cycles[0] + pass_delay + 1);
}

TEST(ControlUnit, NothingIsBuiltWhereNothingMovedOrNothingIsThere) {
  for (bool moved : {false, true}) {
    Control c(5, 3);
    c.frame().dynamic_moved = moved ? 1 : 0;
    c.frame().dynamic_triangle_count = moved ? 0 : 10;
    EXPECT_EQ(c.run()[1], 0u);
    EXPECT_TRUE(c.builder.commands.empty());
    EXPECT_EQ(counter(c.control, "builds_skipped"), moved ? 0u : 1u) << "of no geometry there is no tree to keep";
  }
}

TEST(ControlUnit, PassesWithoutPixelsAreSkipped) {
  Control one(1, 1), column(1, 4), row(4, 1);
  EXPECT_EQ(one.run()[3], 0u);
  EXPECT_EQ(one.passes(), std::vector<std::uint64_t>{1});
  EXPECT_EQ(column.run()[3], 1 + pass_delay);
  EXPECT_EQ(column.passes(), (std::vector<std::uint64_t>{2, 2}));
  EXPECT_EQ(column.extract_sink.tokens[0].pass, 2);
  row.run();
  EXPECT_EQ(row.passes(), (std::vector<std::uint64_t>{2, 2}));
  EXPECT_EQ(row.extract_sink.tokens[0].pass, 1);
}

SelectiveConfig with(std::uint32_t stride, Passes passes) {
  SelectiveConfig config;
  config.overlap = false;
  config.stride = stride;
  config.passes = passes;
  return config;
}

TEST(ControlUnit, LevelsFollowEachOther) {
  Control c(9, 5, with(4, Passes::horizontal_vertical));
  EXPECT_EQ(c.run()[3], 4 * (1 + pass_delay));
  EXPECT_EQ(c.first_sink.tokens[0].stride, 4);
  EXPECT_EQ(c.passes(), (std::vector<std::uint64_t>{3 * 2, 2 * 2, 5 * 1, 4 * 3, 9 * 2}));
  Control average(9, 5, with(4, Passes::average));
  average.run();
  EXPECT_EQ(average.passes(), (std::vector<std::uint64_t>{3 * 2, 2 * 2, 3 * 1, 2 * 1, 4 * 3, 5 * 2, 4 * 2}));
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(average.extract_sink.tokens[i].pass, i + 1);
}

TEST(ControlUnit, PassesWithoutPixelsAreSkippedOfEveryLevel) {
  Control c(3, 1, with(8, Passes::average));  // 0; nothing at 4; 2; 1
  c.run();
  EXPECT_EQ(c.passes(), (std::vector<std::uint64_t>{1, 1, 1}));
  EXPECT_EQ(c.extract_sink.tokens[0].pass, 4);
  EXPECT_EQ(c.extract_sink.tokens[1].pass, 7);
}

TEST(ControlUnit, OverlappingPassesBeginTogether) {
  SelectiveConfig config = with(4, Passes::average);
  config.overlap = true;
  Control c(9, 5, config);
  // The partner answers once: with it the phase changes, and the frame waits for the second answer.
  c.bench.run(2000);
  ASSERT_EQ(c.writer.commands.size(), 1u);
  EXPECT_EQ(c.writer.commands[0].pixels, 45u);
  EXPECT_EQ(c.writer.commands[0].sampling, 6u);
  ASSERT_EQ(c.extract_sink.tokens.size(), 1u);
  EXPECT_EQ(c.extract_sink.tokens[0].pass, 1);
  EXPECT_EQ(c.extract_sink.tokens[0].last, 6);
  EXPECT_EQ(c.extract_sink.cycles, c.first_sink.cycles);
  EXPECT_EQ(counter(c.control, "cycles_first"), 1 + pass_delay);
  EXPECT_EQ(c.control.finished_at(), never);
}

TEST(ControlUnit, WithoutCandidatesThereIsNothingToOverlap) {
  SelectiveConfig config;
  config.overlap = true;
  Control one(1, 1, config);
  EXPECT_EQ(one.run()[3], 0u);
  EXPECT_EQ(one.passes(), std::vector<std::uint64_t>{1});
  EXPECT_EQ(one.writer.commands[0].sampling, 0u);
  config.enabled = false;
  Control off(5, 3, config);
  off.run();
  EXPECT_EQ(off.passes(), std::vector<std::uint64_t>{15});
}

TEST(ControlUnit, WithoutSelectiveRenderingThereIsOnePass) {
  Control c(5, 3, false);
  EXPECT_EQ(c.run()[3], 0u);
  EXPECT_EQ(c.passes(), std::vector<std::uint64_t>{15});
  EXPECT_EQ(c.first_sink.tokens[0].stride, 1);
  EXPECT_TRUE(c.extract_sink.tokens.empty());
}

TEST(ControlUnit, LightsAreReadAfterTheDescriptorThatTellsOfThem) {
  Control c(1, 1);
  const Address lights = c.image.allocate(3 * sizeof(LightRecord));
  c.frame().lights = lights;
  c.frame().light_count = 3;
  c.image.at<LightRecord>(lights + 128).range = 42;
  EXPECT_EQ(c.run()[0], start + 3 + memory_latency);  // asked for from the cycle of the last descriptor line on
  ASSERT_EQ(c.registers.lights.size(), 3u);
  EXPECT_EQ(c.registers.lights[2].range, 42.0f);
  ASSERT_EQ(c.memory.requests.size(), descriptor_lines + 3);
  EXPECT_EQ(c.memory.requests.back().line, lights + 128);
}

TEST(ControlUnit, AFrameCanBeRunAgain) {
  Control c(5, 3);
  const auto first = c.run();
  EXPECT_EQ(c.run(), first);
}

}  // namespace
}  // namespace artu::hw::test
