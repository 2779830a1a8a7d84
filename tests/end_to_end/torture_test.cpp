// `artu torture` as a user sees it: what it draws is fine, and what is broken is found and made small.
#include <gmock/gmock.h>

#include <regex>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

class TortureTest : public ProgramTest {};

TEST_F(TortureTest, DrawnUnitsAndScenesAreRight) {
  EXPECT_THAT(fine({"torture", "--cases", "25"}).out,
              AllOf(ContainsRegex("mismatch +0\n"), ContainsRegex("broken law +0\n"), ContainsRegex("dead-lock +0\n"),
                    ContainsRegex("exception +0\n")));
}

TEST_F(TortureTest, CasesFollowFromTheirSeedAlone) {
  const std::string all = fine({"torture", "--cases", "6", "--seed", "20"}).out;
  EXPECT_EQ(fine({"torture", "--cases", "6", "--seed", "20", "--jobs", "3"}).out, all);
  const std::string cases = fine({"torture", "--cases", "3", "--seed", "20", "--dry-run"}).out;
  EXPECT_THAT(cases, HasSubstr(fine({"torture", "--cases", "1", "--seed", "22", "--dry-run"}).out));
}

TEST_F(TortureTest, AFaultIsFoundAndMadeSmall) {
  const Finished run =
      artu({"torture", "--cases", "9", "--seed", "1", "--inject-fault", "triangle:30", "-o", "bad", "--quiet"});
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, AllOf(ContainsRegex("seed [0-9]+: mismatch: "), Not(HasSubstr("pixels   "))));
  EXPECT_THAT(run.out,
              ContainsRegex("smallest case: [12]x[12] pixels, [0-2] static and [0-2] dynamic triangles, 1 materials, 0 "
                            "textures, 0 lights, 1 frames\n"));
  EXPECT_THAT(run.out, Not(HasSubstr("--set"))) << "the default unit has this fault as well";
  // What it says to see the failure with: it does, with the fault, and only with it.
  std::smatch see;
  ASSERT_TRUE(std::regex_search(run.out, see, std::regex("to see it: artu check (.*)\n")));
  EXPECT_EQ(see.str(1), "bad/scene.artu -c bad/unit.toml --frames all");
  const std::vector<std::string> check{"check", "bad/scene.artu", "-c", "bad/unit.toml", "--frames", "all"};
  fine(check);
  std::vector<std::string> faulty = check;
  faulty.insert(faulty.end(), {"--inject-fault", "triangle:30"});
  EXPECT_EQ(artu(faulty).code, 1);
}

TEST_F(TortureTest, ADeadLockIsToldFromAMismatch) {
  const Finished run = artu({"torture", "--cases", "2", "--inject-fault", "dram:0"});
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, AllOf(ContainsRegex("dead-lock +1\n"), ContainsRegex("seed 1: dead-lock: ")));
}

TEST_F(TortureTest, AFolderThatExistsIsRefusedBeforeAnythingRuns) {
  std::filesystem::create_directory(path("there"));
  const Finished run = artu({"torture", "-o", "there", "--cases", "100000"});
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("there: exists already"));
}

}  // namespace
}  // namespace artu::test
