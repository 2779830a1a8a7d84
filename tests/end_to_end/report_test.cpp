// `artu report`: the page, opened in a browser, and what it refuses.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// "" where there is one.
std::string no_browser() {
  if (std::system("python3 --version > /dev/null 2>&1") != 0) return "skipped: no python3";
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
    if (std::system((std::string("command -v ") + name + " > /dev/null 2>&1").c_str()) == 0) return "";
  }
  return "skipped: no chromium";
}

class ReportTest : public ProgramTest {
 protected:
  /// A run of two frames with all pictures.
  void run(const std::string& scene, const std::string& folder, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"run", scene, "--size", "24x16", "--frames", "0:2", "-o", folder, "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    fine(words);
  }
  void write_moving_scene() const {
    write_scene("tiny.obj");
    write("moving.stage.toml",
          "[[file]]\npath = \"tiny.obj\"\n[[file.key]]\ntime = 0\n[[file.key]]\ntime = 0.1\nposition = [6, 0, 0]\n");
  }
  void open(const std::string& kind, const std::string& file) const {
    const Finished result =
        program("/usr/bin/env", {"python3", ARTU_SOURCE_DIR "/tests/end_to_end/report_browser.py", kind, path(file)});
    EXPECT_EQ(result.code, 0) << result.out << result.err;
  }
};

TEST_F(ReportTest, ARunsPageWorksInABrowser) {
  if (const std::string why = no_browser(); !why.empty()) GTEST_SKIP() << why;
  write_moving_scene();
  run("moving.stage.toml", "out", {"--pictures", "all", "--check", "--timeline", "--set", "core.count=2"});
  EXPECT_THAT(fine({"report", "out"}).out, HasSubstr("out/report.html"));
  open("run", "out/report.html");
}

/// What `artu sweep` writes: parameters core.count (1 ... 6) and b (1 ... 4), a cost that only the first one changes.
class SweepReportTest : public ReportTest {
 protected:
  static std::string table() {
    std::string rows = "point,folder,scene,frames,size,fidelity,status,core.count,b,cycles_per_frame,fps,name\n";
    for (int i = 0; i < 24; ++i) {
      const int cores = 1 + i / 4, b = 1 + i % 4;
      rows += std::to_string(i + 1) + ",points/" + std::to_string(i) + ",a.glb,0:1,24x16,event,ok," +
              std::to_string(cores) + "," + std::to_string(b) + "," + std::to_string(1000.5 / cores + b) + "," +
              std::to_string(cores) + ",\"</script> \"\"quoted\"\", with a comma\"\n";
    }
    rows += "25,points/24,a.glb,0:1,24x16,event,dead-lock,7,1,,,\n";
    return rows + "26,points/25,b.glb,0:1,24x16,event,ok,1,1,99,5,\n";
  }
  static std::string description() {
    return R"({"schema": 1, "program": "artu", "version": "0", "design": {"kind": "grid"}, "fidelity": "event",
 "scenes": [{"file": "a.glb"}, {"file": "b.glb"}],
 "parameters": [{"path": "core.count", "kind": "integer", "unit": "", "default": 6, "values": [1, 2]},
                {"path": "b", "kind": "integer", "unit": "bytes", "default": 1, "low": 1, "high": 4}],
 "objectives": [{"figure": "cycles_per_frame", "goal": "minimise"}, {"figure": "core.count", "goal": "minimise"}]})";
  }
  void write_sweep(const std::string& folder) const {
    std::filesystem::create_directory(path(folder));
    write(folder + "/sweep.json", description());
    write(folder + "/points.csv", table());
  }
};

TEST_F(SweepReportTest, WorksInABrowser) {
  if (const std::string why = no_browser(); !why.empty()) GTEST_SKIP() << why;
  write_sweep("out");
  fine({"report", "out"});
  open("sweep", "out/report.html");
}

TEST_F(ReportTest, TheSweepThatWasJustMadeWorksInABrowser) {
  if (const std::string why = no_browser(); !why.empty()) GTEST_SKIP() << why;
  write_scene("tiny.obj");
  write("grid.toml",
        "scenes = [\"tiny.obj\"]\nsize = \"24x16\"\n[grid]\ncore.count = [1, 2, 4]\n"
        "accel.static.kind = [\"bvh2\", \"kd\"]\n");
  fine({"sweep", "grid.toml", "-o", "out", "--quiet"});
  fine({"report", "out"});
  open("swept", "out/report.html");
}

