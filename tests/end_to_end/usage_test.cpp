// Bad input: exit code 2, one line that names the place, nothing left behind.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <regex>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class UsageTest : public ProgramTest {
 protected:
  /// All that `artu --help` lists.
  std::vector<std::string> commands() const {
    const std::string help = fine({"--help"}).out;
    const std::regex command("\n  ([a-z]+) +[A-Z]");  // "  scaling                     What one ..."
    std::vector<std::string> names;
    for (std::sregex_iterator found(help.begin(), help.end(), command), end; found != end; ++found) {
      names.push_back(found->str(1));
    }
    EXPECT_GE(names.size(), 10u);
    return names;
  }
};

TEST_F(UsageTest, VersionAndHelpAreFine) {
  EXPECT_THAT(fine({"--version"}).out, ::testing::MatchesRegex("artu [0-9.]+\n"));
  const std::string help = fine({"--help"}).out;
  for (const char* word : {"run", "check", "import", "precision", "diff", "Examples:", "Exit codes:"}) {
    EXPECT_THAT(help, HasSubstr(word));
  }
  EXPECT_THAT(fine({"run", "--help"}).out, HasSubstr("--list-params"));
}

TEST_F(UsageTest, EveryCommandHasAGroupAndExamples) {
  const std::string help = fine({"--help"}).out;
  for (const char* group : {"Simulate", "Look at a run", "Explore a design", "Check the model", "Prepare input"}) {
    EXPECT_THAT(help, HasSubstr("\n" + std::string(group) + ":\n"));
  }
  EXPECT_THAT(help, Not(HasSubstr("Subcommands:")));
  for (const std::string& name : commands()) {
    const std::string own = fine({name, "--help"}).out;
    EXPECT_THAT(own, HasSubstr("\nExamples:\n  artu " + name)) << "use add_examples";
    EXPECT_THAT(own, Not(HasSubstr("Exit codes:")));
  }
}

