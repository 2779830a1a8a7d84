// A sweep that is killed at any moment goes on where it was.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <map>
#include <random>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

class SweepKillTest : public ProgramTest {
 protected:
  SweepKillTest() {
    write_scene("tiny.obj");
    write("grid.toml",
          "scenes = [\"tiny.obj\"]\nsize = \"48x36\"\n[screen]\nmargin = 0.2\n[grid]\ncore.count = [1, 2, 3, 4, 5, 6]\n"
          "memory.l2.size = [\"16KiB\", \"64KiB\", \"256KiB\"]\n");
  }

  /// Without waiting for its end.
  pid_t start(const std::string& folder) const {
    const pid_t child = fork();
    if (child == 0) {
      const int null = open("/dev/null", O_WRONLY);
      if (null < 0 || dup2(null, 1) < 0 || dup2(null, 2) < 0 || chdir(path(".").c_str()) != 0) _exit(127);
      execl(ARTU_BINARY, ARTU_BINARY, "sweep", "grid.toml", "-o", folder.c_str(), "--resume", "--jobs", "2", nullptr);
      _exit(127);
    }
    return child;
  }

  /// What tells a finished point from one that was simulated again.
  std::map<std::string, ino_t> finished(const std::string& folder) const {
    std::map<std::string, ino_t> points;
    if (!exists(folder + "/points")) return points;
    for (const std::string& point : content(folder + "/points")) {
      struct stat status {};
      const std::string stats = path(folder + "/points/" + point + "/stats.json");
      EXPECT_EQ(stat(stats.c_str(), &status), 0) << point << " is there, but not whole";
      points[point] = status.st_ino;
    }
    return points;
  }
};

TEST_F(SweepKillTest, FiftyTimesAtRandom) {
  fine({"sweep", "grid.toml", "-o", "whole", "--jobs", "2"});
  std::mt19937 random(7);
  int kills = 0, sweeps = 0, left = 0;
  while (kills < 50) {
    const std::string folder = "out" + std::to_string(sweeps++);
    std::map<std::string, ino_t> before;
    for (bool running = true; running;) {
      const pid_t child = start(folder);
      usleep(static_cast<useconds_t>(random() % 300'000));
      kill(child, SIGKILL);
      int status = 0;
      waitpid(child, &status, 0);
      if (WIFEXITED(status)) {
        EXPECT_EQ(WEXITSTATUS(status), 0);
        running = false;
      } else {
        ++kills;
      }
      const auto after = finished(folder);
      for (const auto& [point, inode] : before) {
        ASSERT_EQ(after.count(point), 1u) << point << " was lost";
        EXPECT_EQ(after.at(point), inode) << point << " was simulated again";
      }
      if (running && !after.empty() && after.size() < finished("whole").size()) ++left;
      before = after;
    }
    for (const char* file : {"points.csv", "points.sqlite", "sweep.json"}) {
      EXPECT_TRUE(read(folder + "/" + file) == read(std::string("whole/") + file)) << file;
    }
    EXPECT_EQ(content(folder), content("whole"));
    EXPECT_EQ(content(folder + "/points"), content("whole/points"));
  }
  EXPECT_GT(left, 5) << "hardly any was killed between two points";
}

TEST_F(SweepKillTest, TwoAtTheSameTimeAreRefused) {
  const pid_t child = start("out");
  while (!exists("out/sweep.json")) usleep(1000);
  kill(child, SIGSTOP);  // it holds the folder, and goes on only when the other has given up
  const Finished second = artu({"sweep", "grid.toml", "-o", "out", "--resume"});
  kill(child, SIGCONT);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(second.code, 2);
  EXPECT_THAT(second.err, ::testing::HasSubstr("another artu sweep works on it"));
}

TEST_F(SweepKillTest, AnInterruptionLeavesFinishedPointsOnly) {
  const pid_t child = start("out");
  while (!exists("out/points") || content("out/points").empty()) usleep(1000);
  kill(child, SIGINT);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 128 + SIGINT);
  for (const std::string& point : content("out/points")) {
    EXPECT_TRUE(exists("out/points/" + point + "/stats.json")) << point;
  }
  if (exists("out/points.partial")) {
    EXPECT_TRUE(content("out/points.partial").empty());
  }
}

}  // namespace
}  // namespace artu::test
