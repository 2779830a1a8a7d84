// --fidelity: what each mode reports, and what it refuses.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

class FidelityTest : public ProgramTest {
 protected:
  FidelityTest() { write_scene("tiny.obj"); }

  json stats(const std::string& folder) const { return json::parse(read(folder + "/stats.json")); }
};

TEST_F(FidelityTest, FunctionalHasThePictureAndTheCounts) {
  fine({"run", "tiny.obj", "--size", "24x18", "--frames", "0:2", "-o", "event", "--dump-pixels", "event.csv"});
  const Finished run = fine({"run", "tiny.obj", "--size", "24x18", "--frames", "0:2", "-o", "functional",
                             "--dump-pixels", "functional.csv", "--fidelity", "functional"});
  EXPECT_EQ(read("event.csv"), read("functional.csv"));
  for (const std::string& name : content("event")) {
    if (name.find(".png") == std::string::npos) continue;
    EXPECT_TRUE(read("event/" + name) == read("functional/" + name)) << name;
  }
  const json a = stats("event"), b = stats("functional");
  for (const char* name : {"rays", "candidates", "pixels", "traced_share", "triangles", "tree", "node_visits"}) {
    EXPECT_EQ(a.at("totals").at(name), b.at("totals").at(name)) << name;
  }
  EXPECT_EQ(a.at("fidelity").at("mode"), "event");
  EXPECT_EQ(b.at("fidelity").at("mode"), "functional");
  EXPECT_EQ(json::parse(read("functional/manifest.json")).at("fidelity"), "functional");
  EXPECT_THAT(run.out, HasSubstr("functional: pixels and counts exact, no cycles"));
}

TEST_F(FidelityTest, WhatFunctionalDoesNotKnowIsAbsent) {
  const Finished run = fine({"run", "tiny.obj", "--size", "24x18", "-o", "out", "--fidelity", "functional"});
  EXPECT_THAT(run.out, Not(HasSubstr("cycles  ")));
  EXPECT_THAT(run.out, Not(HasSubstr("DRAM")));
  EXPECT_THAT(run.out, Not(HasSubstr("energy")));
  const json j = stats("out");
  for (const json& frame : {j.at("frames").at(0), j.at("totals")}) {
    for (const char* name : {"cycles", "dram", "energy"}) EXPECT_FALSE(frame.contains(name)) << name;
    EXPECT_TRUE(frame.at("estimates").empty());
  }
  EXPECT_FALSE(j.contains("energy"));
  for (const char* name : {"fps", "cycles_per_frame", "mrays_per_second", "dram_gb_per_second"}) {
    EXPECT_FALSE(j.at("derived").contains(name)) << name;
  }
  const std::string text = read("out/stats.txt");
  EXPECT_THAT(text, HasSubstr("functional: pixels and counts exact, no cycles"));
  EXPECT_THAT(text, Not(HasSubstr("cycles_per_second")));
  EXPECT_THAT(fine({"run", "--list-stats", "--fidelity", "functional"}).out, Not(HasSubstr("energy.")));
}

TEST_F(FidelityTest, FunctionalIsCheckedAgainstTheGoldenModel) {
  EXPECT_THAT(fine({"check", "tiny.obj", "--size", "24x18", "--fidelity", "functional"}).out,
              HasSubstr("check: 432 pixels compared with the golden model, 0 differing"));
}

TEST_F(FidelityTest, AnalyticSaysWhichFiguresAreEstimates) {
  const Finished run =
      fine({"run", "tiny.obj", "--size", "24x18", "--frames", "0:2", "-o", "out", "--fidelity", "analytic"});
  EXPECT_THAT(run.out, HasSubstr("95 % between"));
  EXPECT_THAT(run.out, HasSubstr("bottleneck"));
  EXPECT_THAT(run.out, HasSubstr("analytic: pixels and counts exact; cycles and DRAM bytes estimated"));
  const json j = stats("out");
  double sum = 0;
  for (const json& frame : j.at("frames")) {
    for (const char* name : {"cycles", "dram.read_bytes", "dram.write_bytes"}) {
      const json& e = frame.at("estimates").at(name);
      EXPECT_LE(e.at("low"), e.at("value"));
      EXPECT_GE(e.at("high"), e.at("value"));
    }
    EXPECT_EQ(frame.at("estimates").at("cycles").at("value"), frame.at("cycles"));
    EXPECT_FALSE(frame.contains("energy"));
    sum += frame.at("estimates").at("cycles").at("high").get<double>();
  }
  EXPECT_DOUBLE_EQ(j.at("totals").at("estimates").at("cycles").at("high").get<double>(), sum);
  EXPECT_TRUE(j.at("demand").at("shares").contains(j.at("demand").at("bottleneck").get<std::string>()));
  EXPECT_THAT(read("out/stats.txt"), HasSubstr("# Estimates with their 95 % intervals"));
}

TEST_F(FidelityTest, WhatAModeCannotHonourIsRefused) {
  const auto before = content();
  const auto refusal = [this](const std::string& mode, std::vector<std::string> more) {
    std::vector<std::string> args{"run", "tiny.obj", "--size", "8x8", "-o", "out", "--fidelity", mode};
    args.insert(args.end(), more.begin(), more.end());
    return refused(args);
  };
  for (const std::vector<std::string>& option : std::vector<std::vector<std::string>>{{"--random-stall"},
                                                                                      {"--shuffle"},
                                                                                      {"--log", "*=info"},
                                                                                      {"--memory-trace", "trace"},
                                                                                      {"--inject-fault", "box"},
                                                                                      {"--pictures", "frame,cycles"}}) {
    for (const char* mode : {"functional", "analytic"}) {
      EXPECT_THAT(refusal(mode, option), HasSubstr(option[0] + ": ")) << option[0];
      EXPECT_THAT(refusal(mode, option), HasSubstr(mode)) << option[0];
    }
  }
  EXPECT_EQ(content(), before);
}

}  // namespace
}  // namespace artu::test
