// What a user sees when the unit is wrong or stuck: exit codes 1 and 3, and the field or the block that is at fault.
#include <gmock/gmock.h>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using ::testing::HasSubstr;

class FaultTest : public ProgramTest {
 protected:
  const std::string sample_ = std::string(ARTU_SOURCE_DIR) + "/traces/samples/scene.artu";

  /// The line of the first mismatch's table that is marked as differing in `field`.
  void expect_named(const std::string& fault, const std::string& field, const std::vector<std::string>& more = {}) {
    std::vector<std::string> args{"check", sample_, "--inject-fault", fault};
    args.insert(args.end(), more.begin(), more.end());
    const Finished run = artu(args);
    EXPECT_EQ(run.code, 1) << fault << "\n" << run.out << run.err;
    EXPECT_THAT(run.out + run.err, testing::ContainsRegex("\\* *" + field)) << fault;
  }
};

TEST_F(FaultTest, WithoutOneTheCheckPasses) { fine({"check", sample_}); }

TEST_F(FaultTest, BoxIsSeenInTheHitClass) { expect_named("box:31", "class"); }

TEST_F(FaultTest, TriangleIsSeenInT) { expect_named("triangle:0", "t_bits", {"--set", "selective.enabled=false"}); }

TEST_F(FaultTest, ShadingIsSeenInTheColour) { expect_named("shading:7", "colour"); }

TEST_F(FaultTest, InterpolationIsSeenInTheColour) { expect_named("interpolation:0", "colour"); }

TEST_F(FaultTest, ThresholdIsSeenInTheThreshold) { expect_named("threshold:0", "threshold"); }

TEST_F(FaultTest, WhatCannotBeInjectedIsRefused) {
  EXPECT_THAT(refused({"check", sample_, "--inject-fault", "memory"}), HasSubstr("box, triangle"));
  EXPECT_THAT(refused({"check", sample_, "--inject-fault", "threshold:8"}), HasSubstr("threshold:7"));
  EXPECT_THAT(refused({"check", sample_, "--inject-fault", "box:"}), HasSubstr("box:31"));
}

TEST_F(FaultTest, AReportOfAMismatchIsKept) {
  const Finished run = artu({"check", sample_, "--inject-fault", "shading", "-o", "out"});
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(read("out/stats.json"), HasSubstr("\"check\""));
  EXPECT_THAT(read("out/manifest.json"), HasSubstr("\"falsified\": true"));
  fine({"run", sample_, "-o", "sound"});
  EXPECT_THAT(read("sound/manifest.json"), HasSubstr("\"falsified\": false"));
}

TEST_F(FaultTest, AUnitThatDoesNotMoveIsStopped) {
  const Finished run = artu({"run", sample_, "-o", "out", "--inject-fault", "dram:0"});
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("dead-lock"));
  EXPECT_THAT(run.err, HasSubstr("control_unit: stall_mem; reads the descriptor"));
  EXPECT_FALSE(exists("out")) << "a report of a run that did not end";
  // Ticking every block in every cycle, it is the watchdog that finds it.
  EXPECT_EQ(artu({"run", sample_, "-o", "out", "--inject-fault", "dram:0", "--fidelity", "clocked", "--set",
                  "unit.watchdog=5000"})
                .code,
            3);
}

}  // namespace
}  // namespace artu::test
