// The tree builder is a cost: its cycles and its traffic are closed forms of what hw/memory/build_plan.h says.
#include "unit/hw/tree_builder_support.h"

namespace artu::hw::test {
namespace {

/// Cycles and lines of a build, summed up by hand.
struct Cost {
  Cycle cycles = 0;
  std::uint64_t read = 0, written = 0;

  Cost& step(Cycle compute, std::uint64_t reads, std::uint64_t writes) {
    const Cycle taken = step_cycles(compute, reads + writes);
    cycles += taken;
    read += reads;
    written += writes;
    return *this;
  }
};

void expect_cost(const TreeBuilderConfig& config, const FrameDescriptor& frame, const Cost& cost) {
  BuilderBench b(config, frame);
  b.bench.run(20000000);
  // The command is there in cycle 2, the answer in the cycle after the last step.
  EXPECT_EQ(b.answer.cycles, std::vector<Cycle>{2 + cost.cycles + 1});
  EXPECT_EQ(b.lines("lines_read"), cost.read);
  EXPECT_EQ(b.lines("lines_written"), cost.written);
  EXPECT_EQ(b.memory.requests.size(), cost.read + cost.written);
  EXPECT_EQ(b.memory.writes(), cost.written);
  EXPECT_EQ(b.lines("triangles"), frame.dynamic_triangle_count);
  Cycle stages = 0;
  for (const char* stage : {"read", "levels", "subtrees", "codes", "sort", "hierarchy", "bounds", "attributes"}) {
    stages += b.lines((std::string("cycles_") + stage).c_str());
  }
  EXPECT_EQ(stages, cost.cycles);
}

class TreeBuilderForm : public testing::TestWithParam<std::uint32_t> {};

TEST_P(TreeBuilderForm, SahSplitsOnChipWhatFitsAndStreamsTheLevelsAbove) {
  const std::uint64_t n = GetParam();
  TreeBuilderConfig config;
  config.triangles_per_pass = 16;
  config.binning_units = 2;
  const FrameDescriptor frame = halved(GetParam(), 16);
  const BuildWork& work = frame.build;
  const bool streamed = n > 16;
  const std::uint64_t references = streamed ? lines_of(16 * n) : 0;
  Cost cost;
  cost.step(n, n, references);
  for (std::uint64_t i = 0; i < work.upper_levels; ++i) {
    const auto share = [&](std::uint64_t total) {
      return total * (i + 1) / work.upper_levels - total * i / work.upper_levels;
    };
    const std::uint64_t lines = lines_of(16 * share(work.upper_references));
    cost.step((4 * share(work.upper_references) + 1) / 2 + 16 * share(work.upper_splits), lines, lines);
  }
  cost.step((4 * (work.references - work.upper_references) + 1) / 2 + 16 * (work.splits - work.upper_splits),
            references + n, (n - 1) + n);
  cost.step(n, n, n);
  expect_cost(config, frame, cost);
}

TEST_P(TreeBuilderForm, MortonSortsInAsManyPassesAsACodeHasDigits) {
  const std::uint64_t n = GetParam();
  struct Codes {
    std::uint32_t bits, digit;
    std::uint64_t passes, key_bytes;
  };
  for (const Codes& codes : {Codes{10, 8, 4, 8}, Codes{10, 10, 3, 8}, Codes{10, 11, 3, 8}, Codes{21, 8, 8, 12},
                             Codes{21, 16, 4, 12}, Codes{11, 1, 33, 12}}) {
    for (const bool known_box : {false, true}) {
      TreeBuilderConfig config;
      config.algorithm = BuildAlgorithm::morton;
      config.triangles_per_pass = 16;
      config.code_bits = codes.bits;
      config.digit_bits = codes.digit;
      config.known_box = known_box;
      config.cycles_per_node = 5;
      config.cycles_per_box = 3;
      const std::uint64_t keys = n > 16 ? lines_of(codes.key_bytes * n) : 0;
      const std::uint64_t skeleton = n > 16 ? lines_of(8 * (n - 1)) : 0;
      Cost cost;
      if (!known_box) cost.step(n, n, 0);
      cost.step(n, n, keys);
      for (std::uint64_t i = 0; i < codes.passes; ++i) cost.step(n + (1u << codes.digit), keys, keys);
      cost.step(5 * (n - 1), keys, skeleton);
      cost.step(3 * 2 * (n - 1), skeleton + n, (n - 1) + n);
      cost.step(n, n, n);
      expect_cost(config, halved(GetParam(), 16), cost);
    }
  }
}

TEST_P(TreeBuilderForm, RefitReadsAndWritesTheNodesOnce) {
  const std::uint64_t n = GetParam();
  TreeBuilderConfig config;
  config.refit = true;
  config.cycles_per_box = 7;
  config.cycles_per_record = 2;
  struct Nodes {
    TreeKind kind;
    std::uint64_t lines;  // of a node
  };
  for (const Nodes& nodes : {Nodes{TreeKind::bvh2, 1}, Nodes{TreeKind::bvh4, 1}, Nodes{TreeKind::bvh8, 2}}) {
    FrameDescriptor frame = halved(GetParam(), config.triangles_per_pass);
    frame.dynamic_refit = 1;
    frame.dynamic_kind = nodes.kind;
    frame.dynamic_node_lines = static_cast<std::uint32_t>((n - 1) * nodes.lines);
    const std::uint64_t lines = frame.dynamic_node_lines;
    expect_cost(config, frame, Cost().step(7 * (n + n - 1), lines + n, lines + n).step(2 * n, n, n));
  }
}

INSTANTIATE_TEST_SUITE_P(Triangles, TreeBuilderForm, testing::Values(1, 2, 3, 15, 16, 17, 32, 33, 100, 1000));

TEST(TreeBuilder, AKdTreesReferencesAreMovedAsOftenAsTheyAre) {
  TreeBuilderConfig config;
  config.triangles_per_pass = 16;
  // 20 triangles: the root has 12 and 18 below, the 18 have 10 and 11, and the runs in the end are 48.
  FrameDescriptor frame = halved(20, 16);
  frame.dynamic_kind = TreeKind::kd;
  frame.dynamic_reference_count = 48;
  frame.dynamic_node_lines = 5;
  frame.build = {11, 2, 120, 20 + 18, 2, 12 + 10 + 11};
  const auto references = [](std::uint64_t count) { return lines_of(16 * count); };
  Cost cost;
  cost.step(20, 20, references(20));
  // Of 38 references read and 18 + 33 written, each level's is half.
  cost.step(4 * 19 + 16, references(19), references(25));
  cost.step(4 * 19 + 16, references(19), references(26));
  cost.step(4 * (120 - 38) + 16 * 9, references(33) + 20, 5 + 48);
  cost.step(20, 20, 20);
  expect_cost(config, frame, cost);
}

TEST(TreeBuilder, OnChipAndOffItIsATriangleApart) {
  for (const BuildAlgorithm algorithm : {BuildAlgorithm::sah, BuildAlgorithm::morton}) {
    TreeBuilderConfig config;
    config.algorithm = algorithm;
    const auto scratch = [&](std::uint32_t n) {
      BuilderBench b(config, halved(n, config.triangles_per_pass));
      b.bench.run(20000000);
      const auto lines = b.memory.lines();
      return std::count_if(lines.begin(), lines.end(),
                           [](Address line) { return line >= scratch_at && line < nodes_at; });
    };
    EXPECT_EQ(scratch(config.triangles_per_pass), 0);
    EXPECT_GT(scratch(config.triangles_per_pass + 1), 0);
  }
}

TEST(TreeBuilder, MoreBinningUnitsTakeASmallerPartOfTheSameWork) {
  TreeBuilderConfig config;
  config.bins = 2;
  const FrameDescriptor frame = halved(1000, config.triangles_per_pass);
  const auto levels = [&](std::uint32_t units) {
    config.binning_units = units;
    BuilderBench b(config, frame);
    b.bench.run(20000000);
    return b.lines("cycles_subtrees") - std::uint64_t{2} * frame.build.splits;
  };
  EXPECT_EQ(levels(1), 4 * frame.build.references);
  EXPECT_EQ(levels(2), (4 * frame.build.references + 1) / 2);
  EXPECT_EQ(levels(4), (4 * frame.build.references + 3) / 4);
}

TEST(TreeBuilder, DoesNothingWithoutACommand) {
  BuilderBench b({}, halved(100, 1024), 10, false);
  b.bench.run(10000);
  EXPECT_TRUE(b.memory.requests.empty());
  EXPECT_TRUE(b.answer.cycles.empty());
  EXPECT_EQ(b.builder.cycles_in(State::busy), 0u);
}

TEST(TreeBuilder, KeepsNoMoreRequestsInFlightThanItMay) {
  TreeBuilderConfig config;
  config.outstanding = 3;
  BuilderBench b(config, halved(64, 1024), 100);
  b.bench.run(100000);
  ASSERT_EQ(b.answer.cycles.size(), 1u);
  // An answer comes 100 cycles after its request's arrival; three requests are less than that apart, a fourth never.
  for (std::size_t i = 3; i < b.memory.cycles.size(); ++i) {
    ASSERT_GE(b.memory.cycles[i], b.memory.cycles[i - 3] + 100);
  }
  EXPECT_EQ(b.memory.cycles[2], b.memory.cycles[0] + 2);
  EXPECT_GT(b.builder.cycles_in(State::stall_mem), 1000u);
}

TEST(TreeBuilder, AStepsStreamsAreInOrderAndAdvanceTogether) {
  TreeBuilderConfig config;
  config.triangles_per_pass = 16;
  BuilderBench b(config, halved(32, 16));
  b.bench.run(100000);
  std::map<Address, std::vector<Address>> by_stream;  // by area
  std::vector<Address> first_step;
  for (const Address line : b.memory.lines()) {
    if (first_step.size() < 32 + 8) first_step.push_back(line);
    by_stream[line >> 20].push_back(line & ((1 << 20) - 1));
  }
  // 32 lines of triangles and 8 of references: four to one, the triangles first.
  for (std::size_t i = 0; i < first_step.size(); ++i) {
    EXPECT_EQ(first_step[i] >> 20, i % 5 == 1 ? 2u : 1u) << i;
  }
  const auto run = [](std::size_t lines, std::size_t from = 0) {
    std::vector<Address> result;
    for (std::size_t i = 0; i < lines; ++i) result.push_back((from + i) * 64);
    return result;
  };
  EXPECT_EQ(by_stream[nodes_at >> 20], run(31));
  EXPECT_EQ(by_stream[triangles_at >> 20], run(32));
  EXPECT_EQ(by_stream[attributes_at >> 20], run(32));
  std::vector<Address> input = run(32);  // the triangles, again, and then the attributes behind them
  const auto again = run(32), attributes = run(32, 32);
  input.insert(input.end(), again.begin(), again.end());
  input.insert(input.end(), attributes.begin(), attributes.end());
  EXPECT_EQ(by_stream[input_at >> 20], input);
  EXPECT_EQ(by_stream[scratch_at >> 20].size(), 8u + 2 * 8u + 8u);
}

TEST(TreeBuilder, BuildsAgainWhenAskedAgain) {
  BuilderBench b({}, halved(8, 1024));
  b.command.push_at(5001, {});
  b.bench.run(100000);
  ASSERT_EQ(b.answer.cycles.size(), 2u);
  EXPECT_EQ(b.answer.cycles[1], b.answer.cycles[0] + 5000);
  EXPECT_EQ(b.lines("triangles"), 16u);
  EXPECT_EQ(b.lines("builds"), 2u);
  EXPECT_EQ(b.lines("refits"), 0u);
}

}  // namespace
}  // namespace artu::hw::test
