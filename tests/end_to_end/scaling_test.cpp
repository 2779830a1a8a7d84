// `artu scaling` as a user sees it.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using ::testing::HasSubstr;

class ScalingTest : public ProgramTest {
 protected:
  ScalingTest() { write_scene("tiny.obj"); }
};

TEST_F(ScalingTest, EveryValueHasTheCyclesOfARunOfItsOwn) {
  const Finished scaling = fine({"scaling", "tiny.obj", "--size", "32x24", "--vary", "core.count=1,3", "-o", "out"});
  EXPECT_THAT(scaling.out, HasSubstr("core.count"));
  EXPECT_THAT(scaling.out, HasSubstr("limited by"));
  const auto rows = csv("out/scaling.csv");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0][0], "core.count");
  for (std::size_t i : {1u, 2u}) {
    const std::string folder = "run" + std::to_string(i);
    fine({"run", "tiny.obj", "--size", "32x24", "--set", "core.count=" + rows[i][0], "-o", folder});
    EXPECT_EQ(rows[i][1], nlohmann::json::parse(read(folder + "/stats.json")).at("totals").at("cycles").dump());
  }
  EXPECT_EQ(rows[1][2], "1");
  EXPECT_DOUBLE_EQ(std::stod(rows[2][2]), std::stod(rows[1][1]) / std::stod(rows[2][1]));
}

/// A faster clock needs more cycles for the same memory, and yet less time.
TEST_F(ScalingTest, ASpeedUpIsOfTime) {
  fine({"scaling", "tiny.obj", "--size", "32x24", "--vary", "unit.clock_mhz=250,1000", "-o", "out"});
  const auto rows = csv("out/scaling.csv");
  EXPECT_GT(std::stod(rows[2][1]), std::stod(rows[1][1]));
  EXPECT_DOUBLE_EQ(std::stod(rows[2][2]), 4 * std::stod(rows[1][1]) / std::stod(rows[2][1]));
  EXPECT_GT(std::stod(rows[2][2]), 1);
}

/// A name with a comma, as a spreadsheet reads it.
TEST_F(ScalingTest, ALimitOfSeveralWordsIsOneField) {
  const std::string scene = ARTU_SOURCE_DIR "/scripts/scenes/adversarial.gltf";
  fine({"scaling", scene, "--frames", "10", "--size", "8x8", "--set", "tree_builder.cycles_per_bin=64", "--vary",
        "core.count=1,2", "-o", "out"});
  EXPECT_THAT(read("out/scaling.csv"), HasSubstr(",\"build, start and write-back\"\n"));
}

TEST_F(ScalingTest, NoDemandIsMoreThanThereIs) {
  fine({"scaling", "tiny.obj", "--size", "32x24", "--vary", "core.box_testers=1,2,8", "-o", "out"});
  const auto rows = csv("out/scaling.csv");
  ASSERT_EQ(rows.size(), 4u);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    for (std::size_t column = 6; column + 1 < rows[0].size(); ++column) {
      EXPECT_GE(std::stod(rows[i][column]), 0) << rows[0][column];
      EXPECT_LE(std::stod(rows[i][column]), 1) << rows[0][column];
    }
  }
}

TEST_F(ScalingTest, UnitsCanBeScreenedWithEstimates) {
  const Finished scaling = fine(
      {"scaling", "tiny.obj", "--size", "32x24", "--vary", "core.count=1,3", "--fidelity", "analytic", "-o", "out"});
  EXPECT_THAT(scaling.out, HasSubstr("cycles estimated (analytic)"));
  const auto rows = csv("out/scaling.csv");
  fine({"run", "tiny.obj", "--size", "32x24", "--set", "core.count=3", "--fidelity", "analytic", "-o", "run"});
  EXPECT_EQ(rows[2][1], nlohmann::json::parse(read("run/stats.json")).at("totals").at("cycles").dump());
  EXPECT_THAT(refused({"scaling", "tiny.obj", "--fidelity", "functional", "-o", "none"}), HasSubstr("functional"));
}

TEST_F(ScalingTest, BadVariationsAreRefused) {
  for (const char* bad : {"core.count", "=1,2", "core.count=", "core.count=1,,2", "core.count=1,"}) {
    const Finished run = artu({"scaling", "tiny.obj", "--vary", bad, "-o", "out"});
    EXPECT_EQ(run.code, 2) << bad;
    EXPECT_THAT(run.err, HasSubstr("core.count=1,2,4 would be right")) << bad;
  }
  const Finished unknown = artu({"scaling", "tiny.obj", "--vary", "core.cuont=1,2", "-o", "out"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("did you mean core.count?"));
  const Finished range = artu({"scaling", "tiny.obj", "--vary", "core.count=1,65", "-o", "out"});
  EXPECT_EQ(range.code, 2);
  EXPECT_THAT(range.err, HasSubstr("error: --vary: core.count = 65 is out of range"));
  const auto bad = [this](const std::string& variation) {
    return refused({"scaling", "tiny.obj", "--vary", variation, "-o", "out"});
  };
  EXPECT_THAT(bad("foo=1"), HasSubstr("error: --vary: unknown parameter foo"));
  EXPECT_THAT(bad("core.count=4,1,4"), HasSubstr("--vary: core.count has the value 4 twice; once would be right"));
  EXPECT_THAT(bad("memory.l2.size=64KiB,65536"), HasSubstr("memory.l2.size has the value 65536 twice"));
  EXPECT_THAT(content(), ::testing::ElementsAre("tiny.obj"));
}

}  // namespace
}  // namespace artu::test
