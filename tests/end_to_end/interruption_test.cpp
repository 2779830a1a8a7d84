// What a full disk, too little memory and a kill at any moment leave behind: one line, and no half-written file.
#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class InterruptionTest : public ProgramTest {
 protected:
  InterruptionTest() { write_scene("tiny.obj"); }

  /// A shell's commands, in which $artu is the program.
  Finished shell(const std::string& commands) const {
    return program("/bin/sh", {"-c", "artu=" ARTU_BINARY "; " + commands});
  }
};

/// A limit on the size of files is a disk that is full after so many blocks of 512 bytes.
TEST_F(InterruptionTest, AFullDiskIsOneLineAndLeavesNothing) {
  for (const char* command :
       {"run tiny.obj --size 160x90 -o out", "run tiny.obj --size 160x90 -o out --jobs 2 --frames 0:3",
        "run tiny.obj --size 160x90 -o out --timeline", "run tiny.obj --size 64x64 -o out --dump-pixels p.csv",
        "run tiny.obj --size 64x64 -o out --memory-trace m.txt", "import tiny.obj -o a.artu",
        "precision tiny.obj --size 8x8 --bits 23 --trees bvh2 -o out", "scaling tiny.obj --size 8x8 -o out",
        "quality tiny.obj --size 64x64 --references 16 --policies fixed -o out",
        "torture --cases 1 --seed 1 --inject-fault triangle:30 -o out",
        "stress --rays 100 --only box/as-is --json j"}) {
    SCOPED_TRACE(command);
    // Standard output and error are files here as well: they go through pipes.
    const Finished run = shell("trap '' XFSZ; { ( ulimit -f 0; $artu " + std::string(command) +
                               " 2>&1 >/dev/null; echo \"code $?\" ) | cat; } >&2");
    EXPECT_THAT(run.err, EndsWith("\ncode 2\n"));
    EXPECT_THAT(run.err, StartsWith("error: "));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 2) << run.err;
    EXPECT_THAT(content(), ElementsAre("tiny.obj"));
  }
}

TEST_F(InterruptionTest, AStandardOutputWithoutRoomIsOneLine) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  for (const char* command : {"run --list-params", "--help", "run tiny.obj --size 8x8 -o out", "stress --list"}) {
    SCOPED_TRACE(command);
    const Finished run = shell("$artu " + std::string(command) + " >/dev/full");
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err, HasSubstr("standard output"));
  }
}

/// Nobody can be told, but the exit code still says it.
TEST_F(InterruptionTest, AStandardErrorWithoutRoomKeepsTheExitCode) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  for (const char* place : {"2>&-", "2>/dev/full", ">&- 2>&-", ">/dev/full 2>&1", "<&- >&- 2>&-"}) {
    SCOPED_TRACE(place);
    for (const char* command : {"run none.obj", "fly", "run tiny.obj --set core.count=0"}) {
      EXPECT_EQ(shell("$artu " + std::string(command) + " " + place).code, 2) << command;
    }
    EXPECT_EQ(shell("$artu run tiny.obj --size 8x8 --inject-fault dram:0 -o out " + std::string(place)).code, 3);
  }
  EXPECT_THAT(content(), ElementsAre("tiny.obj"));
  for (const char* more : {"", "--quiet --log '*=debug'"}) {
    EXPECT_EQ(shell(std::string("$artu run tiny.obj --size 8x8 --force -o out 2>/dev/full ") + more).code, 2) << more;
    EXPECT_TRUE(exists("out/manifest.json")) << "only what is said about it is lost";
  }
}

/// The first file that is opened would get the number of one that is closed, and what is printed would be in it.
TEST_F(InterruptionTest, ClosedDescriptorsDoNotBecomeFiles) {
  const std::string run = "$artu run tiny.obj --size 16x9 --frames 0:2 --log '*=debug' --dump-pixels ";
  ASSERT_EQ(shell(run + "p.csv -o all 2>/dev/null").code, 0);
  for (const char* closed : {"2>&-", "<&- 2>&-", "--quiet >&-", "--quiet <&- >&- 2>&-"}) {
    SCOPED_TRACE(closed);
    EXPECT_EQ(shell(run + "q.csv --force -o some " + closed).code, 0);
    EXPECT_EQ(read("q.csv"), read("p.csv"));
    EXPECT_EQ(content("some"), content("all"));
    std::filesystem::remove(path("q.csv"));
  }
  // A summary that nobody can get is no success.
  const Finished unheard = shell("$artu run --list-params >&-");
  EXPECT_EQ(unheard.code, 2);
  EXPECT_THAT(unheard.err, StartsWith("error: standard output: "));
}

/// The limit is of a user's processes and threads, and root has none.
TEST_F(InterruptionTest, WithoutAThreadNothingBegins) {
  const std::string user = getuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "";
  if (shell("prlimit " + user + "$artu --version").code != 0) {
    GTEST_SKIP() << "skipped: no user whose threads can be limited";
  }
  const Finished run = shell("prlimit --nproc=1 " + user + "$artu --version");
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, AllOf(StartsWith("error: processes: no thread can be started: "), EndsWith("would be right\n")));
}

/// A gnuplot that says that all went well, as the real one does when the disk is full.
TEST_F(InterruptionTest, APlotThatIsCutOffIsOneLineAndLeavesNothing) {
  std::filesystem::create_directory(path("bin"));
  write("bin/gnuplot", "#!/bin/sh\nprintf '<svg' > scaling.svg\n");
  std::filesystem::permissions(path("bin/gnuplot"), std::filesystem::perms::owner_all);
  const Finished run =
      shell("PATH=$PWD/bin:$PATH $artu scaling tiny.obj --size 8x8 --vary core.count=1,2 --quiet -o out");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, AllOf(StartsWith("error: "), HasSubstr("scaling.svg: gnuplot could not write all of it")));
  EXPECT_THAT(content(), ElementsAre("bin", "tiny.obj"));
}

