// `artu run --timeline`: the same however the unit is simulated, adds up to the counters, changes nothing else.
#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "end_to_end/program.h"
#include "sim/report/cycle_table.h"

namespace artu::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

const std::vector<std::string> states{"busy", "stall_in", "stall_out", "stall_mem", "idle"};

class TimelineTest : public ProgramTest {
 protected:
  void SetUp() override {
    write_scene("tiny.obj");
    write("moving.stage.toml",
          "[[file]]\npath = \"tiny.obj\"\n[[file.key]]\ntime = 0\n[[file.key]]\ntime = 1\nposition = [6, 0, 0]\n");
  }
  void run(const std::string& folder, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"run",
                                   "moving.stage.toml",
                                   "--size",
                                   "48x32",
                                   "--frames",
                                   "0:3",
                                   "-o",
                                   folder,
                                   "--quiet",
                                   "--set",
                                   "core.count=2",
                                   "--set",
                                   "memory.dram.clock_mhz=933"};
    words.insert(words.end(), more.begin(), more.end());
    fine(words);
  }
  json parsed(const std::string& file) const { return json::parse(read(file)); }
};

std::uint64_t sum(const json& values) {
  std::uint64_t all = 0;
  for (const json& value : values) all += value.get<std::uint64_t>();
  return all;
}

TEST_F(TimelineTest, IsTheSameHoweverTheUnitIsSimulated) {
  run("event", {"--timeline"});
  run("clocked", {"--timeline", "--fidelity", "clocked"});
  run("shuffled", {"--timeline", "--shuffle", "--jobs", "3"});
  run("clocked-shuffled", {"--timeline", "--fidelity", "clocked", "--shuffle", "--seed", "7"});
  const std::string timeline = read("event/timeline.json");
  for (const char* other : {"clocked", "shuffled", "clocked-shuffled"}) {
    EXPECT_EQ(timeline, read(std::string(other) + "/timeline.json")) << other;
  }
}

TEST_F(TimelineTest, ChangesNothingElse) {
  run("with", {"--timeline"});
  run("without");
  auto files = content("with");
  files.erase(std::find(files.begin(), files.end(), "timeline.json"));
  ASSERT_EQ(files, content("without"));
  for (const std::string& file : files) {
    if (file == "manifest.json" || file == "stats.json" || file == "stats.txt") continue;
    EXPECT_EQ(read("with/" + file), read("without/" + file)) << file;
  }
  json with = parsed("with/stats.json"), without = parsed("without/stats.json");
  with.erase("simulation");
  without.erase("simulation");
  EXPECT_EQ(with, without);
}

TEST_F(TimelineTest, AddsUpToTheCounters) {
  for (const std::string overlap : {"false", "true"}) {
    run(overlap, {"--timeline", "--set", "selective.overlap=" + overlap});
    const json timeline = parsed(overlap + "/timeline.json"), stats = parsed(overlap + "/stats.json");
    ASSERT_EQ(timeline["frames"].size(), 3u);
    for (std::size_t f = 0; f < 3; ++f) {
      const json &frame = timeline["frames"][f], &counters = stats["frames"][f];
      EXPECT_EQ(frame["cycles"], counters["cycles"]);
      EXPECT_EQ(frame["at"].back(), counters["cycles"]);
      std::map<std::string, std::map<std::string, std::uint64_t>> sums;
      for (const auto& [block, values] : counters["blocks"].items()) {
        for (const std::string& state : states)
          sums[sim::without_number(block)][state] += values[state].get<std::uint64_t>();
      }
      EXPECT_EQ(frame["blocks"].size(), sums.size());
      for (const auto& [block, of] : sums) {
        for (const auto& [state, cycles] : of) {
          EXPECT_EQ(sum(frame["blocks"][block][state]), cycles) << block << " " << state;
          std::uint64_t phases = 0;
          for (const json& phase : frame["phases"]) phases += phase["blocks"][block][state].get<std::uint64_t>();
          EXPECT_EQ(phases, cycles) << block << " " << state;
        }
      }
      EXPECT_EQ(sum(frame["counts"]["read_bytes"]), counters["dram"]["read_bytes"]);
      EXPECT_EQ(sum(frame["counts"]["write_bytes"]), counters["dram"]["write_bytes"]);
      EXPECT_EQ(sum(frame["counts"]["rays_finished"]), sum(counters["rays"]));
      EXPECT_EQ(sum(frame["counts"]["rays_begun"]), sum(counters["rays"]));
      std::uint64_t visits = 0;
      for (const auto& [kind, rays] : frame["visits"].items()) {
        EXPECT_EQ(sum(rays), counters["rays"][kind]) << kind;
        for (std::size_t n = 0; n < rays.size(); ++n) visits += n * rays[n].get<std::uint64_t>();
      }
      EXPECT_EQ(visits, counters["node_visits"]);
      for (const json& phase : frame["phases"]) {
        EXPECT_EQ(phase["to"].get<std::uint64_t>() - phase["from"].get<std::uint64_t>(),
                  counters["blocks"]["control_unit"]["cycles_" + phase["phase"].get<std::string>()]);
      }
    }
  }
}

TEST_F(TimelineTest, HasABoundedNumberOfEquidistantLooks) {
  run("out", {"--timeline"});
  const json timeline = parsed("out/timeline.json");
  ASSERT_EQ(timeline["frames"].size(), 3u);
  for (const json& frame : timeline["frames"]) {
    const json& at = frame["at"];
    const std::uint64_t interval = frame["interval"];
    ASSERT_GT(frame["cycles"], 16u * 300) << "a frame that has to forget looks";
    EXPECT_LE(at.size(), 300u);
    EXPECT_GE(at.size(), 150u);
    for (std::size_t i = 0; i + 1 < at.size(); ++i) ASSERT_EQ(at[i], interval * (i + 1));
    for (const auto& [name, channel] : frame["channels"].items()) {
      ASSERT_EQ(channel["level"].size(), at.size());
      for (const json& level : channel["level"]) EXPECT_LE(level, channel["capacity"]) << name;
    }
  }
}

TEST_F(TimelineTest, ADeadLockIsStillFound) {
  for (const char* mode : {"event", "clocked"}) {
    const Finished result = artu({"run", "moving.stage.toml", "--size", "48x32", "-o", "out", "--timeline",
                                  "--fidelity", mode, "--inject-fault", "dram:1"});
    EXPECT_EQ(result.code, 3) << mode << result.err;
    EXPECT_FALSE(exists("out"));
  }
}

TEST_F(TimelineTest, IsRefusedWhereThereAreNoCycles) {
  for (const char* mode : {"functional", "analytic", "sampled"}) {
    EXPECT_THAT(refused({"run", "tiny.obj", "--timeline", "--fidelity", mode}),
                HasSubstr("--timeline: is about cycles"));
  }
  EXPECT_THAT(refused({"check", "tiny.obj", "--timeline"}), HasSubstr("--timeline: there is no folder for it"));
}

}  // namespace
}  // namespace artu::test
