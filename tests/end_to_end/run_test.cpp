// What runs leave: whole reports, the same for the same input, and nothing overwritten.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

class RunTest : public ProgramTest {
 protected:
  RunTest() { write_scene("tiny.obj"); }

  json stats(const std::string& folder) const { return json::parse(read(folder + "/stats.json")); }

  /// stats.json without the wall times, the only thing that may differ.
  json repeatable_stats(const std::string& folder) const {
    json j = stats(folder);
    j.erase("simulation");
    return j;
  }

  std::string repeatable_text(const std::string& folder) const {
    std::istringstream in(read(folder + "/stats.txt"));
    std::string out;
    for (std::string line; std::getline(in, line);) {
      if (line.compare(0, 11, "simulation.") != 0) out += line + "\n";
    }
    return out;
  }

  void expect_same_pictures(const std::string& a, const std::string& b) const {
    ASSERT_EQ(content(a), content(b));
    for (const std::string& name : content(a)) {
      if (name.find(".png") == std::string::npos) continue;
      EXPECT_TRUE(read(a + "/" + name) == read(b + "/" + name)) << name;
    }
  }
};

TEST_F(RunTest, AReportIsComplete) {
  const Finished run = fine({"run", "tiny.obj", "--size", "12x10", "--frames", "2:4", "-o", "out"});
  EXPECT_THAT(run.out, HasSubstr("tiny.obj, 12x10"));
  EXPECT_THAT(run.out, HasSubstr("out\n"));
  EXPECT_LE(std::count(run.out.begin(), run.out.end(), '\n'), 12);
  EXPECT_THAT(content("out"),
              ElementsAre("class_0002.png", "class_0003.png", "config.toml", "decision_0002.png", "decision_0003.png",
                          "frame_0002.png", "frame_0003.png", "manifest.json", "stats.json", "stats.txt"));
  const json j = stats("out");
  ASSERT_EQ(j.at("frames").size(), 2u);
  EXPECT_EQ(j.at("frames").at(1).at("index"), 3);
  EXPECT_EQ(j.at("frames").at(0).at("pixels").at("total"), 120);
  EXPECT_GT(j.at("frames").at(0).at("cycles"), 0);
  EXPECT_GT(j.at("derived").at("fps"), 0);
  EXPECT_TRUE(j.at("check").is_null());
  const json manifest = json::parse(read("out/manifest.json"));
  EXPECT_EQ(manifest.at("input").at("file"), "tiny.obj");
  EXPECT_EQ(manifest.at("size").at("width"), 12);
  EXPECT_THAT(content(), ElementsAre("out", "tiny.obj"));
}

TEST_F(RunTest, EveryBlocksCyclesAddUpToTheFrame) {
  fine({"run", "tiny.obj", "--size", "12x10", "-o", "out"});
  const json frame = stats("out").at("frames").at(0);
  for (const auto& [name, block] : frame.at("blocks").items()) {
    if (!block.contains("busy") || name == "dram") continue;  // the DRAM counts clocks of its own
    std::uint64_t sum = 0;
    for (const char* part : {"busy", "stall_in", "stall_out", "stall_mem", "idle"}) {
      sum += block.at(part).get<std::uint64_t>();
    }
    EXPECT_EQ(sum, frame.at("cycles").get<std::uint64_t>()) << name;
  }
}

TEST_F(RunTest, TheSameRunGivesTheSameReport) {
  const std::vector<std::string> run{"run", "tiny.obj", "--size", "20x14", "--frames", "0:2", "--check", "-o"};
  for (const char* folder : {"a", "b"}) {
    std::vector<std::string> args = run;
    args.emplace_back(folder);
    fine(args);
  }
  expect_same_pictures("a", "b");
  EXPECT_TRUE(repeatable_stats("a") == repeatable_stats("b"));
  EXPECT_TRUE(repeatable_text("a") == repeatable_text("b"));
  EXPECT_EQ(read("a/config.toml"), read("b/config.toml"));
  json a = json::parse(read("a/manifest.json")), b = json::parse(read("b/manifest.json"));
  a.erase("command");
  b.erase("command");
  EXPECT_EQ(a, b);
}

TEST_F(RunTest, ASceneAndItsTraceGiveTheSameReport) {
  fine({"import", "tiny.obj", "--size", "20x14", "--frames", "1:3", "-o", "tiny.trace"});
  fine({"run", "tiny.obj", "--size", "20x14", "--frames", "1:3", "-o", "scene"});
  fine({"run", "tiny.trace", "--frames", "all", "-o", "trace"});
  expect_same_pictures("scene", "trace");
  EXPECT_TRUE(repeatable_stats("scene") == repeatable_stats("trace"));
}

