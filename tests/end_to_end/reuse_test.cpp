// `artu reuse` as a user sees it.
#include <gmock/gmock.h>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class ReuseTest : public ProgramTest {
 protected:
  ReuseTest() { write_scene("tiny.obj"); }
};

TEST_F(ReuseTest, LeavesCurvesAndWorkingSets) {
  const Finished reuse = fine({"reuse", "tiny.obj", "--size", "64x48", "-o", "out"});
  for (const char* cache : {"node_cache", "triangle_cache", "texture_cache", "pixel_cache", "l2"}) {
    EXPECT_THAT(reuse.out, HasSubstr(cache));
  }
  EXPECT_THAT(content("out"), ElementsAre("config.toml", "manifest.json", "reuse.csv", "reuse.dat", "reuse.gnuplot",
                                          "reuse.png", "reuse.svg", "working_set.csv"));
  const auto curves = csv("out/reuse.csv");
  EXPECT_THAT(curves.at(0), ElementsAre("cache", "caches", "bytes", "requests", "misses", "miss_ratio"));
  for (std::size_t i = 1; i < curves.size(); ++i) {
    if (curves[i][3] == "0") continue;
    EXPECT_NEAR(std::stod(curves[i][5]), std::stod(curves[i][4]) / std::stod(curves[i][3]), 1e-7);
  }
  const auto sets = csv("out/working_set.csv");
  EXPECT_THAT(sets.at(0), ElementsAre("cache", "frame", "cycle", "requests", "mean_bytes", "largest_bytes"));
  EXPECT_GT(sets.size(), 5u);
}

TEST_F(ReuseTest, IsTheSameWithSeveralProcesses) {
  const std::vector<std::string> args{"reuse", "tiny.obj", "--size", "32x24", "--frames", "0:3", "--window", "500"};
  std::vector<std::string> one = args, two = args;
  one.insert(one.end(), {"-o", "one"});
  two.insert(two.end(), {"-o", "two", "--jobs", "2"});
  fine(one);
  fine(two);
  for (const char* file : {"reuse.csv", "working_set.csv", "reuse.dat"}) {
    EXPECT_EQ(read(std::string("one/") + file), read(std::string("two/") + file)) << file;
  }
  EXPECT_THAT(read("one/working_set.csv"), HasSubstr("\nl2,2,500,"));
}

TEST_F(ReuseTest, BadInputIsRefused) {
  EXPECT_THAT(refused({"reuse", "tiny.obj", "--window", "99", "-o", "out"}), HasSubstr("--window"));
  EXPECT_THAT(refused({"reuse", "none.obj", "-o", "out"}), HasSubstr("none.obj"));
  EXPECT_THAT(refused({"reuse", "tiny.obj", "--set", "core.count=0", "-o", "out"}), HasSubstr("core.count"));
  EXPECT_THAT(refused({"reuse", "tiny.obj", "--jobs", "0", "-o", "out"}), HasSubstr("--jobs"));
  EXPECT_FALSE(exists("out"));
}

}  // namespace
}  // namespace artu::test
