// What a full disk, too little memory and a kill at any moment leave behind: one line, and no half-written file.
#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

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

  /// A shell's commands, in which "$artu" is the program.
  Finished shell(const std::string& commands) const {
    return program("/bin/sh", {"-c", "artu=$0; " + commands, ARTU_BINARY});
  }
  /// `artu run` of more frames than it ever gets through, into `out`; returns when it has begun to write.
  Running start_endless(const std::string& jobs, const std::string& size = "640x360") const {
    Running run =
        start({"run", "tiny.obj", "--size", size, "--frames", "0:100000", "--quiet", "--jobs", jobs, "-o", "out"});
    EXPECT_TRUE(run.until([&] { return exists("out.partial"); }));
    return run;
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
    const Finished run = shell("trap '' XFSZ; { ( ulimit -f 0; \"$artu\" " + std::string(command) +
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
    const Finished run = shell("\"$artu\" " + std::string(command) + " >/dev/full");
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
      shell("PATH=$PWD/bin:$PATH \"$artu\" scaling tiny.obj --size 8x8 --vary core.count=1,2 --quiet -o out");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, AllOf(StartsWith("error: "), HasSubstr("scaling.svg: gnuplot could not write all of it")));
  EXPECT_THAT(content(), ElementsAre("bin", "tiny.obj"));
}

TEST_F(InterruptionTest, AReaderThatGoesAwayLeavesNothing) {
  const Finished run = shell(
      "{ \"$artu\" run tiny.obj --size 160x90 --frames 0:100 --log '*=debug' -o out 2>&1; echo $? > code; } | head -n "
      "1");
  EXPECT_THAT(run.out, StartsWith("log: "));
  EXPECT_EQ(read("code"), std::to_string(128 + SIGPIPE) + "\n");
  EXPECT_THAT(content(), ElementsAre("code", "tiny.obj"));
}

TEST_F(InterruptionTest, SignalsRemoveWhatIsNotComplete) {
  for (const char* jobs : {"1", "3"}) {
    for (const int signal : {SIGINT, SIGQUIT, SIGTERM, SIGHUP, SIGPIPE}) {
      Running run = start_endless(jobs);
      run.send(signal);
      EXPECT_EQ(run.wait(), 128 + signal);
      EXPECT_THAT(content(), ElementsAre("tiny.obj")) << signal;
    }
  }
}

/// A process that forks has all its signals blocked for a moment, but in the thread that waits for them.
TEST_F(InterruptionTest, ABrokenPipeWhileProcessesStartStopsTheRun) {
  for (int attempt = 0; attempt < 20; ++attempt) {
    Running run = start_endless("16", "64x36");
    run.send(SIGPIPE);
    ASSERT_EQ(run.wait(), 128 + SIGPIPE) << "attempt " << attempt;
    ASSERT_THAT(content(), ElementsAre("tiny.obj")) << "attempt " << attempt;
  }
}

/// As nohup has it.
TEST_F(InterruptionTest, ASignalThatIsIgnoredStaysIgnored) {
  Running run = start_program(
      "/bin/sh", {"-c", "trap '' HUP; exec \"$0\" run tiny.obj --size 32x32 --frames 0:50 -o out", ARTU_BINARY});
  ASSERT_TRUE(run.until([&] { return exists("out.partial") || exists("out"); }));
  run.send(SIGHUP);
  EXPECT_EQ(run.wait(), 0);
  EXPECT_THAT(content(), ElementsAre("out", "tiny.obj"));
}

TEST_F(InterruptionTest, TooLittleMemoryIsOneLineAndLeavesNothing) {
  const Finished run = shell("ulimit -v 400000; \"$artu\" run tiny.obj --size 16384x16384 -o out");
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
  const auto run = [](const std::string& out) {
    return std::vector<std::string>{"run",        "tiny.obj", "--size",  "48x32", "--frames", "0:6",
                                    "--pictures", "all",      "--quiet", "-o",    out};
  };
  const auto begin = std::chrono::steady_clock::now();
  fine(run("whole"));
  const auto whole = std::chrono::steady_clock::now() - begin;
  const std::vector<std::string> files = content("whole");
  const int moments = 20;
  for (int moment = 0; moment < moments; ++moment) {
    const std::string name = "out" + std::to_string(moment);
    Running killed = start(run(name));
    std::this_thread::sleep_for(moment * whole / moments);
    killed.send(SIGKILL);
    killed.wait();
    if (exists(name)) {
      EXPECT_EQ(content(name), files) << name;
    }
  }
}

TEST_F(InterruptionTest, WhatAKilledRunLeavesDoesNotStandInTheWayOfTheNext) {
  Running run = start_endless("1");
  run.send(SIGKILL);
  EXPECT_EQ(run.wait(), 128 + SIGKILL);
  EXPECT_THAT(content(), ElementsAre("out.partial", "tiny.obj"));
  EXPECT_THAT(refused({"run", "tiny.obj", "--size", "8x8", "-o", "out"}), HasSubstr("--force would replace it"));
  fine({"run", "tiny.obj", "--size", "8x8", "-o", "out", "--force"});
  EXPECT_THAT(content(), ElementsAre("out", "tiny.obj"));
}

}  // namespace
}  // namespace artu::test