TEST_F(RunTest, AFrameAloneIsAsInItsSequence) {
  fine({"run", "tiny.obj", "--size", "20x14", "--frames", "0:3", "-o", "all"});
  fine({"run", "tiny.obj", "--size", "20x14", "--frames", "2", "-o", "one"});
  EXPECT_EQ(stats("all").at("frames").at(2), stats("one").at("frames").at(0));
  EXPECT_EQ(read("all/frame_0002.png"), read("one/frame_0002.png"));
}

TEST_F(RunTest, HowTheModelIsRunChangesNoPixel) {
  const std::vector<std::string> run{"run", "tiny.obj", "--size", "20x14", "-o"};
  const auto with = [&](const std::string& folder, std::vector<std::string> more) {
    std::vector<std::string> args = run;
    args.push_back(folder);
    args.insert(args.end(), more.begin(), more.end());
    fine(args);
  };
  with("plain", {});
  with("clocked", {"--fidelity", "clocked"});
  with("shuffled", {"--shuffle", "--seed", "7"});
  with("stalled", {"--random-stall", "--seed", "7"});
  json clocked = repeatable_stats("clocked");
  EXPECT_EQ(clocked.at("fidelity").at("mode"), "clocked");
  clocked["fidelity"]["mode"] = "event";
  EXPECT_TRUE(repeatable_stats("plain") == clocked);
  EXPECT_TRUE(repeatable_stats("plain") == repeatable_stats("shuffled"));
  for (const char* folder : {"clocked", "shuffled", "stalled"}) expect_same_pictures("plain", folder);
}

TEST_F(RunTest, NothingIsOverwrittenWithoutForce) {
  fine({"run", "tiny.obj", "--size", "8x8", "-o", "out", "--dump-pixels", "p.csv"});
  const std::string before = read("out/manifest.json"), csv = read("p.csv");
  EXPECT_THAT(refused({"run", "tiny.obj", "--size", "9x9", "-o", "out"}), HasSubstr("--force"));
  EXPECT_THAT(refused({"run", "tiny.obj", "--size", "9x9", "-o", "new", "--dump-pixels", "p.csv"}),
              HasSubstr("--force"));
  EXPECT_EQ(read("out/manifest.json"), before);
  EXPECT_EQ(read("p.csv"), csv);
  EXPECT_FALSE(exists("new"));
  fine({"run", "tiny.obj", "--size", "9x9", "-o", "out", "--dump-pixels", "p.csv", "--force", "--quiet"});
  EXPECT_NE(read("out/manifest.json"), before);
  EXPECT_NE(read("p.csv"), csv);
  fine({"import", "tiny.obj", "--size", "8x8", "-o", "t.trace"});
  EXPECT_THAT(refused({"import", "tiny.obj", "--size", "8x8", "-o", "t.trace"}), HasSubstr("--force"));
  fine({"import", "tiny.obj", "--size", "9x9", "-o", "t.trace", "--force"});
  EXPECT_THAT(content(), ElementsAre("out", "p.csv", "t.trace", "tiny.obj"));
}

TEST_F(RunTest, ForceReplacesNothingButRuns) {
  std::filesystem::create_directory(path("mine"));
  write("mine/thesis.txt", "precious");
  EXPECT_THAT(refused({"run", "tiny.obj", "--size", "8x8", "-o", "mine", "--force"}), HasSubstr("not the folder of a"));
  EXPECT_EQ(read("mine/thesis.txt"), "precious");
}

TEST_F(RunTest, NoFileIsWrittenTwiceOrOverTheInputOrLostWithAFolder) {
  write("unit.toml", "core.count = 2\n");
  std::filesystem::create_directory(path("out"));
  const auto before = content();
  const std::vector<std::string> run{"run", "tiny.obj", "--size", "8x8", "-c", "unit.toml", "-o", "out", "--force"};
  const auto refuses = [&](std::vector<std::string> more, const std::string& message) {
    more.insert(more.begin(), run.begin(), run.end());
    EXPECT_THAT(refused(more), HasSubstr(message));
    EXPECT_EQ(content(), before);
    EXPECT_TRUE(content("out").empty());
  };
  refuses({"--dump-pixels", "p", "--memory-trace", "./p"}, "./p is the file of --dump-pixels as well");
  refuses({"--dump-pixels", "out/p.csv"}, "out/p.csv is in the folder of -o");
  refuses({"--trace", "vcd=out/../out/t.vcd"}, "is in the folder of -o");
  refuses({"--memory-trace", "out"}, "is in the folder of -o");
  refuses({"--dump-pixels", "./tiny.obj"}, "./tiny.obj: is the input");
  refuses({"--memory-trace", "unit.toml"}, "unit.toml: is the input");
  EXPECT_THAT(refused({"import", "tiny.obj", "-o", "./tiny.obj", "--force"}), HasSubstr("is the input"));
}

