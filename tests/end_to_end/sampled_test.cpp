// --fidelity sampled: what it reports, that its frames are event's, and what it refuses.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class SampledTest : public ProgramTest {
 protected:
  SampledTest() { write_scene("tiny.obj"); }

  json stats(const std::string& folder) const { return json::parse(read(folder + "/stats.json")); }
  json manifest(const std::string& folder) const { return json::parse(read(folder + "/manifest.json")); }
  void run(const std::string& folder, const std::vector<std::string>& more, const std::string& frames = "30:54") const {
    std::vector<std::string> args = {"run", stage_, "--size", "24x16", "--frames", frames, "-o", folder};
    args.insert(args.end(), more.begin(), more.end());
    fine(args);
  }

  const std::string stage_ = std::string(ARTU_SOURCE_DIR) + "/scripts/scenes/default.stage.toml";
};

TEST_F(SampledTest, TheWholeShareIsEvent) {
  run("event", {}, "30:36");
  run("sampled", {"--fidelity", "sampled", "--sample-share", "100%"}, "30:36");
  const json a = stats("event"), b = stats("sampled");
  EXPECT_EQ(a.at("frames"), b.at("frames"));
  EXPECT_EQ(a.at("energy"), b.at("energy"));
  json totals = b.at("totals");
  for (const auto& [name, estimate] : totals.at("estimates").items()) {
    if (name == "blocks") continue;
    EXPECT_EQ(estimate.at("low"), estimate.at("high")) << name;
  }
  EXPECT_EQ(totals.at("estimates").at("cycles").at("value"), a.at("totals").at("cycles").get<double>());
  totals.erase("estimates");
  EXPECT_EQ(totals, a.at("totals"));
}

TEST_F(SampledTest, SimulatedFramesAreEventsAndOthersAreEstimated) {
  run("event", {});
  run("sampled", {"--fidelity", "sampled", "--sample-share", "25%", "--check", "--jobs", "2"});
  const json a = stats("event"), b = stats("sampled");
  const auto simulated = manifest("sampled").at("simulated_frames").get<std::vector<std::uint32_t>>();
  EXPECT_GE(simulated.size(), 6u);
  EXPECT_LE(simulated.size(), 10u);
  ASSERT_EQ(b.at("frames").size(), simulated.size());
  for (std::size_t i = 0; i < simulated.size(); ++i) {
    const std::uint32_t index = simulated[i];
    EXPECT_EQ(b.at("frames").at(i), a.at("frames").at(index - 30));
    const std::string picture = "frame_00" + std::to_string(index) + ".png";
    EXPECT_TRUE(read("sampled/" + picture) == read("event/" + picture)) << picture;
  }
  EXPECT_EQ(b.at("totals").at("frames"), 24);
  EXPECT_EQ(b.at("totals").at("pixels").at("total"), 24 * 24 * 16);
  EXPECT_EQ(b.at("fidelity").at("mode"), "sampled");
  EXPECT_TRUE(b.at("check").at("passed"));
  const json& estimates = b.at("totals").at("estimates");
  for (const char* name : {"cycles", "rays.primary", "rays.shadow", "node_visits", "triangle_tests", "dram.read_bytes",
                           "dram.write_bytes", "energy.frame_uj"}) {
    EXPECT_LE(estimates.at(name).at("low"), estimates.at(name).at("value")) << name;
    EXPECT_LE(estimates.at(name).at("value"), estimates.at(name).at("high")) << name;
  }
  for (const auto& [block, counters] : b.at("totals").at("blocks").items()) {
    for (const auto& [name, value] : counters.items()) {
      if (estimates.at("blocks").at(block).contains(name)) continue;
      EXPECT_THAT(name, ::testing::AnyOf(HasSubstr("peak"), HasSubstr("max"))) << block;
    }
  }
  const double cycles = a.at("totals").at("cycles"), estimate = estimates.at("cycles").at("value");
  EXPECT_NEAR(estimate / cycles, 1, 0.03);
}

TEST_F(SampledTest, DependsOnTheSeedAlone) {
  for (const char* name : {"a", "b", "c"}) {
    run(name, {"--fidelity", "sampled", "--target-error", "50%", "--pictures", "none", "--seed",
               name == std::string("c") ? "2" : "1", "--jobs", name == std::string("b") ? "2" : "1"});
  }
  json a = stats("a"), b = stats("b"), c = stats("c");
  EXPECT_NE(manifest("a").at("simulated_frames"), manifest("c").at("simulated_frames"));
  EXPECT_EQ(manifest("a").at("simulated_frames"), manifest("b").at("simulated_frames"));
  EXPECT_NE(a.at("totals"), c.at("totals"));
  for (json* j : {&a, &b}) j->erase("simulation");
  EXPECT_EQ(a, b);
}