TEST_F(InterruptionTest, AReaderThatGoesAwayLeavesNothing) {
  const Finished run = shell(
      "{ $artu run tiny.obj --size 160x90 --frames 0:100 --log '*=debug' -o out 2>&1; echo $? > code; } | head -n 1");
  EXPECT_THAT(run.out, StartsWith("log: "));
  EXPECT_EQ(read("code"), std::to_string(128 + SIGPIPE) + "\n");
  EXPECT_THAT(content(), ElementsAre("code", "tiny.obj"));
}

TEST_F(InterruptionTest, SignalsRemoveWhatIsNotComplete) {
  for (const char* jobs : {"1", "3"}) {
    for (const char* signal : {"PIPE", "HUP"}) {
      const Finished run =
          shell(std::string("$artu run tiny.obj --size 640x360 --frames 0:1000 -o out --jobs ") + jobs +
                " & until test -e out.partial || ! kill -0 $!; do sleep 0.02; done; kill -" + signal + " $!; wait $!");
      EXPECT_GT(run.code, 128) << signal;
      EXPECT_THAT(content(), ElementsAre("tiny.obj")) << signal;
    }
  }
}

/// A process that forks has all its signals blocked for a moment, but in the thread that waits for them.
TEST_F(InterruptionTest, ABrokenPipeWhileProcessesStartStopsTheRun) {
  for (int attempt = 0; attempt < 20; ++attempt) {
    const Finished run = shell(
        "$artu run tiny.obj --size 64x36 --frames 0:1000 -o out --jobs 16 & "
        "until test -e out.partial || ! kill -0 $!; do :; done; kill -PIPE $!; wait $!");
    EXPECT_EQ(run.code, 128 + SIGPIPE);
    EXPECT_THAT(content(), ElementsAre("tiny.obj"));
  }
}

TEST_F(InterruptionTest, TooLittleMemoryIsOneLineAndLeavesNothing) {
  const Finished run = shell("ulimit -v 400000; $artu run tiny.obj --size 16384x16384 -o out");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, AllOf(StartsWith("error: "), HasSubstr("out of memory")));
  EXPECT_THAT(content(), ElementsAre("tiny.obj"));
}

/// Whichever of a run's allocations it is that fails, Embree's among them.
TEST_F(InterruptionTest, LittleMemoryIsNeverAnInternalError) {
  for (int megabytes = 60; megabytes <= 240; megabytes += 20) {
    for (const std::string command : {"run", "check"}) {
      const Finished run = shell("ulimit -v " + std::to_string(megabytes * 1000) + "; $artu " + command +
                                 " tiny.obj --size 8x8 --force -o out");
      if (run.code == 0 || run.code == 127) continue;  // 127: the program itself could not be loaded
      EXPECT_EQ(run.code, 2) << megabytes << " " << run.err;
      EXPECT_THAT(run.err, StartsWith("error: ")) << megabytes;
    }
  }
}

TEST_F(InterruptionTest, APlaceThatCannotBeWrittenIsNamedBeforeAnythingRuns) {
  for (const char* place : {"/dev/null/out", "/proc/artu-out"}) {
    EXPECT_THAT(refused({"run", "tiny.obj", "--frames", "0:1000000", "-o", place}),
                AllOf(HasSubstr(place[1] == 'd' ? "/dev/null" : "/proc/artu-out"), HasSubstr("would be right")));
    EXPECT_THAT(refused({"import", "tiny.obj", "-o", place}), HasSubstr(place[1] == 'd' ? "/dev/null" : "/proc"));
  }
}

/// A killed run has no folder under its name, or all of it.
TEST_F(InterruptionTest, AKillAtAnyMomentLeavesAllOrNothing) {
  const std::string whole = "$artu run tiny.obj --size 48x32 --frames 0:6 --pictures all --quiet -o ";
  ASSERT_EQ(shell(whole + "whole").code, 0);
  const std::vector<std::string> files = content("whole");
  unsigned unfinished = 0;
  for (int milliseconds = 0; milliseconds < 300; milliseconds += 15) {
    const std::string name = "out" + std::to_string(milliseconds);
    char pause[16];
    std::snprintf(pause, sizeof pause, "0.%03d", milliseconds);
    shell(whole + name + " & sleep " + pause + "; kill -9 $! 2>/dev/null; wait");
    if (exists(name)) {
      EXPECT_EQ(content(name), files) << name;
    } else {
      ++unfinished;
    }
  }
  EXPECT_GT(unfinished, 0u) << "the first is killed before it can be done";
  // What is left of one does not stand in the way of the next.
  shell(whole + "again & sleep 0.05; kill -9 $!; wait");
  EXPECT_EQ(shell(whole + "again --force").code, 0);
  EXPECT_EQ(content("again"), files);
}

TEST_F(InterruptionTest, AnInterruptLeavesNothing) {
  for (const char* signal : {"TERM", "HUP"}) {  // a shell has background jobs ignore INT: JobsTest has it
    const Finished run =
        shell("$artu run tiny.obj --size 640x360 --frames 0:100000 --quiet -o out & sleep 0.3; kill -" +
              std::string(signal) + " $!; wait $!");
    EXPECT_GT(run.code, 128) << signal;
    EXPECT_THAT(content(), ElementsAre("tiny.obj")) << signal;
  }
}

}  // namespace
}  // namespace artu::test
