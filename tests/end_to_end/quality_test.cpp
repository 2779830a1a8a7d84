// `artu quality` and `--pictures` as a user sees them.
#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "end_to_end/program.h"
#include "sim/report/image.h"

namespace artu::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Json = nlohmann::json;

class QualityTest : public ProgramTest {
 protected:
  QualityTest() { write_scene("tiny.obj"); }

  /// Of a CSV file: each row by the names in the first.
  std::vector<std::map<std::string, std::string>> named_rows(const std::string& file) {
    const std::vector<std::vector<std::string>> rows = csv(file);
    std::vector<std::map<std::string, std::string>> named;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      EXPECT_EQ(rows[i].size(), rows[0].size()) << file << ": " << i;
      named.emplace_back();
      for (std::size_t c = 0; c < rows[i].size(); ++c) named.back()[rows[0][c]] = rows[i][c];
    }
    return named;
  }
};

TEST_F(QualityTest, EveryPointIsARunOfItsOwn) {
  const Finished quality = fine({"quality", "tiny.obj", "--size", "48x32", "--frames", "0:2", "--references", "0,40",
                                 "--policies", "fixed,attention", "-o", "out"});
  EXPECT_THAT(quality.out, HasSubstr("At equal work"));
  EXPECT_EQ(quality.out.find(read("out/quality.txt")), 0u);
  const auto rows = named_rows("out/quality.csv");
  ASSERT_EQ(rows.size(), 7u);
  std::vector<std::string> policies;
  for (const auto& row : rows) policies.push_back(row.at("policy") + row.at("reference"));
  EXPECT_THAT(policies,
              ElementsAre("full", "low-resolution", "checkerboard", "fixed0", "fixed40", "attention0", "attention40"));
  EXPECT_EQ(rows[0].at("psnr_all"), "inf");
  EXPECT_EQ(rows[0].at("traced_share"), "1");
  EXPECT_EQ(rows[1].at("traced_share"), "0.25");
  EXPECT_EQ(rows[2].at("cycles"), "");

  // The same numbers as a run with these settings, and as `artu diff` of its picture.
  fine({"run", "tiny.obj", "--size", "48x32", "--frames", "0:2", "--set", "selective.policy=fixed", "--set",
        "selective.reference=40", "--pictures", "frame,full", "-o", "run"});
  const Json totals = Json::parse(read("run/stats.json")).at("totals");
  EXPECT_EQ(rows[4].at("cycles"), totals.at("cycles").dump());
  fine({"run", "tiny.obj", "--size", "48x32", "--set", "selective.enabled=false", "--pictures", "frame", "-o", "full"});
  EXPECT_EQ(read("full/frame_0000.png"), read("run/full_0000.png"));
  const std::string diff = fine({"diff", "run/full_0000.png", "run/frame_0000.png"}).out;
  const double ssim = std::stod(diff.substr(diff.find("SSIM") + 4)),
               flip = std::stod(diff.substr(diff.find("FLIP") + 4));
  EXPECT_NEAR(std::stod(rows[4].at("ssim_all")), ssim, 1e-6);  // the scene stands still: both frames are alike
  EXPECT_NEAR(std::stod(rows[4].at("flip_all")), flip, 1e-6);

  // What is held apart adds up.
  for (const auto& row : rows) {
    std::uint64_t squares = 0;
    for (const char* area : {"dynamic", "static", "background"}) {
      squares += std::stoull(row.at(std::string("squares_") + area));
    }
    EXPECT_EQ(squares, std::stoull(row.at("squares_all")));
    std::uint64_t attributed = 0;
    for (const auto& share : named_rows("out/attribution.csv")) {
      if (share.at("policy") == row.at("policy") && share.at("reference") == row.at("reference")) {
        attributed += std::stoull(share.at("squares"));
        if (share.at("cause") == "traced") {
          EXPECT_EQ(share.at("squares"), "0");
        }
      }
    }
    if (!row.at("reference").empty()) EXPECT_EQ(attributed, squares);
  }
  const Json json = Json::parse(read("out/quality.json"));
  EXPECT_EQ(json.at("rows").size(), 7u);
  EXPECT_TRUE(json.at("rows")[2].at("cycles").is_null());
  EXPECT_EQ(json.at("scene").at("width"), 48);
}

