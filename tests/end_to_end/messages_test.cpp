// Rarer things that are refused; the commoner ones are tested beside what they are about.
#include <gmock/gmock.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

class MessagesTest : public ProgramTest {
 protected:
  MessagesTest() { write_scene("tiny.obj"); }

  /// What a grid with these lines is refused with.
  std::string grid(const std::string& lines) const {
    write("grid.toml", "scenes = [\"tiny.obj\"]\nsize = \"8x6\"\n" + lines);
    return refused({"sweep", "grid.toml", "-o", "out"});
  }
  /// What a stage with these lines is refused with.
  std::string stage(const std::string& lines) const {
    write("bad.stage.toml", "[[file]]\npath = \"tiny.obj\"\n" + lines);
    return refused({"run", "bad.stage.toml", "--size", "8x6", "-o", "out"});
  }
  /// The JSON file of a run, changed.
  template <class Change>
  void change(const std::string& file, Change change) const {
    Json json = Json::parse(read(file));
    change(json);
    write(file, json.dump());
  }
};

TEST_F(MessagesTest, OfGrids) {
  const std::string point = "[[point]]\ncore.count = 1\n", axis = "[grid]\ncore.count = [1, 2]\n";
  EXPECT_THAT(grid("fidelity = \"sampled\"\nsample_share = \"10%\"\ntarget_error = \"1%\"\n" + axis),
              HasSubstr("target_error and sample_share exclude each other"));
  EXPECT_THAT(grid("sample_share = \"10%\"\n" + axis),
              HasSubstr("grid.toml:3: sample_share is of fidelity = \"sampled\"; that as well would be right"));
  EXPECT_THAT(grid("fidelity = \"analytic\"\ntarget_error = \"1%\"\n" + axis),
              HasSubstr("grid.toml:4: target_error is of fidelity"));
  EXPECT_THAT(grid("seed = 3\n[screen]\nfidelity = \"analytic\"\n" + axis),
              HasSubstr("grid.toml:3: seed is of fidelity"));
  EXPECT_THAT(grid("invalid = \"drop\"\n" + axis), HasSubstr("refuse or skip would be right"));
  EXPECT_THAT(grid("objectives = [{goal = \"minimise\"}]\n" + axis), HasSubstr("the objective has no figure"));
  EXPECT_THAT(grid("objectives = [{figure = \"fps\", goal = \"best\"}]\n" + axis),
              HasSubstr("goal = \"best\" is none; minimise or maximise would be right"));
  EXPECT_THAT(grid("[screen]\nmargin = -1\n" + axis), HasSubstr("margin is a share; 0 ... 10 would be right"));
  EXPECT_THAT(grid("[screen]\nmargin = \"some\"\n" + axis), HasSubstr("is no number; one would be right"));
  EXPECT_THAT(grid("screen = 3\n" + axis), HasSubstr("screen = 3 is no table; a section [screen] would be right"));
  EXPECT_THAT(grid("[screen]\n[search]\ncore.count = {low = 1, high = 4}\n"), HasSubstr("without [screen]"));
  EXPECT_THAT(grid("[sobol]\nsamples = 4\ncore.count = {low = 1}\n"), HasSubstr("lacks its low or its high end"));
  EXPECT_THAT(grid("pictures = 3\n" + axis), HasSubstr("pictures = 3 is no text; quotes around it would be right"));
  EXPECT_THAT(grid("fps = \"30\"\n" + axis), HasSubstr("is no number; one would be right"));
  for (const char* fps : {"nan", "0", "-1", "inf", "1e9", "-0.0"}) {
    write("grid.toml", "scenes = [\"tiny.obj\"]\nfps = " + std::string(fps) + "\n" + axis);
    EXPECT_THAT(refused({"sweep", "grid.toml", "--dry-run"}), HasSubstr("error: grid.toml:2: --fps: ")) << fps;
    write("grid.toml", "scenes = [\n{file = \"tiny.obj\", fps = " + std::string(fps) + "}]\n" + axis);
    EXPECT_THAT(refused({"sweep", "grid.toml", "--dry-run"}), HasSubstr("error: grid.toml:2: --fps: ")) << fps;
  }
  EXPECT_FALSE(exists("out"));
}

