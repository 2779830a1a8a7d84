// `artu bench` as a user sees it.
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsSupersetOf;

class BenchTest : public ProgramTest {
 protected:
  BenchTest() { write_scene("tiny.obj"); }
};

TEST_F(BenchTest, EveryModeOfEverySceneHasARow) {
  std::filesystem::create_directory(path("more"));
  write_scene("more/b.obj");
  write("more/readme.txt", "no scene");
  const Finished bench = fine({"bench", "tiny.obj", "more", "--size", "16x12", "--repeats", "2", "--no-growth",
                               "--fidelity", "clocked,golden,event,functional", "-o", "out"});
  EXPECT_THAT(bench.out, HasSubstr("tiny.obj, frame 0, 16x12, 3 triangles"));
  EXPECT_THAT(bench.out, HasSubstr("all scenes"));
  EXPECT_THAT(content("out"),
              IsSupersetOf({"bench.csv", "bench.json", "bench.txt", "config.toml", "growth.csv", "manifest.json"}));
  const auto rows = csv("out/bench.csv");
  ASSERT_EQ(rows.size(), 9u);
  const char* modes[] = {"golden", "functional", "event", "clocked"};
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i][0], i < 5 ? "\"tiny.obj\"" : "\"b.obj\"");
    EXPECT_EQ(rows[i][5], modes[(i - 1) % 4]);
    EXPECT_GT(std::stod(rows[i][6]), 0);
  }
  const auto json = nlohmann::json::parse(read("out/bench.json"));
  fine({"run", "tiny.obj", "--size", "16x12", "-o", "run"});
  const auto run = nlohmann::json::parse(read("run/stats.json")).at("totals");
  for (const std::size_t exact : {2u, 3u}) {
    const auto& mode = json.at("scenes").at(0).at("modes").at(exact);
    EXPECT_EQ(mode.at("cycles"), run.at("cycles"));
    EXPECT_EQ(mode.at("error"), 0);
    EXPECT_EQ(mode.at("node_visits"), run.at("node_visits"));
    EXPECT_EQ(mode.at("rounds").size(), 2u);
  }
}

TEST_F(BenchTest, WithoutAListAllModesOfAFrameAreMeasured) {
  fine({"bench", "tiny.obj", "--size", "8x8", "--repeats", "1", "--no-growth", "-o", "out"});
  const auto rows = csv("out/bench.csv");
  const char* modes[] = {"golden", "functional", "analytic", "event", "clocked"};
  ASSERT_EQ(rows.size(), 1 + std::size(modes));
  for (std::size_t i = 0; i < std::size(modes); ++i) EXPECT_EQ(rows[i + 1][5], modes[i]);
}

TEST_F(BenchTest, ATraceIsMeasuredAtItsOwnSize) {
  fine({"import", "tiny.obj", "--size", "8x8", "--frames", "2:4", "-o", "tiny.artu"});
  const Finished bench = fine({"bench", "tiny.artu", "--repeats", "1", "--fidelity", "event", "-o", "out"});
  EXPECT_THAT(bench.out, HasSubstr("tiny.artu, frame 2, 8x8"));
  EXPECT_THAT(bench.err, HasSubstr("growth is not measured"));
}

TEST_F(BenchTest, BadInputIsRefused) {
  std::filesystem::create_directory(path("empty"));
  const auto before = content();
  EXPECT_THAT(refused({"bench", "none.obj"}), HasSubstr("none.obj: no such file"));
  EXPECT_THAT(refused({"bench", "empty"}), HasSubstr("empty: holds no scene"));
  EXPECT_THAT(refused({"bench", "tiny.obj", "--fidelity", "guess"}),
              HasSubstr("\"guess\" is none; golden, functional,"));
  EXPECT_THAT(refused({"bench", "tiny.obj", "--fidelity", "event,sampled"}), HasSubstr("artu sampling"));
  EXPECT_THAT(refused({"bench", "tiny.obj", "--fidelity", "event,"}), HasSubstr("--fidelity"));
  EXPECT_THAT(refused({"bench", "tiny.obj", "--repeats", "0"}), HasSubstr("--repeats"));
  EXPECT_THAT(refused({"bench", "tiny.obj", "--size", "8"}), HasSubstr("640x360"));
  EXPECT_THAT(refused({"bench", "tiny.obj", "--set", "core.count=0"}), HasSubstr("core.count"));
  EXPECT_EQ(content(), before);
}

}  // namespace
}  // namespace artu::test