TEST_F(SweepReportTest, BrokenSweepsAreRefused) {
  write_sweep("out");
  write_scene("tiny.obj");
  run("tiny.obj", "run");
  EXPECT_THAT(refused({"report", "run", "out"}), HasSubstr("out: is a sweep"));
  const auto with = [this](const std::string& file, const std::string& text) {
    const std::string whole = read("out/" + file);
    write("out/" + file, text);
    std::string line = refused({"report", "out"});
    write("out/" + file, whole);
    return line;
  };
  EXPECT_THAT(with("sweep.json", "{"), HasSubstr("out/sweep.json: is no JSON"));
  EXPECT_THAT(with("sweep.json", "{\"schema\": 2}"), HasSubstr("has schema 2; schema 1"));
  EXPECT_THAT(with("sweep.json", "{\"schema\": 1}"), HasSubstr("has no parameters"));
  EXPECT_THAT(with("points.csv", table() + "1,2\n"), HasSubstr("out/points.csv:28: has 2 cells; 12"));
  EXPECT_THAT(with("points.csv", table() + "\"1,2\n"), HasSubstr("out/points.csv:28: a quote does not end"));
  EXPECT_THAT(with("points.csv", "point,point\n"), HasSubstr("out/points.csv:1: column \"point\" comes twice"));
  EXPECT_THAT(with("points.csv", "point,folder\n"), HasSubstr("has no column scene"));
  EXPECT_THAT(with("points.csv", table().substr(0, table().find('\n') + 1)), HasSubstr("has no points"));
  std::filesystem::remove(path("out/points.csv"));
  EXPECT_THAT(refused({"report", "out"}), HasSubstr("has no points.csv yet"));
}

TEST_F(ReportTest, RunsAreComparedInABrowser) {
  if (const std::string why = no_browser(); !why.empty()) GTEST_SKIP() << why;
  write_moving_scene();
  for (const char* cores : {"1", "2", "3", "4"}) {
    run("moving.stage.toml", std::string("cores-") + cores, {"--set", std::string("core.count=") + cores});
  }
  fine({"report", "cores-1", "cores-2", "-o", "two.html"});
  open("comparison", "two.html");
  fine({"report", "cores-1", "cores-2", "cores-3", "cores-4", "-o", "four.html"});
  open("table", "four.html");
}

TEST_F(ReportTest, NamesCannotBecomeMarkup) {
  // With the folder before it the name ends a script: "a</script>".
  const std::string name =
      "a</script><script>window.hostile = 1<!--\"'&\xe2\x80\xa8 \xc3\xa9" + std::string(120, 'x') + ".obj";
  std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
  write_scene(name);
  run(name, "<img src=x onerror=window.hostile=1>", {"--pictures", "all"});
  fine({"report", "<img src=x onerror=window.hostile=1>", "-o", "page.html"});
  const std::string page = read("page.html");
  EXPECT_THAT(page, Not(HasSubstr("<script>window.hostile")));
  EXPECT_THAT(page, Not(HasSubstr("<img")));
  EXPECT_THAT(page, HasSubstr("\\u003cscript\\u003ewindow.hostile"));
  if (const std::string why = no_browser(); !why.empty()) GTEST_SKIP() << why;
  open("run", "page.html");
}

TEST_F(ReportTest, PicturesThatAreTooManyAreLeftOutEvenly) {
  write_scene("tiny.obj");
  run("tiny.obj", "out");
  fine({"report", "out", "-o", "all.html"});
  const Finished none = fine({"report", "out", "-o", "none.html", "--picture-megabytes", "0"});
  EXPECT_THAT(none.err, HasSubstr("out: the pictures of 2 frames are left out"));
  EXPECT_THAT(read("all.html"), HasSubstr("\"png\":\"iVBOR"));
  EXPECT_THAT(read("none.html"), Not(HasSubstr("\"png\":")));
}

TEST_F(ReportTest, TheSameRunGivesTheSamePage) {
  write_scene("tiny.obj");
  run("tiny.obj", "out");
  fine({"report", "out", "-o", "a.html", "--quiet"});
  fine({"report", "out/", "-o", "b.html", "--quiet"});
  const std::string a = read("a.html");
  EXPECT_EQ(a.size(), read("b.html").size() - 1);  // "out" and "out/"
  fine({"report", "out", "-o", "b.html", "--quiet", "--force"});
  EXPECT_EQ(a, read("b.html"));
}