/// TOML can write it, a file name cannot have it, and a message would end there.
TEST_F(MessagesTest, OfZeroBytes) {
  const std::string right = "has a zero byte in it; a text without would be right\n";
  write("grid.toml", "scenes = [\"tiny\\u0000.obj\"]\n[grid]\ncore.count = [1]\n");
  EXPECT_EQ(refused({"sweep", "grid.toml", "--dry-run"}), "error: grid.toml:1: \"tiny\\x00.obj\" " + right);
  EXPECT_EQ(grid("[grid]\ncore.count = [1]\n\"a\\u0000b\" = [2]\n"), "error: grid.toml:5: \"a\\x00b\" " + right);
  EXPECT_EQ(stage("[camera]\nnode = \"a\\u0000\"\n"), "error: bad.stage.toml:4: \"a\\x00\" " + right);
  write("bad.stage.toml", "[[file]]\npath = \"tiny.obj\\u0000\"\n");
  EXPECT_EQ(refused({"run", "bad.stage.toml"}), "error: bad.stage.toml:2: \"tiny.obj\\x00\" " + right);
  write("bad.toml", "[accel.static]\nkind = \"bvh2\\u0000\"\n");
  EXPECT_EQ(refused({"run", "tiny.obj", "-c", "bad.toml"}), "error: bad.toml:2: \"bvh2\\x00\" " + right);
  EXPECT_EQ(refused({"run", "tiny.obj", "--set", "accel.static.kind=\"kd\\u0000\""}),
            "error: --set: \"kd\\x00\" " + right);
}

TEST_F(MessagesTest, OfTooManyPoints) {
  std::string values = "[1";
  for (int i = 2; i <= 64; ++i) values += ", " + std::to_string(i);
  values += "]\n";
  EXPECT_THAT(grid("[grid]\ncore.count = " + values + "core.contexts = " + values + "core.queue_depth = " + values),
              HasSubstr("more than 100000 points; latin_hypercube or sobol would be right"));
  write_scene("b.obj");
  write("grid.toml",
        "scenes = [\"tiny.obj\", \"b.obj\"]\nsize = \"8x6\"\n[sobol]\nsamples = 60000\n"
        "core.contexts = {low = 1, high = 256}\nenergy.build = {low = 0.1, high = 1}\n");
  EXPECT_THAT(refused({"sweep", "grid.toml", "-o", "out"}), HasSubstr("has more than 100000 points; fewer"));
}

TEST_F(MessagesTest, OfWhereASweepRuns) {
  write("grid.toml", "scenes = [\"tiny.obj\"]\nsize = \"8x6\"\n[grid]\ncore.count = [1]\n");
  EXPECT_THAT(refused({"sweep", "grid.toml", "-o", "out", "--backend", "cloud"}),
              HasSubstr("\"cloud\" is none; local or slurm would be right"));
  EXPECT_THAT(refused({"sweep", "grid.toml", "-o", "out", "--backend", "slurm", "--part", "1/2"}),
              HasSubstr("is not for --collect and --part"));
  const Finished no_slurm = program("/usr/bin/env", {"PATH=" + path("."), ARTU_BINARY, "sweep", "grid.toml", "-o",
                                                     "out", "--backend", "slurm", "--quiet"});
  EXPECT_EQ(no_slurm.code, 2);
  EXPECT_THAT(no_slurm.err, HasSubstr("or --backend local, would be right"));
}

TEST_F(MessagesTest, OfAPointThatSomebodyHasChanged) {
  write("grid.toml", "scenes = [\"tiny.obj\"]\nsize = \"8x6\"\n[grid]\ncore.count = [1]\n");
  fine({"sweep", "grid.toml", "-o", "out", "--quiet"});
  const std::string point = "out/" + csv("out/points.csv").at(1).at(1);
  change(point + "/stats.json", [](Json& stats) { stats.erase("frames"); });
  EXPECT_THAT(refused({"sweep", "grid.toml", "-o", "out", "--collect"}), HasSubstr("is not what artu run writes"));
  for (const char* text : {"{\"status\": 3}", "{}", "{\"status\": \"fine\"}", "[]", "3", "", "{"}) {
    write(point + "/error.json", text);
    EXPECT_THAT(refused({"sweep", "grid.toml", "-o", "out", "--collect"}), HasSubstr("/error.json: is no")) << text;
  }
}

TEST_F(MessagesTest, OfTheDescriptionOfASweepThatSomebodyHasChanged) {
  write("grid.toml", "scenes = [\"tiny.obj\"]\nsize = \"8x6\"\n[grid]\ncore.count = [1]\n");
  fine({"sweep", "grid.toml", "-o", "out", "--quiet"});
  for (const std::string& text : {std::string("[]"), std::string("3"), std::string("null"), std::string("\"a\""),
                                  std::string(), std::string("{"), std::string(100000, '[')}) {
    write("out/sweep.json", text);
    EXPECT_THAT(refused({"sweep", "grid.toml", "-o", "out", "--resume"}), HasSubstr("out/sweep.json: is ")) << text;
  }
  write("out/sweep.json", "{}");
  EXPECT_THAT(refused({"sweep", "grid.toml", "-o", "out", "--resume"}),
              HasSubstr("out/sweep.json: is of another sweep"));
}