/// Or two runs would look as if they were of the same scene.
TEST_F(RunTest, TheDigestOfTheInputIsOfAllItsFiles) {
  write("a.stage.toml", "[[file]]\npath = \"tiny.obj\"\n");
  const auto digest = [&](const std::string& scene) {
    fine({"run", scene, "--size", "8x8", "-o", "out", "--force"});
    return nlohmann::json::parse(read("out/manifest.json")).at("input").at("sha256").get<std::string>();
  };
  const auto printed = [&](const std::string& commands) {
    return program("/bin/sh", {"-c", commands}).out.substr(0, 64);
  };
  EXPECT_EQ(digest("tiny.obj"), printed("sha256sum tiny.obj"));
  const std::string before = digest("a.stage.toml");
  EXPECT_EQ(before, printed("sha256sum a.stage.toml tiny.obj | sha256sum"));
  write("tiny.obj", read("tiny.obj") + "v 0 0 0\n");
  EXPECT_NE(digest("a.stage.toml"), before);
}

TEST_F(RunTest, WithoutAFolderTheNextFreeOneIsMade) {
  EXPECT_THAT(fine({"run", "tiny.obj", "--size", "8x8"}).out, HasSubstr("runs/tiny-1"));
  EXPECT_THAT(fine({"run", "tiny.obj", "--size", "8x8"}).out, HasSubstr("runs/tiny-2"));
  EXPECT_THAT(content("runs"), ElementsAre("tiny-1", "tiny-2"));
}

TEST_F(RunTest, CheckComparesEveryPixelAndLeavesNothing) {
  const Finished check = fine({"check", "tiny.obj", "--size", "24x18", "--frames", "0:2"});
  EXPECT_THAT(check.out, HasSubstr("864 pixels compared with the golden model, 0 differing"));
  EXPECT_THAT(content(), ElementsAre("tiny.obj"));
  fine({"check", "tiny.obj", "--size", "24x18", "-o", "out"});
  EXPECT_EQ(stats("out").at("check").at("passed"), true);
  EXPECT_EQ(stats("out").at("check").at("pixels"), 432);
  EXPECT_TRUE(stats("out").at("simulation").contains("golden_seconds"));
}

TEST_F(RunTest, CheckHoldsWithSelectiveRenderingOffAndInEveryVariant) {
  for (const char* setting : {"selective.enabled=false", "selective.adaptive=false", "selective.magnitude=fixed",
                              "selective.magnitude=progressive", "shading.max_depth=0", "core.count=1"}) {
    EXPECT_THAT(fine({"check", "tiny.obj", "--size", "16x12", "--set", setting}).out, HasSubstr("0 differing"));
  }
}

TEST_F(RunTest, PixelsAreDumpedRowByRow) {
  fine({"run", "tiny.obj", "--size", "5x4", "--frames", "0:2", "--dump-pixels", "p.csv", "-o", "out"});
  std::istringstream csv(read("p.csv"));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "frame,x,y,pass,class,n_static,n_dynamic,threshold,difference,decision,r,g,b,primitive,t_bits");
  for (int frame = 0; frame < 2; ++frame) {
    for (int y = 0; y < 4; ++y) {
      for (int x = 0; x < 5; ++x) {
        ASSERT_TRUE(std::getline(csv, line));
        std::ostringstream start;
        start << frame << ',' << x << ',' << y << ',';
        EXPECT_EQ(line.compare(0, start.str().size(), start.str()), 0) << line;
      }
    }
  }
  EXPECT_FALSE(std::getline(csv, line));
}

TEST_F(RunTest, TheConfigurationOfARunLoadsAgain) {
  fine({"run", "tiny.obj", "--size", "8x8", "--set", "core.count=2", "--set", "core.node_cache.size=8KiB", "-o", "a"});
  EXPECT_THAT(read("a/config.toml"), HasSubstr("count = 2 "));
  fine({"run", "tiny.obj", "--size", "8x8", "-c", "a/config.toml", "-o", "b"});
  EXPECT_EQ(read("a/config.toml"), read("b/config.toml"));
  EXPECT_TRUE(repeatable_stats("a") == repeatable_stats("b"));
  EXPECT_EQ(fine({"run", "--dump-config", "-c", "a/config.toml"}).out, read("a/config.toml"));
}