TEST_F(SampledTest, ASmallerErrorTakesMoreFrames) {
  run("coarse", {"--fidelity", "sampled", "--target-error", "50%", "--pictures", "none"});
  run("fine", {"--fidelity", "sampled", "--target-error", "0.01%", "--pictures", "none"});
  EXPECT_LT(manifest("coarse").at("simulated_frames").size(), manifest("fine").at("simulated_frames").size());
  const json cycles = stats("fine").at("totals").at("estimates").at("cycles");
  const double low = cycles.at("low"), high = cycles.at("high"), value = cycles.at("value");
  EXPECT_LE((high - low) / 2, 0.0001 * value);
}

TEST_F(SampledTest, FramesThatAreEqualNeedNoMore) {
  // In the first one the unit is told that geometry may have moved.
  const Finished out = fine({"run", "tiny.obj", "--size", "16x16", "--frames", "0:40", "-o", "out", "--fidelity",
                             "sampled", "--pictures", "none"});
  EXPECT_THAT(out.out, HasSubstr("sample      2 frames simulated for all 40, of which 2 are different"));
  const json cycles = stats("out").at("totals").at("estimates").at("cycles");
  EXPECT_EQ(cycles.at("low"), cycles.at("high"));
  fine({"run", "tiny.obj", "--size", "16x16", "--frames", "0:40", "-o", "event", "--pictures", "none"});
  EXPECT_EQ(stats("out").at("totals").at("cycles"), stats("event").at("totals").at("cycles"));
}

/// It swings to and fro twice a second, at times that are exact: 16 frames, of which seven are as on the way back.
TEST_F(SampledTest, AnAnimationThatRepeatsIsSampledOnce) {
  write("swing.stage.toml", R"([[file]]
path = "tiny.obj"
[[file.key]]
time = 0
position = [0, 0, 0]
[[file.key]]
time = 0.25
position = [0.2, 0, 0]
[[file.key]]
time = 0.5
position = [0, 0, 0]
)");
  const auto simulate = [this](const std::string& folder, const std::vector<std::string>& more) {
    std::vector<std::string> args = {"run", "swing.stage.toml", "--size", "24x16", "--frames", "3:67", "--fps",
                                     "32",  "--pictures",       "none",   "-o",    folder};
    args.insert(args.end(), more.begin(), more.end());
    fine(args);
  };
  simulate("event", {});
  simulate("all", {"--fidelity", "sampled", "--sample-share", "100%", "--jobs", "2"});
  EXPECT_EQ(manifest("all").at("different_frames"), 9);
  EXPECT_EQ(manifest("all").at("simulated_frames").size(), 9u);
  const json a = stats("event").at("totals");
  json b = stats("all").at("totals");
  b.erase("estimates");
  EXPECT_EQ(a, b) << "frames that are not simulated are equal to others";
  // With refit a tree may depend on the frames before it.
  simulate("refit", {"--fidelity", "sampled", "--sample-share", "10%", "--set", "tree_builder.refit=true"});
  EXPECT_EQ(manifest("refit").at("different_frames"), 64);
}

TEST_F(SampledTest, SamplingPrintsHowRightItIs) {
  const Finished out = fine({"sampling", stage_, "--size", "16x12", "--frames", "30:50", "--trials", "20", "--quiet"});
  EXPECT_THAT(out.out, HasSubstr("20 trials; a sample has "));
  EXPECT_THAT(out.out, HasSubstr(" of 20 frames"));
  for (const char* name : {"cycles", "node visits", "DRAM reads", "energy"}) EXPECT_THAT(out.out, HasSubstr(name));
  EXPECT_THAT(content(), ::testing::ElementsAre("tiny.obj"));
}

TEST_F(SampledTest, BadOptionsAreRefused) {
  const auto refuse = [this](const std::vector<std::string>& more) {
    std::vector<std::string> args = {"run", "tiny.obj", "--frames", "0:20", "-o", "out"};
    args.insert(args.end(), more.begin(), more.end());
    return refused(args);
  };
  EXPECT_THAT(refuse({"--sample-share", "5%"}), HasSubstr("--sample-share: is of --fidelity sampled"));
  EXPECT_THAT(refuse({"--target-error", "5%", "--fidelity", "event"}), HasSubstr("--target-error: is of"));
  for (const char* share : {"5", "0%", "-1%", "101%", "%", "nan%", "x%", ""}) {
    EXPECT_THAT(refuse({"--fidelity", "sampled", "--sample-share", share}), HasSubstr("would be right")) << share;
    EXPECT_THAT(refuse({"--fidelity", "sampled", "--target-error", share}), HasSubstr("would be right")) << share;
  }
  EXPECT_THAT(refuse({"--fidelity", "sampled", "--target-error", "1%", "--sample-share", "5%"}),
              HasSubstr("--sample-share"));
  EXPECT_THAT(refuse({"--fidelity", "sampled", "--random-stall"}), HasSubstr("--random-stall"));
  EXPECT_THAT(refuse({"--fidelity", "sampled", "--memory-trace", "t"}), HasSubstr("--memory-trace"));
  EXPECT_THAT(refuse({"--fidelity", "sampled", "--pictures", "animation"}), HasSubstr("animation"));
  EXPECT_FALSE(exists("out"));
}

}  // namespace
}  // namespace artu::test