TEST_F(MessagesTest, OfRunsThatSomebodyHasChanged) {
  const auto run = [&](const std::string& folder) {
    fine({"run", "tiny.obj", "--size", "8x6", "--timeline", "--quiet", "-o", folder});
  };
  run("a");
  change("a/stats.json", [](Json& stats) { stats["totals"]["frames"] = 0; });
  EXPECT_THAT(refused({"explain", "a"}), HasSubstr("stats.json: holds no frame"));
  run("b");
  change("b/stats.json", [](Json& stats) { stats["totals"].erase("tree"); });
  EXPECT_THAT(refused({"explain", "b"}), HasSubstr("stats.json: lacks numbers of a run"));
  run("c");
  change("c/manifest.json", [](Json& manifest) { manifest.erase("size"); });
  EXPECT_THAT(refused({"explain", "c"}), HasSubstr("manifest.json: lacks what was run"));
  run("d");
  change("d/stats.json", [](Json& stats) { stats["frames"][0]["violations"] = {3}; });
  EXPECT_THAT(refused({"report", "d"}), HasSubstr("violations holds what is no text"));
  run("f");
  std::filesystem::remove(path("f/frame_0000.png"));
  std::filesystem::create_directory(path("f/frame_0000.png"));
  EXPECT_EQ(refused({"report", "f"}), "error: f/frame_0000.png: is a folder; a file would be right\n");
  run("e");
  change("e/timeline.json", [](Json& timeline) { timeline["frames"][0]["at"] = Json::array(); });
  EXPECT_THAT(refused({"report", "e"}), HasSubstr("at is empty; one look or more would be right"));
}

TEST_F(MessagesTest, OfStages) {
  EXPECT_THAT(stage("[camera]\nnode = \"eye\"\n"), HasSubstr("\"eye\" is not a node with a camera"));
  EXPECT_THAT(stage("[camera]\nposition = [0, 1, 5]\n[[camera.key]]\ntime = 1\n[[camera.key]]\ntime = 1\n"),
              HasSubstr("must be later than that of the key before"));
  EXPECT_THAT(stage("[camera]\nposition = [0, 1, 1e13]\n"), HasSubstr("three finite numbers, none over 1e12"));
}

TEST_F(MessagesTest, OfModels) {
  write("far.obj", "v 0 0 0\nv 1 0 0\nv 0 1e25 0\nf 1 2 3\n");
  EXPECT_THAT(refused({"run", "far.obj", "-o", "out"}), HasSubstr("vertex 3 is not a finite number or too large"));
  write("huge.obj", "");
  ASSERT_EQ(truncate(path("huge.obj").c_str(), (off_t{1} << 32) + 1), 0);
  EXPECT_THAT(refused({"run", "huge.obj", "-o", "out"}), HasSubstr("has 4294967297 bytes, the limit is 4294967296"));
}

TEST_F(MessagesTest, OfWhatARunIsAskedFor) {
  const auto run = [&](Words more) {
    Words words{"run", "tiny.obj", "--size", "8x6", "-o", "out"};
    words.insert(words.end(), more.begin(), more.end());
    return refused(words);
  };
  EXPECT_THAT(run({"--log", "core9.traversal=debug"}), HasSubstr("--log: no block \"core9.traversal\"; there are"));
  EXPECT_THAT(run({"--set", "core.stack_entries=4", "--set", "core.stack_overflow=spill"}),
              HasSubstr("is less than the line of 8 entries"));
}

/// Of a run that goes on, or that was killed.
TEST_F(MessagesTest, OfAFolderThatAnotherRunWrites) {
  fine({"run", "tiny.obj", "--size", "8x6", "-o", "out", "--quiet"});
  std::filesystem::rename(path("out"), path("out.partial"));
  EXPECT_THAT(refused({"run", "tiny.obj", "--size", "8x6", "-o", "out"}),
              HasSubstr("another run writes it, or one was killed; --force would replace it"));
  fine({"run", "tiny.obj", "--size", "8x6", "-o", "out", "--quiet", "--force"});
}

}  // namespace
}  // namespace artu::test