TEST_F(RunTest, ListsNameWhatThereIs) {
  const std::string parameters = fine({"run", "--list-params"}).out;
  EXPECT_THAT(parameters, HasSubstr("core.node_cache.size"));
  const std::string list = fine({"run", "--list-stats"}).out;
  EXPECT_THAT(list, HasSubstr("rays.primary"));
  fine({"run", "tiny.obj", "--size", "8x8", "-o", "out"});
  std::istringstream lines(read("out/stats.txt"));
  for (std::string line; std::getline(lines, line);) {
    const std::string name = line.substr(0, line.find(' '));
    const auto numbered = [&name](const std::string& block) {
      return name.compare(0, block.size(), block) == 0 && name.compare(0, block.size() + 2, block + "0.") != 0;
    };
    if (line.find("  # ") == std::string::npos || numbered("core") || numbered("l2_bank")) continue;
    EXPECT_THAT(list, HasSubstr("\n" + name + " ")) << "a number that --list-stats does not name";
  }
}

TEST_F(RunTest, TheLogSaysWhatABlockDoes) {
  const Finished info = fine({"run", "tiny.obj", "--size", "4x4", "-o", "a", "--log", "l2_bank0=info"});
  EXPECT_THAT(info.err, HasSubstr(" l2_bank0: phase selective"));
  EXPECT_THAT(info.err, Not(HasSubstr("busy")));
  const Finished debug =
      fine({"run", "tiny.obj", "--size", "4x4", "-o", "b", "--log", "*=info", "--log", "core0=debug"});
  EXPECT_THAT(debug.err, HasSubstr(" core0.shading: busy"));
  EXPECT_THAT(debug.err, Not(HasSubstr(" core1.shading: busy")));
  EXPECT_EQ(repeatable_stats("a"), repeatable_stats("b")) << "looking changes nothing";
  const Finished wrong = artu({"run", "tiny.obj", "-o", "c", "--log", "core9=debug"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("no block \"core9\""));
  EXPECT_EQ(artu({"run", "tiny.obj", "-o", "c", "--log", "l2"}).code, 2);
}

TEST_F(RunTest, DryRunWritesNothing) {
  EXPECT_THAT(fine({"run", "tiny.obj", "--size", "8x8", "--dry-run", "-o", "out"}).out, HasSubstr("nothing was run"));
  EXPECT_THAT(content(), ElementsAre("tiny.obj"));
}

TEST_F(RunTest, QuietPrintsNothing) {
  const Finished run = fine({"run", "tiny.obj", "--size", "8x8", "--check", "--quiet", "-o", "out"});
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err, "");
  const Finished import = fine({"import", "tiny.obj", "--size", "8x8", "--quiet", "-o", "t.trace"});
  EXPECT_EQ(import.out + import.err, "");
}

TEST_F(RunTest, DiffMeasures) {
  fine({"run", "tiny.obj", "--size", "32x24", "-o", "a"});
  fine({"run", "tiny.obj", "--size", "32x24", "--set", "selective.enabled=false", "-o", "b"});
  const std::string same = fine({"diff", "a/frame_0000.png", "a/frame_0000.png"}).out;
  EXPECT_THAT(same, HasSubstr("infinite"));
  EXPECT_THAT(same, HasSubstr("1.000000"));
  fine({"run", "tiny.obj", "--size", "32x24", "--inject-fault", "shading:7", "-o", "c"});
  const std::string other = fine({"diff", "a/frame_0000.png", "c/frame_0000.png"}).out;
  EXPECT_THAT(other, HasSubstr(" dB"));
  EXPECT_THAT(same, HasSubstr("FLIP                0.000000"));
  EXPECT_THAT(other, ::testing::Not(HasSubstr("FLIP                0.000000")));
  EXPECT_THAT(fine({"diff", "a/frame_0000.png", "b/frame_0000.png"}).out, HasSubstr("SSIM"));
}

TEST_F(RunTest, EverySampleTraceAgreesWithTheGoldenModel) {
  const std::filesystem::path samples = std::filesystem::path(ARTU_SOURCE_DIR) / "traces/samples";
  int traces = 0;
  if (std::filesystem::is_directory(samples)) {
    for (const auto& entry : std::filesystem::directory_iterator(samples)) {
      if (entry.path().extension() == ".md") continue;
      EXPECT_THAT(fine({"check", entry.path().string()}).out, HasSubstr("0 differing")) << entry.path();
      ++traces;
    }
  }
  EXPECT_GT(traces, 0) << "there are no samples";
}

}  // namespace
}  // namespace artu::test
