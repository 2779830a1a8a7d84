// `artu precision` as a user sees it.
#include <gmock/gmock.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

class PrecisionTest : public ProgramTest {
 protected:
  PrecisionTest() { write_scene("tiny.obj"); }

  /// A small sweep with more options.
  static std::vector<std::string> sweep(const std::vector<std::string>& more) {
    std::vector<std::string> args{"precision", "tiny.obj", "--size", "24x18"};
    args.insert(args.end(), more.begin(), more.end());
    return args;
  }
};

/// The program is found by its path: without a PATH it misses gnuplot alone.
class WithoutPath {
 public:
  WithoutPath() : before_(std::getenv("PATH")) { setenv("PATH", "/none", 1); }
  ~WithoutPath() { setenv("PATH", before_.c_str(), 1); }

 private:
  const std::string before_;
};

TEST_F(PrecisionTest, AReportIsCompleteAndSaysWhatLacksWithoutGnuplot) {
  const WithoutPath none;
  const Finished run = fine(sweep({"--bits", "8,9/10/7", "--trees", "bvh2,kd", "-o", "out"}));
  EXPECT_THAT(run.out, HasSubstr("tiny.obj, 24x18, frame 0"));
  EXPECT_THAT(run.out, HasSubstr("\nkd      9/10/7"));
  EXPECT_THAT(run.out, HasSubstr("report      out\n"));
  EXPECT_THAT(run.err, HasSubstr("note: no plot: gnuplot is not installed; cost-against-error.gnuplot is for it\n"));
  EXPECT_THAT(content("out"), ElementsAre("M08-from-M23_0000.png", "M08-from-binary64_0000.png", "M08_0000.png",
                                          "M23-from-binary64_0000.png", "M23_0000.png", "M9-10-7-from-M23_0000.png",
                                          "M9-10-7-from-binary64_0000.png", "M9-10-7_0000.png", "binary64_0000.png",
                                          "config.toml", "cost-against-error.dat", "cost-against-error.gnuplot",
                                          "manifest.json", "precision.csv", "precision.json"));
  const auto json = nlohmann::json::parse(read("out/precision.json"));
  ASSERT_EQ(json.at("rows").size(), 6u);
  EXPECT_EQ(json.at("scene").at("file"), "tiny.obj");
  EXPECT_THAT(content(), ElementsAre("out", "tiny.obj"));
}

TEST_F(PrecisionTest, GnuplotDrawsThePlot) {
  if (std::system("gnuplot --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "skipped: no gnuplot";
  EXPECT_THAT(fine(sweep({"--bits", "8", "--trees", "bvh2", "-o", "out"})).err, Not(HasSubstr("no plot")));
  EXPECT_EQ(read("out/cost-against-error.png").substr(1, 3), "PNG");
  EXPECT_THAT(read("out/cost-against-error.svg"), HasSubstr("</svg>"));
}

TEST_F(PrecisionTest, TheSameRunGivesTheSameReportButForItsTime) {
  for (const char* folder : {"a", "b"}) fine(sweep({"--bits", "9", "--trees", "kd", "--frames", "1:3", "-o", folder}));
  EXPECT_EQ(content("a"), content("b"));
  for (const std::string& name : content("a")) {
    if (name == "manifest.json" || name == "precision.csv" || name == "precision.json") continue;
    EXPECT_TRUE(read("a/" + name) == read("b/" + name)) << name;
  }
  auto a = nlohmann::json::parse(read("a/precision.json")), b = nlohmann::json::parse(read("b/precision.json"));
  for (auto* json : {&a, &b}) {
    for (auto& row : json->at("rows")) row.erase("run_time_ratio");
  }
  EXPECT_EQ(a, b);
}

TEST_F(PrecisionTest, TakesATraceAndAConfiguration) {
  fine({"import", "tiny.obj", "--size", "24x18", "--frames", "0:2", "-o", "tiny.trace"});
  write("small.toml", "[core]\ncount = 2\n");
  fine({"precision", "tiny.trace", "-c", "small.toml", "--set", "selective.enabled=false", "--bits", "7", "--trees",
        "bvh8", "--quiet", "-o", "out"});
  const auto json = nlohmann::json::parse(read("out/precision.json"));
  EXPECT_EQ(json.at("configuration").at("core").at("count"), 2);
  EXPECT_EQ(json.at("rows")[1].at("traced_share"), 1);
  EXPECT_EQ(json.at("rows")[1].at("from_binary64").at("differing_pixels"), 0);
}

TEST_F(PrecisionTest, NothingIsOverwrittenWithoutForce) {
  const std::vector<std::string> args = sweep({"--bits", "23", "--trees", "bvh2", "--quiet", "-o", "out"});
  const Finished first = fine(args);
  EXPECT_EQ(first.out + first.err, "");
  EXPECT_THAT(refused(args), HasSubstr("out: exists already"));
  std::vector<std::string> forced = args;
  forced.emplace_back("--force");
  fine(forced);
  EXPECT_THAT(fine(sweep({"--bits", "23", "--trees", "bvh2"})).out, HasSubstr("runs/tiny-1"));
}

TEST_F(PrecisionTest, BadInputIsRefusedAndLeavesNothing) {
  const auto before = content();
  EXPECT_THAT(refused(sweep({"--bits", "6"})), HasSubstr("\"6\" is no width; M, M-N or BOX/TRIANGLE[/SHADING]"));
  EXPECT_THAT(refused(sweep({"--bits", "7,,8"})), HasSubstr("\"\" is no width"));
  EXPECT_THAT(refused(sweep({"--trees", "bvh2,bvh3"})), HasSubstr("\"bvh3\" is no tree; bvh2, bvh4, bvh8 and kd"));
  EXPECT_THAT(refused(sweep({"--frames", "3:3"})), HasSubstr("3:3 is empty"));
  EXPECT_THAT(refused(sweep({"--set", "core.cuont=1"})), HasSubstr("did you mean core.count?"));
  EXPECT_THAT(refused(sweep({"-o", "/proc/artu"})), HasSubstr("/proc/artu"));
  EXPECT_THAT(refused(sweep({"-o", "tiny.obj/out"})), HasSubstr("tiny.obj: cannot write"));
  EXPECT_THAT(refused({"precision"}), HasSubstr("SCENE"));
  EXPECT_THAT(refused({"precision", "none.glb"}), HasSubstr("none.glb: no such file"));
  EXPECT_EQ(content(), before);
}

}  // namespace
}  // namespace artu::test