TEST_F(UsageTest, EveryOptionIsDocumented) {
  std::ifstream file(std::string(ARTU_SOURCE_DIR) + "/docs/usage.md");
  const std::string usage((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::regex option("--[a-z][a-z-]+");
  for (const std::string& command : commands()) {
    const std::string help = fine({command, "--help"}).out;
    for (std::sregex_iterator found(help.begin(), help.end(), option), end; found != end; ++found) {
      EXPECT_THAT(usage, HasSubstr(found->str())) << "docs/usage.md lacks an option of artu " << command;
    }
  }
}

TEST_F(UsageTest, BadCommandLinesAreRefused) {
  EXPECT_THAT(refused({}), HasSubstr("command line: "));
  EXPECT_THAT(refused({"fly"}), HasSubstr("unknown command \"fly\""));
  EXPECT_THAT(refused({"run"}), HasSubstr("SCENE or TRACE is missing"));
  EXPECT_THAT(refused({"run", "a.obj", "b.obj"}), HasSubstr("b.obj"));
  EXPECT_THAT(refused({"run", "--fast"}), AllOf(HasSubstr("--fast"), HasSubstr("; artu run --help shows")));
  EXPECT_THAT(refused({"--fast"}), HasSubstr("; artu --help shows"));
  EXPECT_THAT(refused({"run", "--fidelity", "guess"}), HasSubstr("functional, analytic, sampled, event or clocked"));
  EXPECT_THAT(refused({"run", "--seed", "-1"}), HasSubstr("--seed"));
  EXPECT_THAT(refused({"run", "-c"}), HasSubstr("config"));
  EXPECT_THAT(refused({"import", "a.obj"}), HasSubstr("--output"));
  EXPECT_THAT(refused({"diff", "a.png"}), HasSubstr("B.png"));
  EXPECT_THAT(refused({"run", "a.obj", "-o", ""}), HasSubstr("--output: is empty"));
  EXPECT_THAT(refused({"run", "a.obj", "-c", ""}), HasSubstr("--config: is empty"));
  EXPECT_THAT(refused({"diff", "a.png", ""}), HasSubstr("is empty; a value would be right"));
  EXPECT_THAT(content(), IsEmpty());
}

TEST_F(UsageTest, BadScenesAreRefused) {
  write("text.obj", "no scene\n");
  write("text.glb", "no scene\n");
  write("text.doc", "no scene\n");
  write("empty.glb", "");
  const auto before = content();
  for (const std::string name : {"text.glb", "text.doc", "empty.glb", "none.glb", ".", "/dev/null"}) {
    for (const std::string command : {"run", "check"}) {
      EXPECT_THAT(refused({command, name, "-o", "out"}), HasSubstr(name)) << command;
    }
    EXPECT_THAT(refused({"import", name, "-o", "out.trace"}), HasSubstr(name));
    EXPECT_EQ(content(), before) << name;
  }
}

TEST_F(UsageTest, ASceneThatCannotBeReachedIsNotCalledMissing) {
  std::filesystem::create_symlink("loop.obj", path("loop.obj"));
  EXPECT_THAT(refused({"run", "loop.obj"}),
              AllOf(HasSubstr("loop.obj: cannot be read: "), HasSubstr("would be right")));
}

/// A pipe that nobody writes to would be waited for.
TEST_F(UsageTest, WhatIsNoRegularFileIsRefused) {
  write_scene("tiny.obj");
  fine({"run", "tiny.obj", "--size", "8x8", "-o", "a", "--quiet"});
  std::filesystem::copy(path("a"), path("b"), std::filesystem::copy_options::recursive);
  for (const char* name : {"b/stats.json", "pipe.obj", "pipe.glb", "pipe.stage.toml", "pipe.trace", "pipe.png"}) {
    std::filesystem::remove(path(name));
    ASSERT_EQ(mkfifo(path(name).c_str(), 0600), 0);
  }
  write("a.stage.toml", "[[file]]\npath = \"pipe.obj\"\n");
  write("grid.toml", "scenes = [\"pipe.obj\"]\n[grid]\ncore.count = [1]\n");
  const auto before = content();
  const auto pipe = HasSubstr("is a pipe; a regular file would be right");
  for (const std::string scene : {"pipe.obj", "pipe.glb", "pipe.stage.toml", "pipe.trace"}) {
    for (const std::string command : {"run", "check", "scaling", "reuse", "quality", "precision", "bench"}) {
      EXPECT_THAT(refused({command, scene}), AllOf(HasSubstr(scene + ": "), pipe)) << command;
    }
    EXPECT_THAT(refused({"import", scene, "-o", "x.trace"}), pipe);
  }
  EXPECT_THAT(refused({"run", "a.stage.toml"}),
              HasSubstr("a.stage.toml:2: [[file]]: no such file: ./pipe.obj (no regular file)"));
  EXPECT_THAT(refused({"sweep", "grid.toml", "--dry-run"}), AllOf(HasSubstr("grid.toml:1: "), pipe));
  EXPECT_THAT(refused({"sweep", "pipe.stage.toml", "-o", "out"}), pipe);
  EXPECT_THAT(refused({"run", "tiny.obj", "-c", "pipe.obj"}), pipe);
  EXPECT_THAT(refused({"run", "tiny.obj", "-c", "/dev/zero"}), HasSubstr("/dev/zero: is a device; a regular file"));
  EXPECT_THAT(refused({"diff", "a/frame_0000.png", "pipe.png"}), pipe);
  EXPECT_THAT(refused({"explain", "b"}), pipe);
  EXPECT_THAT(refused({"report", "b"}), pipe);
  EXPECT_EQ(content(), before);
}

TEST_F(UsageTest, ASeedOfNothingIsRefused) {
  write_scene("tiny.obj");
  const auto before = content();
  for (const std::string mode : {"functional", "analytic", "event", "clocked"}) {
    EXPECT_THAT(refused({"run", "tiny.obj", "--size", "8x8", "--fidelity", mode, "--seed", "2", "-o", "out"}),
                HasSubstr("--seed: nothing is drawn; with --random-stall"));
  }
  EXPECT_EQ(content(), before);
  fine({"check", "tiny.obj", "--size", "8x8", "--seed", "2", "--random-stall"});
}

TEST_F(UsageTest, BadFramesAndSizesAreRefused) {
  write_scene("tiny.obj");
  fine({"import", "tiny.obj", "--size", "8x8", "--frames", "4:6", "-o", "tiny.trace"});
  const auto before = content();
  EXPECT_THAT(refused({"run", "tiny.obj", "--frames", "2:2"}), HasSubstr("--frames: 2:2 is empty"));
  EXPECT_THAT(refused({"run", "tiny.obj", "--frames", "x"}), HasSubstr("A:B"));
  EXPECT_THAT(refused({"run", "tiny.obj", "--size", "0x8"}), HasSubstr("1x1 ... 16384x16384"));
  EXPECT_THAT(refused({"run", "tiny.obj", "--size", "8"}), HasSubstr("640x360"));
  EXPECT_THAT(refused({"run", "tiny.obj", "--fps", "0"}), HasSubstr("--fps"));
  EXPECT_THAT(refused({"run", "tiny.obj", "--fps", "nan"}), HasSubstr("--fps"));
  EXPECT_THAT(refused({"run", "tiny.trace", "--frames", "0:2"}), HasSubstr("it holds frames 4:6"));
  EXPECT_THAT(refused({"run", "tiny.trace", "--frames", "5:7"}), HasSubstr("it holds frames 4:6"));
  EXPECT_THAT(refused({"run", "tiny.trace", "--size", "8x8"}), HasSubstr("a trace has its own size"));
  EXPECT_THAT(refused({"run", "tiny.trace", "--fps", "8"}), HasSubstr("a trace has its own rate"));
  EXPECT_THAT(refused({"import", "tiny.trace", "-o", "x.trace"}), HasSubstr("is a trace already"));
  EXPECT_EQ(content(), before);
}

TEST_F(UsageTest, BadConfigurationsAreRefused) {
  write_scene("tiny.obj");
  write("bad.toml", "[core]\ncount = 2\n\ncontext = 4\n");
  const auto before = content();
  EXPECT_EQ(refused({"run", "tiny.obj", "-c", "bad.toml"}),
            "error: bad.toml:4: unknown parameter core.context; did you mean core.contexts?\n");
  EXPECT_THAT(refused({"run", "tiny.obj", "-c", "none.toml"}), HasSubstr("none.toml"));
  EXPECT_THAT(refused({"run", "tiny.obj", "-c", "."}), HasSubstr("is a folder"));
  EXPECT_EQ(refused({"run", "tiny.obj", "--set", "core.count=0"}),
            "error: --set: core.count = 0 is out of range; 1 ... 64 would be right\n");
  EXPECT_THAT(refused({"run", "tiny.obj", "--set", "core.node_cache.ways=64", "--set", "core.node_cache.size=256"}),
              HasSubstr("at most 4 ways"));
  EXPECT_EQ(content(), before);
}

TEST_F(UsageTest, ATraceThatWasCutIsRefused) {
  write_scene("tiny.obj");
  fine({"import", "tiny.obj", "--size", "8x8", "--frames", "0:2", "-o", "tiny.trace"});
  const std::string whole = read("tiny.trace");
  for (const std::size_t length : {whole.size() - 1, whole.size() / 2, std::size_t{20}}) {
    write("cut.trace", whole.substr(0, length));
    EXPECT_THAT(refused({"run", "cut.trace", "--frames", "all", "-o", "out"}), HasSubstr("cut.trace"));
    EXPECT_THAT(content(), ElementsAre("cut.trace", "tiny.obj", "tiny.trace"));
  }
}

TEST_F(UsageTest, PlacesThatCannotBeWrittenAreRefused) {
  write_scene("tiny.obj");
  const auto before = content();
  EXPECT_THAT(refused({"run", "tiny.obj", "-o", "/proc/artu"}), HasSubstr("/proc/artu"));
  EXPECT_THAT(refused({"run", "tiny.obj", "-o", "tiny.obj/out"}), HasSubstr("tiny.obj: cannot write"));
  EXPECT_THAT(refused({"run", "tiny.obj", "--dump-pixels", "none/x.csv"}), HasSubstr("none/x.csv"));
  EXPECT_THAT(refused({"import", "tiny.obj", "--size", "8x8", "-o", "none/x.trace"}), HasSubstr("none/x.trace"));
  EXPECT_EQ(content(), before);
}

TEST_F(UsageTest, DiffRefusesWhatItCannotCompare) {
  write_scene("tiny.obj");
  fine({"run", "tiny.obj", "--size", "8x8", "-o", "a"});
  fine({"run", "tiny.obj", "--size", "8x9", "-o", "b"});
  EXPECT_THAT(refused({"diff", "a/frame_0000.png", "b/frame_0000.png"}), HasSubstr("8x9"));
  EXPECT_THAT(refused({"diff", "a/frame_0000.png", "tiny.obj"}), HasSubstr("not a PNG"));
  EXPECT_THAT(refused({"diff", "none.png", "a/frame_0000.png"}), HasSubstr("none.png"));
}

}  // namespace
}  // namespace artu::test