TEST_F(ReportTest, WhatNoRunMadeIsRefused) {
  write_scene("tiny.obj");
  run("tiny.obj", "out");
  std::filesystem::create_directory(path("empty"));
  EXPECT_THAT(refused({"report"}), HasSubstr("DIR"));
  EXPECT_THAT(refused({"report", "none"}), HasSubstr("none: is no folder"));
  EXPECT_THAT(refused({"report", "tiny.obj"}), HasSubstr("tiny.obj: is no folder"));
  EXPECT_THAT(refused({"report", "empty"}), HasSubstr("empty: is no folder of a run"));
  EXPECT_THAT(refused({"report", "out", "out/"}), HasSubstr("named twice"));
  EXPECT_THAT(refused({"report", "out", "--force", "-o", "out/stats.json"}),
              AllOf(HasSubstr("out/stats.json: is in out, a run's own folder"), HasSubstr("would be right")));
  EXPECT_THAT(refused({"report", "out", "-o", "none/x.html"}), HasSubstr("none/x.html"));
  EXPECT_THAT(content("empty"), ElementsAre());
  fine({"report", "out"});
  EXPECT_THAT(refused({"report", "out"}), HasSubstr("out/report.html: exists already"));
  fine({"report", "out", "--force"});
}

TEST_F(ReportTest, BrokenFilesAreRefused) {
  write_scene("tiny.obj");
  run("tiny.obj", "out", {"--timeline"});
  const auto before = content("out");
  const auto breaks = [this](const std::string& file, const std::string& text) {
    const std::string whole = read("out/" + file);
    write("out/" + file, text);
    std::string line = refused({"report", "out"});
    write("out/" + file, whole);
    EXPECT_THAT(line, HasSubstr("out/" + file));
    return line;
  };
  const std::string stats = read("out/stats.json"), manifest = read("out/manifest.json");
  const auto with = [](std::string text, const std::string& from, const std::string& to) {
    EXPECT_NE(text.find(from), std::string::npos) << from;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_THAT(breaks("stats.json", stats.substr(0, stats.size() / 2)), HasSubstr("is no JSON"));
  EXPECT_THAT(breaks("stats.json", ""), HasSubstr("is no JSON"));
  EXPECT_THAT(breaks("stats.json", "[]"), HasSubstr("has no schema"));
  EXPECT_THAT(breaks("stats.json", std::string(100000, '[')), HasSubstr("nested too deeply"));
  EXPECT_THAT(breaks("stats.json", "\xff"), HasSubstr("is no JSON"));
  EXPECT_THAT(breaks("stats.json", with(stats, "\"schema\": 1", "\"schema\": 99")),
              HasSubstr("has schema 99; schema 1"));
  EXPECT_THAT(breaks("stats.json", with(stats, "\"schema\": 1", "\"schema\": 1e999")), HasSubstr("is no JSON"));
  EXPECT_THAT(breaks("stats.json", with(stats, "\"busy\": ", "\"busy\": \"x\", \"b\": ")),
              HasSubstr("is not an object of numbers"));
  EXPECT_THAT(breaks("manifest.json", with(manifest, "\"artu\"", "\"other\"")), HasSubstr("another program"));
  EXPECT_THAT(breaks("manifest.json", with(manifest, "\"width\"", "\"wide\"")), HasSubstr("has no size.width"));
  const std::string timeline = read("out/timeline.json");
  EXPECT_THAT(breaks("timeline.json", "{\"schema\": 2}"), HasSubstr("has schema 2; schema 1"));
  EXPECT_THAT(breaks("timeline.json", with(timeline, "\"at\":[", "\"at\":[1,")), HasSubstr("has not one value a look"));
  EXPECT_THAT(breaks("timeline.json", with(timeline, "\"at\":[", "\"at\":[null,")),
              HasSubstr("at is not a list of numbers"));
  EXPECT_THAT(breaks("config.toml", "[core]\ncount = 0\n"), HasSubstr("core.count"));
  EXPECT_EQ(content("out"), before);
}

}  // namespace
}  // namespace artu::test
