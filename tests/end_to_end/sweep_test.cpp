// `artu sweep` as a user sees it.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

class SweepTest : public ProgramTest {
 protected:
  SweepTest() { write_scene("tiny.obj"); }

  void grid(const std::string& text) const { write("grid.toml", "scenes = [\"tiny.obj\"]\nsize = \"16x12\"\n" + text); }
  /// Cells of a column of out/points.csv.
  std::vector<std::string> column(const std::string& name, const std::string& table = "out/points.csv") const {
    const auto rows = csv(table);
    const auto place = std::find(rows.at(0).begin(), rows.at(0).end(), name) - rows.at(0).begin();
    std::vector<std::string> cells;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      cells.push_back(place < std::ptrdiff_t(rows[i].size()) ? rows[i][std::size_t(place)] : "");
    }
    return cells;
  }
  nlohmann::json json(const std::string& name) const { return nlohmann::json::parse(read(name)); }
};

TEST_F(SweepTest, APointIsWhatARunLeaves) {
  write("base.toml", "[core]\ncontexts = 8\n");
  grid(
      "config = [\"base.toml\"]\nset = [\"shading.max_depth=1\"]\nframes = \"0:2\"\n"
      "[grid]\ncore.count = [1, 3]\naccel.static.kind = [\"bvh2\", \"kd\"]\n");
  const Finished sweep = fine({"sweep", "grid.toml", "-o", "out"});
  EXPECT_THAT(sweep.out, HasSubstr("4 ok"));
  EXPECT_THAT(content("out"), UnorderedElementsAre("points", "points.csv", "points.sqlite", "sweep.json"));
  const std::vector<std::string> folders = column("folder");
  ASSERT_EQ(folders.size(), 4u);
  EXPECT_THAT(column("core.count"), ::testing::ElementsAre("1", "1", "3", "3"));
  EXPECT_THAT(column("accel.static.kind"), ::testing::ElementsAre("bvh2", "kd", "bvh2", "kd"));
  for (std::size_t i = 0; i < folders.size(); ++i) {
    const std::string folder = "out/" + folders[i], own = "run" + std::to_string(i);
    const auto manifest = json(folder + "/manifest.json");
    std::vector<std::string> words = manifest.at("command");
    EXPECT_EQ(words[0], "artu");
    words.erase(words.begin());
    words.insert(words.end(), {"-o", own, "--quiet"});
    fine(words);
    ASSERT_EQ(content(folder), content(own));
    for (const std::string& name : content(own)) {
      EXPECT_TRUE(repeatable(name, read(folder + "/" + name)) == repeatable(name, read(own + "/" + name))) << name;
    }
    const auto totals = json(own + "/stats.json").at("totals");
    EXPECT_EQ(column("cycles")[i], totals.at("cycles").dump());
    EXPECT_EQ(column("dram.read_bytes")[i], totals.at("dram").at("read_bytes").dump());
    EXPECT_EQ(column("energy.frame_uj")[i], json(own + "/stats.json").at("energy").at("frame_uj").dump());
    EXPECT_THAT(read("out/points.csv"),
                HasSubstr(json(own + "/stats.json").at("demand").at("bottleneck").get<std::string>()));
  }
}

TEST_F(SweepTest, TheTableIsTheSameWithSeveralProcesses) {
  grid(
      "fidelity = \"analytic\"\n[latin_hypercube]\nsamples = 12\nseed = 3\ncore.count = [1, 16]\n"
      "memory.l2.size = [\"16KiB\", \"1MiB\"]\n");
  fine({"sweep", "grid.toml", "-o", "one"});
  fine({"sweep", "grid.toml", "-o", "three", "--jobs", "3"});
  for (const char* file : {"points.csv", "points.sqlite", "sweep.json"}) {
    EXPECT_TRUE(read(std::string("one/") + file) == read(std::string("three/") + file)) << file;
  }
  EXPECT_EQ(content("one/points"), content("three/points"));
  EXPECT_EQ(column("energy.frame_uj", "one/points.csv")[0], "") << "analytic has no energy";
  EXPECT_NE(column("cycles.low", "one/points.csv")[0], "");
}

