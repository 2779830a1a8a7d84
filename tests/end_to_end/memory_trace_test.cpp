// `artu run --memory-trace`, as a strict reader of each format sees it.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct Access {
  std::uint64_t address = 0, cycle = 0;
  bool write = false;
};

class MemoryTraceTest : public ProgramTest {
 protected:
  MemoryTraceTest() { write_scene("tiny.obj"); }

  void run(const std::vector<std::string>& more) const {
    std::vector<std::string> args{"run", "tiny.obj", "--size", "40x30", "-o", "out", "--force", "--quiet"};
    args.insert(args.end(), more.begin(), more.end());
    fine(args);
  }

  /// Every line must be the pattern, to the byte: groups are the address, the word for the direction and the cycle.
  std::vector<Access> parse(const std::string& name, const std::string& pattern, int address, int word,
                            const std::string& write, int cycle = 0) const {
    const std::string text = read(name);
    EXPECT_FALSE(text.empty());
    EXPECT_EQ(text.back(), '\n');
    std::vector<Access> accesses;
    std::istringstream lines(text);
    const std::regex line_pattern(pattern);
    std::smatch match;
    for (std::string line; std::getline(lines, line);) {
      if (!std::regex_match(line, match, line_pattern)) {
        ADD_FAILURE() << "not a line of the format: " << line;
        break;
      }
      accesses.push_back(
          {std::stoull(match[address], nullptr, 16), cycle ? std::stoull(match[cycle]) : 0, match[word] == write});
    }
    return accesses;
  }
  std::vector<Access> dramsim3(const std::string& name) const {
    return parse(name, "0x([1-9a-f][0-9a-f]*) (READ|WRITE) ([1-9][0-9]*)", 1, 2, "WRITE", 3);
  }
  json totals() const { return json::parse(read("out/stats.json")).at("totals"); }
};

std::uint64_t writes(const std::vector<Access>& accesses) {
  return static_cast<std::uint64_t>(
      std::count_if(accesses.begin(), accesses.end(), [](const Access& a) { return a.write; }));
}

TEST_F(MemoryTraceTest, HoldsWhatTheDramCountedWithRisingCycles) {
  run({"--frames", "0:2", "--memory-trace", "m.trace"});
  const std::vector<Access> accesses = dramsim3("m.trace");
  const json dram = totals().at("dram");
  EXPECT_EQ(writes(accesses) * 64, dram.at("write_bytes").get<std::uint64_t>());
  EXPECT_EQ((accesses.size() - writes(accesses)) * 64, dram.at("read_bytes").get<std::uint64_t>());
  std::uint64_t before = 0;
  for (const Access& access : accesses) {
    ASSERT_GT(access.cycle, before) << "one request a clock, frames one after the other";
    before = access.cycle;
    ASSERT_EQ(access.address % 64, 0u);
    ASSERT_GE(access.address, 64u) << "nothing lies at address 0";
    ASSERT_LT(access.address, 1u << 20) << "the image of two triangles and 1200 pixels is smaller than that";
  }
  // 1600 DRAM clocks are 500 of the unit.
  EXPECT_LE(before, totals().at("cycles").get<std::uint64_t>() * 1600 / 500);
}

TEST_F(MemoryTraceTest, TheSecondFrameIsTheFirstOneLaterByItsClocks) {
  run({"--frames", "0:2", "--memory-trace", "both.trace"});
  const json frames = json::parse(read("out/stats.json")).at("frames");
  const std::uint64_t clocks = frames.at(0).at("cycles").get<std::uint64_t>() * 1600 / 500;
  run({"--frames", "0", "--memory-trace", "first.trace"});
  run({"--frames", "1", "--memory-trace", "second.trace"});
  std::vector<Access> expected = dramsim3("first.trace");
  for (Access access : dramsim3("second.trace")) {
    access.cycle += clocks;
    expected.push_back(access);
  }
  const std::vector<Access> both = dramsim3("both.trace");
  ASSERT_EQ(both.size(), expected.size());
  for (std::size_t i = 0; i < both.size(); ++i) {
    ASSERT_TRUE(both[i].address == expected[i].address && both[i].cycle == expected[i].cycle &&
                both[i].write == expected[i].write)
        << i;
  }
}

TEST_F(MemoryTraceTest, AllFormatsHoldTheSameRequests) {
  run({"--memory-trace", "d.trace", "--memory-trace-format", "dramsim3"});
  run({"--memory-trace", "r.trace", "--memory-trace-format", "ramulator"});
  run({"--memory-trace", "r2.trace", "--memory-trace-format", "ramulator2"});
  const std::vector<Access> d = dramsim3("d.trace"), r = parse("r.trace", "0x([1-9a-f][0-9a-f]*) (R|W)", 1, 2, "W"),
                            r2 = parse("r2.trace", "(LD|ST) 0x([1-9a-f][0-9a-f]*)", 2, 1, "ST");
  ASSERT_EQ(d.size(), r.size());
  ASSERT_EQ(d.size(), r2.size());
  for (std::size_t i = 0; i < d.size(); ++i) {
    ASSERT_TRUE(d[i].address == r[i].address && d[i].address == r2[i].address);
    ASSERT_TRUE(d[i].write == r[i].write && d[i].write == r2[i].write);
  }
}

TEST_F(MemoryTraceTest, ChangesNothingElse) {
  run({});
  json without = json::parse(read("out/stats.json"));
  run({"--memory-trace", "m.trace"});
  json with = json::parse(read("out/stats.json"));
  without.erase("simulation");
  with.erase("simulation");
  EXPECT_TRUE(with == without);
}

TEST_F(MemoryTraceTest, BadNamesAndFilesAreRefused) {
  write("old.trace", "precious");
  const auto before = content();
  const std::vector<std::string> run{"run", "tiny.obj", "--size", "8x8", "-o", "new"};
  const auto refuses = [&](const std::vector<std::string>& more, const std::string& text) {
    std::vector<std::string> args = run;
    args.insert(args.end(), more.begin(), more.end());
    EXPECT_THAT(refused(args), HasSubstr(text));
    EXPECT_EQ(content(), before);
  };
  refuses({"--memory-trace", "m.trace", "--memory-trace-format", "usimm"}, "dramsim3, ramulator or ramulator2");
  refuses({"--memory-trace-format", "ramulator"}, "--memory-trace");
  refuses({"--memory-trace", "none/m.trace"}, "none/m.trace");
  refuses({"--memory-trace", "old.trace"}, "--force");
  refuses({"--memory-trace", "/dev/null"}, "/dev/null");
  refuses({"--memory-trace", "same", "--dump-pixels", "same"}, "--dump-pixels");
  EXPECT_EQ(read("old.trace"), "precious");
}

TEST_F(MemoryTraceTest, AnErrorLeavesNothing) {
  const Finished stuck =
      artu({"run", "tiny.obj", "--size", "8x8", "-o", "new", "--memory-trace", "m.trace", "--inject-fault", "dram:3"});
  EXPECT_EQ(stuck.code, 3);
  EXPECT_THAT(content(), ElementsAre("tiny.obj"));
  fine({"run", "tiny.obj", "--size", "8x8", "--memory-trace", "m.trace", "--dry-run"});
  EXPECT_THAT(content(), ElementsAre("tiny.obj"));
}

}  // namespace
}  // namespace artu::test
