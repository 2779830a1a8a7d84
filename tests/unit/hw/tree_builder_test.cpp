// The tree builder is a cost: its cycles and its traffic are closed forms of the number of triangles.
#include "hw/memory/tree_builder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/hw/support.h"

namespace artu::hw::test {
namespace {

struct Builder {
  Builder(std::uint32_t triangles, std::uint32_t per_pass, Cycle memory_latency, TreeBuilderConfig config = {})
      : config(with(config, per_pass)),
        builder(bench.block<TreeBuilder>("builder", this->config, registers)),
        memory(bench.block<ScriptedMemory>("memory", link, 1, memory_latency)),
        command(bench.block<Source<BuildToken>>("command", build)),
        answer(bench.block<Sink<BuildToken>>("answer", built)) {
    FrameDescriptor& frame = registers.descriptor;
    frame.dynamic_triangle_count = frame.dynamic_reference_count = triangles;
    frame.dynamic_node_lines = triangles - 1;
    frame.build_input = 1 << 20;
    frame.build_scratch = 2 << 20;
    frame.dynamic_nodes = 3 << 20;
    frame.dynamic_triangles = 4 << 20;
    frame.dynamic_attributes = 5 << 20;
    link.bind(builder, memory);
    build.bind(command, builder);
    built.bind(builder, answer);
    builder.bind(link, build, built);
  }
  static TreeBuilderConfig with(TreeBuilderConfig config, std::uint32_t per_pass) {
    config.triangles_per_pass = per_pass;
    return config;
  }
  const TreeBuilderConfig config;
  Bench bench;
  FrameRegisters registers;
  MemoryLink& link = bench.link("link", 8, 1, 1);
  Fifo<BuildToken>& build = bench.fifo<BuildToken>("build", 2);
  Fifo<BuildToken>& built = bench.fifo<BuildToken>("built", 2);
  TreeBuilder& builder;
  ScriptedMemory& memory;
  Source<BuildToken>& command;
  Sink<BuildToken>& answer;
};

struct Size {
  std::uint32_t triangles, per_pass, levels, streamed;
};
class TreeBuilderForm : public testing::TestWithParam<Size> {};

TEST_P(TreeBuilderForm, CyclesAreThoseOfTheLevelsWhenMemoryIsFast) {
  const auto [n, per_pass, levels, streamed] = GetParam();
  constexpr Cycle memory_latency = 1;
  Builder b(n, per_pass, memory_latency);
  b.command.push_at(1, {});
  b.bench.run(10000000);
  const Cycle references = (Cycle{n} * 16 + 63) / 64;
  // Command in 2.  The first step is all traffic: n lines in, references out, one a cycle from cycle 2 on, and the
  // last one's way to the memory and back.  The levels' traffic hides behind their 9 cycles a triangle, but the last
  // step's (it begins a cycle after the step) does not where there are few levels on chip.
  const Cycle first = 2 + n + references + memory_latency;
  const Cycle last_traffic = references + n + (n - 1) + 2 * n + 1 + memory_latency;
  const Cycle on_chip = std::max<Cycle>(9 * Cycle{n} * (levels - streamed), last_traffic);
  EXPECT_EQ(b.answer.cycles, std::vector<Cycle>{first + 9 * Cycle{n} * streamed + on_chip + 1});
}

TEST_P(TreeBuilderForm, TrafficIsOfTheLevelsThatDoNotFitOnChip) {
  const auto [n, per_pass, levels, streamed] = GetParam();
  Builder b(n, per_pass, 30);
  b.command.push_at(1, {});
  b.bench.run(10000000);
  const std::uint64_t references = (std::uint64_t{n} * 16 + 63) / 64;
  EXPECT_EQ(counter(b.builder, "lines_read"), n + references * (streamed + 1) + n);
  EXPECT_EQ(counter(b.builder, "lines_written"), references * (1 + streamed) + (n - 1) + 2 * std::uint64_t{n});
  EXPECT_EQ(b.memory.requests.size(), counter(b.builder, "lines_read") + counter(b.builder, "lines_written"));
  EXPECT_EQ(b.memory.writes(), counter(b.builder, "lines_written"));
  for (const MemoryRequest& request : b.memory.requests) ASSERT_TRUE(request.bytes == 0 || request.bytes == whole_line);
  EXPECT_EQ(b.answer.cycles.size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Sizes, TreeBuilderForm,
                         testing::Values(Size{1, 16, 1, 0}, Size{2, 16, 1, 0}, Size{3, 16, 2, 0}, Size{16, 16, 4, 0},
                                         Size{17, 16, 5, 1}, Size{100, 16, 7, 3}, Size{128, 16, 7, 3},
                                         Size{129, 16, 8, 4}, Size{1000, 1024, 10, 0}, Size{1025, 1024, 11, 1}));

TEST(TreeBuilder, DoesNothingWithoutACommand) {
  Builder b(100, 16, 10);
  b.bench.run(10000);
  EXPECT_TRUE(b.memory.requests.empty());
  EXPECT_TRUE(b.answer.cycles.empty());
  EXPECT_EQ(b.builder.cycles_in(State::busy), 0u);
}

TEST(TreeBuilder, KeepsNoMoreRequestsInFlightThanItMay) {
  TreeBuilderConfig config;
  config.outstanding = 3;
  Builder b(64, 1024, 100, config);
  b.command.push_at(1, {});
  b.bench.run(100000);
  ASSERT_EQ(b.answer.cycles.size(), 1u);
  // An answer comes 100 cycles after its request's arrival; three requests are less than that apart, a fourth never.
  for (std::size_t i = 3; i < b.memory.cycles.size(); ++i) {
    ASSERT_GE(b.memory.cycles[i], b.memory.cycles[i - 3] + 100);
  }
  EXPECT_EQ(b.memory.cycles[2], b.memory.cycles[0] + 2);
  EXPECT_GT(b.builder.cycles_in(State::stall_mem), 1000u);
}

TEST(TreeBuilder, StreamsAreReadAndWrittenInOrder) {
  Builder b(8, 16, 1);  // two lines of references
  b.command.push_at(1, {});
  b.bench.run(100000);
  std::vector<Address> expected;
  const auto stream = [&expected](Address base, int lines) {
    for (int i = 0; i < lines; ++i) expected.push_back(base + static_cast<Address>(i) * 64);
  };
  stream(1 << 20, 8);
  stream(2 << 20, 2);
  stream(2 << 20, 2);
  stream(1 << 20, 8);
  stream(3 << 20, 7);
  stream(4 << 20, 8);
  stream(5 << 20, 8);
  EXPECT_EQ(b.memory.lines(), expected);
}

TEST(TreeBuilder, BuildsAgainWhenAskedAgain) {
  Builder b(8, 16, 1);
  b.command.push_at(1, {}).push_at(5001, {});
  b.bench.run(100000);
  ASSERT_EQ(b.answer.cycles.size(), 2u);
  EXPECT_EQ(b.answer.cycles[1], b.answer.cycles[0] + 5000);
  EXPECT_EQ(counter(b.builder, "triangles"), 16u);
}

}  // namespace
}  // namespace artu::hw::test