TEST_F(SweepTest, TheDescriptionHasTheParameters) {
  grid(
      "objectives = [\"memory.l2.size\", { figure = \"fps\", goal = \"maximise\" }]\n"
      "[sobol]\nsamples = 2\ncore.count = [1, 4]\nmemory.l2.size = { low = \"16KiB\", high = \"64KiB\" }\n");
  fine({"sweep", "grid.toml", "-o", "out"});
  const auto sweep = json("out/sweep.json");
  EXPECT_EQ(sweep.at("schema"), 1);
  EXPECT_EQ(sweep.at("design").at("kind"), "sobol");
  EXPECT_EQ(sweep.at("parameters").at(1).at("path"), "memory.l2.size");
  EXPECT_EQ(sweep.at("parameters").at(1).at("unit"), "bytes");
  EXPECT_EQ(sweep.at("parameters").at(1).at("low"), 16384);
  EXPECT_EQ(sweep.at("objectives").at(1).at("goal"), "maximise");
}

TEST_F(SweepTest, AResumedSweepDoesNoPointTwice) {
  grid("[grid]\ncore.count = [1, 2, 3]\n");
  fine({"sweep", "grid.toml", "-o", "out"});
  const std::string table = read("out/points.csv"), folder = "out/" + column("folder")[1];
  const auto first = std::filesystem::last_write_time(path("out/" + column("folder")[0] + "/stats.json"));
  std::filesystem::remove_all(path(folder));
  fine({"sweep", "grid.toml", "-o", "out", "--collect"});
  EXPECT_THAT(column("status"), ::testing::ElementsAre("ok", "pending", "ok"));
  EXPECT_FALSE(exists(folder));
  fine({"sweep", "grid.toml", "-o", "out", "--resume"});
  EXPECT_TRUE(exists(folder + "/stats.json"));
  EXPECT_EQ(read("out/points.csv"), table);
  EXPECT_EQ(std::filesystem::last_write_time(path("out/" + column("folder")[0] + "/stats.json")), first);
}

TEST_F(SweepTest, AFileThatIsSeveralScenesHasANameForEach) {
  write("grid.toml",
        "scenes = [\"tiny.obj\", {file = \"tiny.obj\", frames = \"0:2\"}, {file = \"tiny.obj\", fps = 60}]\n"
        "size = \"8x8\"\n[grid]\ncore.count = [1, 2]\n");
  fine({"sweep", "grid.toml", "-o", "out"});
  const std::vector<std::string> names = column("scene");
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()),
            (std::set<std::string>{"tiny.obj (frames 0:1; 30 fps)", "tiny.obj (frames 0:2; 30 fps)",
                                   "tiny.obj (frames 0:1; 60 fps)"}));
  EXPECT_EQ(json("out/sweep.json").at("scenes").at(1).at("file"), "tiny.obj");
}

TEST_F(SweepTest, ASceneThatAnotherFileHasChangedIsAnotherScene) {
  write("a.stage.toml", "[[file]]\npath = \"tiny.obj\"\n");
  write("grid.toml", "scenes = [\"a.stage.toml\"]\nsize = \"16x12\"\n[grid]\ncore.count = [1, 2]\n");
  fine({"sweep", "grid.toml", "-o", "out"});
  std::filesystem::remove_all(path("out/" + column("folder")[1]));
  write("tiny.obj", read("tiny.obj") + "f 2 3 5\n");
  EXPECT_THAT(refused({"sweep", "grid.toml", "-o", "out", "--resume"}),
              HasSubstr("is of another sweep: scenes/0/sha256"));
}