TEST_F(QualityTest, TwoRunsGiveTheSameFolder) {
  for (const std::string folder : {"a", "b"}) {
    fine({"quality", "tiny.obj", "--size", "24x16", "--references", "8", "--policies", "fixed", "--quiet", "-o",
          folder});
  }
  EXPECT_THAT(content("a"), ::testing::IsSupersetOf({"attribution.csv", "config.toml", "equal_shares.csv",
                                                     "fixed-8_strip_0000.png", "manifest.json", "quality.csv",
                                                     "quality.gnuplot", "quality.json", "worst_pixels.csv"}));
  for (const std::string& name : content("a")) {
    if (name == "manifest.json" || name.rfind("quality.svg", 0) == 0)
      continue;  // the command line, the program's notes
    EXPECT_EQ(read("a/" + name), read("b/" + name)) << name;
  }
}

TEST_F(QualityTest, ARunWritesThePicturesThatWereAskedFor) {
  fine({"run", "tiny.obj", "--size", "24x16", "--frames", "0:2", "--pictures", "all", "-o", "all"});
  std::vector<std::string> pictures;
  for (const std::string& name : content("all")) {
    if (name.find(".png") != std::string::npos) pictures.push_back(name);
  }
  EXPECT_EQ(pictures.size(), 9u * 2 + 1);
  EXPECT_THAT(pictures, ::testing::IsSupersetOf({"animation.png", "cycles_0001.png", "error_0000.png", "strip_0001.png",
                                                 "threshold_0000.png"}));
  EXPECT_THAT(read("all/animation.png"), HasSubstr("acTL"));
  EXPECT_EQ(sim::read_png(path("all/frame_0000.png")).width, 24u);
  // The key is below the picture, which is where it was.
  EXPECT_GT(sim::read_png(path("all/decision_0000.png")).height, 16u);

  fine({"run", "tiny.obj", "--size", "24x16", "--pictures", "none", "-o", "none"});
  EXPECT_THAT(content("none"), ElementsAre("config.toml", "manifest.json", "stats.json", "stats.txt"));
}

TEST_F(QualityTest, BadOptionsAreRefused) {
  const auto before = content();
  const auto bad = [&](const std::vector<std::string>& more) {
    std::vector<std::string> args{"quality", "tiny.obj", "--size", "8x8", "-o", "out"};
    args.insert(args.end(), more.begin(), more.end());
    return refused(args);
  };
  EXPECT_THAT(bad({"--references", "4,,8"}), HasSubstr("--references: \"\" is no threshold"));
  EXPECT_THAT(bad({"--references", "256"}), HasSubstr("0 ... 255"));
  EXPECT_THAT(bad({"--policies", "best"}), HasSubstr("of fixed, attention, contrast, decisions"));
  EXPECT_THAT(bad({"--shares", "0"}), HasSubstr("--shares"));
  EXPECT_THAT(bad({"--shares", "101"}), HasSubstr("--shares"));
  EXPECT_THAT(bad({"--pictures", "x"}), HasSubstr("is no picture; of frame, full, decision"));
  EXPECT_THAT(bad({"--worst", "-1"}), HasSubstr("--worst"));
  EXPECT_THAT(bad({"--set", "selective.refrence=4"}), HasSubstr("did you mean selective.reference?"));
  EXPECT_THAT(refused({"quality"}), HasSubstr("SCENE"));
  EXPECT_THAT(refused({"quality", "none.obj"}), HasSubstr("none.obj"));
  EXPECT_THAT(refused({"quality", "tiny.obj", "-o", "/proc/artu"}), HasSubstr("/proc/artu"));
  EXPECT_THAT(refused({"quality", "tiny.obj", "-o", "tiny.obj/out"}), HasSubstr("tiny.obj: cannot write"));
  EXPECT_THAT(refused({"check", "tiny.obj", "--size", "8x8", "--pictures", "all"}), HasSubstr("-o DIR"));
  EXPECT_THAT(refused({"check", "tiny.obj", "--size", "8x8", "--force"}),
              HasSubstr("--force: there is nothing it could replace; -o DIR as well would be right"));
  EXPECT_EQ(content(), before);
}

}  // namespace
}  // namespace artu::test
