// `artu explain` as a program: a run's folder and a scene say the same; what is advised is simulated; bad input.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;
using Json = nlohmann::json;

class ExplainTest : public ProgramTest {
 protected:
  void SetUp() override { write_scene("tiny.obj"); }
};

TEST_F(ExplainTest, AFolderAndItsSceneSayTheSameInFiveLines) {
  fine({"run", "tiny.obj", "--size", "64x48", "--frames", "0:2", "--set", "core.count=1", "-o", "a"});
  const Finished folder = fine({"explain", "a"});
  EXPECT_EQ(std::count(folder.out.begin(), folder.out.end(), '\n'), 5);
  EXPECT_THAT(folder.out, StartsWith("bottleneck  "));
  for (const char* line : {"\ntime        ", "\nbeside it   ", "\nturn        ", "\nor          "}) {
    EXPECT_THAT(folder.out, HasSubstr(line));
  }
  EXPECT_EQ(fine({"explain", "tiny.obj", "--size", "64x48", "--frames", "0:2", "--set", "core.count=1"}).out,
            folder.out);
  EXPECT_EQ(
      fine({"explain", "tiny.obj", "--size", "64x48", "--frames", "0:2", "--set", "core.count=1", "--jobs", "2"}).out,
      folder.out);
}

TEST_F(ExplainTest, WhatIsAdvisedIsSimulated) {
  fine({"run", "tiny.obj", "--size", "64x48", "--set", "core.count=1", "--set", "core.contexts=2", "-o", "a"});
  const Json json = Json::parse(fine({"explain", "a", "--verify", "--json"}).out);
  EXPECT_EQ(json.at("schema"), 1);
  EXPECT_EQ(json.at("bottlenecks").at(0).at("name"), "pipeline latency");
  const Json& advice = json.at("advice").at(0);
  EXPECT_EQ(advice.at("parameter"), "core.contexts");
  EXPECT_EQ(advice.at("from"), "2");
  EXPECT_EQ(advice.at("to"), "4");
  fine({"run", "tiny.obj", "--size", "64x48", "--set", "core.count=1", "--set", "core.contexts=4", "-o", "b"});
  EXPECT_EQ(advice.at("measured"), Json::parse(read("b/stats.json")).at("totals").at("cycles"));
  EXPECT_LT(advice.at("measured"), json.at("cycles"));
  EXPECT_GE(advice.at("measured"), advice.at("floor"));
  EXPECT_THAT(fine({"explain", "a", "--verify"}).out, HasSubstr("\nmeasured    core.contexts = 4: "));
}

/// Beside the passes the builder can bind them as well.
TEST_F(ExplainTest, ABuildBesideThePassesIsNamedAndRelieved) {
  const std::string scene = ARTU_SOURCE_DIR "/scripts/scenes/adversarial.gltf";
  const std::vector<std::string> slow{"--frames", "10", "--size", "32x18", "--set", "tree_builder.cycles_per_bin=64"};
  const auto of = [&](const std::string& command, const std::vector<std::string>& more) {
    std::vector<std::string> args{command, scene};
    args.insert(args.end(), slow.begin(), slow.end());
    args.insert(args.end(), more.begin(), more.end());
    return fine(args).out;
  };
  const std::vector<std::string> overlap{"--set", "tree_builder.overlap=true"};
  const Json json = Json::parse(of("explain", {overlap[0], overlap[1], "--verify", "--json"}));
  EXPECT_EQ(json.at("bottlenecks").at(0).at("name"), "tree build");
  const Json& advice = json.at("advice").at(0);
  EXPECT_EQ(advice.at("parameter"), "tree_builder.cycles_per_bin");
  EXPECT_LT(advice.at("measured"), 0.7 * json.at("cycles").get<double>());
  EXPECT_GE(advice.at("measured"), advice.at("floor"));
  // Nor is overlap advised where the build is nearly all there is.
  EXPECT_THAT(of("explain", {}), Not(HasSubstr("tree_builder.overlap")));
  // A run says the same, in both modes that have cycles.
  for (const std::string mode : {"event", "analytic"}) {
    of("run", {overlap[0], overlap[1], "--fidelity", mode, "-o", mode});
    const Json stats = Json::parse(read(mode + "/stats.json"));
    EXPECT_EQ(stats.at("demand").at("bottleneck"), "build, start and write-back") << mode;
    EXPECT_EQ(stats.at("totals").at("blocks").at("control_unit").at("cycles_build"), 0) << mode;
  }
}

TEST_F(ExplainTest, BadInputIsRefused) {
  fine({"run", "tiny.obj", "--size", "8x8", "-o", "a"});
  fine({"run", "tiny.obj", "--size", "8x8", "-o", "f", "--fidelity", "functional"});
  fine({"run", "tiny.obj", "--size", "8x8", "-o", "s", "--random-stall"});
  EXPECT_THAT(refused({"explain", "none"}), HasSubstr("none"));
  EXPECT_THAT(refused({"explain", "."}), HasSubstr("stats.json: is not there"));
  EXPECT_THAT(refused({"explain", "f"}), HasSubstr("error: f: functional does not count"));
  EXPECT_THAT(refused({"explain", "f"}), HasSubstr("--fidelity event would be right"));
  EXPECT_THAT(refused({"explain", "a", "--frames", "1"}), HasSubstr("a: is a run's folder"));
  EXPECT_THAT(refused({"explain", "a", "--set", "core.count=2"}), HasSubstr("a: is a run's folder"));
  EXPECT_THAT(refused({"explain", "s", "--verify"}), HasSubstr("--random-stall"));
  const std::string stats = read("a/stats.json"), config = read("a/config.toml");
  write("a/stats.json", stats.substr(0, stats.size() / 2));
  EXPECT_THAT(refused({"explain", "a"}), HasSubstr("a/stats.json: is not JSON"));
  write("a/stats.json", "{\"schema\": 99}\n");
  EXPECT_THAT(refused({"explain", "a"}), HasSubstr("a/stats.json: has schema 99"));
  Json fewer = Json::parse(stats);
  fewer["totals"]["blocks"].erase("dram");
  write("a/stats.json", fewer.dump());
  EXPECT_THAT(refused({"explain", "a"}), HasSubstr("no block dram"));
  write("a/stats.json", stats);
  write("a/config.toml", "[core]\ncuont = 3\n");
  EXPECT_THAT(refused({"explain", "a"}), HasSubstr("a/config.toml:2"));
  write("a/config.toml", config);
  EXPECT_THAT(fine({"explain", "a"}).err, IsEmpty());
  write("tiny.obj", read("tiny.obj") + "# changed\n");
  EXPECT_THAT(refused({"explain", "a", "--verify"}), HasSubstr("tiny.obj: is not what a was run on"));
}

}  // namespace
}  // namespace artu::test