TEST_F(SweepTest, PartsMakeUpTheWhole) {
  grid("[grid]\ncore.count = [1, 2, 3, 4, 5]\n");
  fine({"sweep", "grid.toml", "-o", "whole"});
  EXPECT_THAT(refused({"sweep", "grid.toml", "-o", "out", "--part", "0/2"}), HasSubstr("is not the folder of a sweep"));
  fine({"sweep", "grid.toml", "-o", "out"});
  for (const std::string& folder : column("folder")) std::filesystem::remove_all(path("out/" + folder));
  fine({"sweep", "grid.toml", "-o", "out", "--part", "1/2"});
  EXPECT_EQ(content("out/points").size(), 2u);
  fine({"sweep", "grid.toml", "-o", "out", "--part", "0/2"});
  fine({"sweep", "grid.toml", "-o", "out", "--collect"});
  EXPECT_EQ(read("out/points.csv"), read("whole/points.csv"));
  EXPECT_THAT(content("out"), UnorderedElementsAre("points", "points.csv", "points.sqlite", "sweep.json"));
}

TEST_F(SweepTest, AnotherGridIsRefused) {
  grid("[grid]\ncore.count = [1, 2]\n");
  fine({"sweep", "grid.toml", "-o", "out"});
  EXPECT_THAT(refused({"sweep", "grid.toml", "-o", "out"}), HasSubstr("--resume to go on"));
  grid("[grid]\ncore.count = [1, 3]\n");
  EXPECT_THAT(refused({"sweep", "grid.toml", "-o", "out", "--resume"}),
              HasSubstr("out/sweep.json: is of another sweep: parameters/0/values/1 is 2 there and 3 here"));
  EXPECT_EQ(column("core.count"), (std::vector<std::string>{"1", "2"}));
  fine({"sweep", "grid.toml", "-o", "out", "--force"});
  EXPECT_EQ(column("core.count"), (std::vector<std::string>{"1", "3"}));
  std::filesystem::create_directory(path("mine"));
  write("mine/notes.txt", "mine");
  for (const char* option : {"--force", "--resume"}) {
    EXPECT_THAT(refused({"sweep", "grid.toml", "-o", "mine", option}), HasSubstr("is not the folder of a sweep"));
  }
  EXPECT_EQ(read("mine/notes.txt"), "mine");
}

TEST_F(SweepTest, APointThatFailsDoesNotStopTheSweep) {
  grid("[grid]\ncore.stack_entries = [1, 64]\n");
  const Finished sweep = artu({"sweep", "grid.toml", "-o", "out"});
  EXPECT_EQ(sweep.code, 2);
  EXPECT_THAT(sweep.err, HasSubstr("refused; error.json says more"));
  EXPECT_THAT(column("status"), ::testing::ElementsAre("refused", "ok"));
  EXPECT_THAT(json("out/" + column("folder")[0] + "/error.json").at("message").get<std::string>(),
              HasSubstr("core.stack_entries is 1"));
  EXPECT_EQ(artu({"sweep", "grid.toml", "-o", "out", "--resume", "--quiet"}).code, 2);

  grid("inject_fault = \"dram:0\"\n[grid]\ncore.count = [1, 2]\n");
  EXPECT_EQ(artu({"sweep", "grid.toml", "-o", "locked"}).code, 3);
  EXPECT_THAT(column("status", "locked/points.csv"), ::testing::ElementsAre("dead-lock", "dead-lock"));

  grid("[grid]\ncore.count = [1, 2]\n");
  fine({"sweep", "grid.toml", "-o", "broken"});
  const std::string stats = "broken/" + column("folder", "broken/points.csv")[1] + "/stats.json";
  auto changed = json(stats);
  changed["frames"][0]["violations"] = {"one and one is three"};
  write(stats, changed.dump());
  EXPECT_EQ(artu({"sweep", "grid.toml", "-o", "broken", "--resume"}).code, 4);
  EXPECT_THAT(column("status", "broken/points.csv"), ::testing::ElementsAre("ok", "violated"));
}

