// `artu stress` as a user sees it.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class StressTest : public ProgramTest {};

TEST_F(StressTest, PassesAndSaysSo) {
  const Finished run = fine({"stress", "--rays", "4000"});
  EXPECT_THAT(run.out, HasSubstr("0 mismatches, 0 leaks\n"));
  for (const char* word : {"sphere/moved-1e5", "identical/as-is", "embree", "By placement", "seed 1"}) {
    EXPECT_THAT(run.out, HasSubstr(word));
  }
}

TEST_F(StressTest, IsReproducible) {
  const std::vector<std::string> args{"stress", "--rays", "800", "--only", "soup", "--seed", "5"};
  EXPECT_EQ(fine(args).out, fine(args).out);
}

TEST_F(StressTest, TakesOneCase) {
  const std::string out = fine({"stress", "--rays", "500", "--only", "box/moved-1e3"}).out;
  EXPECT_THAT(out, HasSubstr("1 cases, 500 rays"));
}

TEST_F(StressTest, WritesJson) {
  fine({"stress", "--rays", "500", "--only", "box/as-is", "--json", "out.json", "--quiet"});
  const auto json = nlohmann::json::parse(read("out.json"));
  EXPECT_EQ(json.at("passed"), true);
  EXPECT_EQ(json.at("rays"), 500);
  ASSERT_EQ(json.at("formats").size(), 1u);
  const auto& format = json.at("formats")[0];
  EXPECT_EQ(format.at("box_bits"), 23);
  ASSERT_EQ(format.at("cases").size(), 1u);
  EXPECT_EQ(format.at("cases")[0].at("subjects").at("kd").at("mismatches"), 0);
  EXPECT_TRUE(json.at("first").is_null());
  EXPECT_THAT(content(), ElementsAre("out.json"));
  EXPECT_THAT(refused({"stress", "--only", "one/as-is", "--json", "out.json"}), HasSubstr("exists already"));
  fine({"stress", "--rays", "10", "--only", "one/as-is", "--json", "out.json", "--force"});
}

TEST_F(StressTest, TakesWidths) {
  fine({"stress", "--rays", "300", "--only", "box/as-is", "--bits", "7-9,23/12", "--json", "out.json", "--quiet"});
  const auto json = nlohmann::json::parse(read("out.json"));
  EXPECT_EQ(json.at("passed"), true);
  ASSERT_EQ(json.at("formats").size(), 4u);
  EXPECT_EQ(json.at("formats")[1].at("triangle_bits"), 8);
  EXPECT_EQ(json.at("formats")[3].at("box_bits"), 23);
  EXPECT_EQ(json.at("formats")[3].at("triangle_bits"), 12);
  EXPECT_THAT(refused({"stress", "--bits", "6"}), HasSubstr("\"6\" is no width; M, M-N or BOX/TRIANGLE"));
  for (const char* wrong : {"24", "9-7", "7,", "x", "7/", "-7", "7-9-11"}) {
    EXPECT_THAT(refused({"stress", "--bits", wrong}), HasSubstr("is no width")) << wrong;
  }
}

TEST_F(StressTest, SendsRaysThroughEdgesAndVerticesOfClosedMeshes) {
  const std::string out =
      fine({"stress", "--leaks", "--rays", "2000", "--only", "needles/as-is", "--bits", "7,23"}).out;
  EXPECT_THAT(out, HasSubstr("0/2000"));
  EXPECT_THAT(out, HasSubstr("2 cases, 4000 rays and 0 secondary rays, 4000 hits, seed 1: 0 mismatches, 0 leaks"));
  EXPECT_THAT(refused({"stress", "--leaks", "--only", "soup"}), HasSubstr("of a closed mesh"));
}

TEST_F(StressTest, ListsItsCases) {
  const std::string out = fine({"stress", "--list"}).out;
  EXPECT_THAT(out, HasSubstr("sphere"));
  EXPECT_THAT(out, HasSubstr("scaled-1e-6"));
}

TEST_F(StressTest, RefusesWhatItDoesNotKnow) {
  EXPECT_THAT(refused({"stress", "--only", "spere"}), HasSubstr("did you mean sphere?"));
  EXPECT_THAT(refused({"stress", "--rays", "0"}), HasSubstr("--rays"));
  EXPECT_THAT(refused({"stress", "--seed", "x"}), HasSubstr("--seed"));
  EXPECT_THAT(content(), IsEmpty());
}

}  // namespace
}  // namespace artu::test