/// What a point cannot help ends the sweep, and is tried again.
TEST_F(SweepTest, AFileThatIsGoneForAMomentRefusesNoPoint) {
  std::string values = "1";
  for (int i = 2; i <= 64; ++i) values += ", " + std::to_string(i);
  grid("pictures = \"none\"\n[grid]\ncore.queue_depth = [" + values + "]\n");
  const Finished sweep =
      program("/bin/sh",
              {"-c", ARTU_BINARY " sweep grid.toml -o out --quiet & "
                                 "until test -n \"$(ls out/points 2>/dev/null)\" || ! kill -0 $!; do sleep 0.01; done; "
                                 "mv tiny.obj away; wait $!"});
  EXPECT_EQ(sweep.code, 2);
  EXPECT_THAT(sweep.err, HasSubstr("error: tiny.obj: cannot read: "));
  std::filesystem::rename(path("away"), path("tiny.obj"));
  fine({"sweep", "grid.toml", "-o", "out", "--resume", "--quiet"});
  EXPECT_THAT(column("status"), ::testing::Each("ok"));
}

TEST_F(SweepTest, TheFrontOfWhatWasScreenedIsConfirmed) {
  grid(
      "objectives = [\"cycles_per_frame\", \"core.count\"]\npictures = \"none\"\n[screen]\nfidelity = \"analytic\"\n"
      "[grid]\ncore.count = [1, 2, 4]\nmemory.interconnect_latency = [4, 400]\n");
  const Finished sweep = fine({"sweep", "grid.toml", "-o", "out"});
  const auto fidelity = column("fidelity"), confirms = column("confirms"),
             latency = column("memory.interconnect_latency");
  ASSERT_GT(fidelity.size(), 6u);
  for (std::size_t i = 0; i < fidelity.size(); ++i) {
    EXPECT_EQ(fidelity[i], i < 6 ? "analytic" : "event");
    EXPECT_EQ(confirms[i].empty(), i < 6);
    if (i < 6) continue;
    EXPECT_EQ(latency[i], "4") << "a slower unit of the same size is dominated";
    EXPECT_EQ(column("core.count")[i], column("core.count")[std::stoul(confirms[i])]);
  }
  EXPECT_EQ(column("energy.frame_uj")[0], "");
  EXPECT_NE(column("energy.frame_uj")[6], "");
  const std::string table = read("out/points.csv");
  std::filesystem::remove_all(path("out/" + column("folder")[6]));
  fine({"sweep", "grid.toml", "-o", "out", "--resume", "--jobs", "2"});
  EXPECT_EQ(read("out/points.csv"), table);
}

TEST_F(SweepTest, BadCommandLinesAreRefused) {
  grid("[grid]\ncore.count = [1, 2]\n");
  const auto before = content();
  EXPECT_THAT(refused({"sweep"}), HasSubstr("GRID"));
  EXPECT_THAT(refused({"sweep", "none.toml", "-o", "out"}), HasSubstr("none.toml"));
  EXPECT_THAT(refused({"sweep", "grid.toml"}), HasSubstr("-o DIR"));
  EXPECT_THAT(refused({"sweep", "grid.toml", "-o", "out", "--resume", "--force"}), HasSubstr("exclude each other"));
  EXPECT_THAT(refused({"sweep", "grid.toml", "-o", "tiny.obj/out"}), HasSubstr("tiny.obj"));
  for (const char* part : {"1", "2/2", "a/b", "/2", "1/", "0/0", "1/2/3"}) {
    EXPECT_THAT(refused({"sweep", "grid.toml", "-o", "out", "--part", part}), HasSubstr("K/T"));
  }
  EXPECT_THAT(fine({"sweep", "grid.toml", "--dry-run"}).out, HasSubstr("core.count  1, 2"));
  grid("frames = \"0:2\"\nfps = -1.0\n[grid]\ncore.count = [1, 2]\n");
  EXPECT_THAT(refused({"sweep", "grid.toml", "-o", "out"}), HasSubstr("--fps"));
  EXPECT_EQ(content(), before);
}

}  // namespace
}  // namespace artu::test
