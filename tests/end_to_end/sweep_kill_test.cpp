// A sweep that is killed at any moment goes on where it was.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <map>
#include <random>
#include <thread>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using std::chrono::steady_clock;
using ::testing::HasSubstr;

class SweepKillTest : public ProgramTest {
 protected:
  SweepKillTest() {
    write_scene("tiny.obj");
    write("grid.toml",
          "scenes = [\"tiny.obj\"]\nsize = \"48x36\"\n[screen]\nmargin = 0.2\n[grid]\ncore.count = [1, 2, 3, 4, 5, 6]\n"
          "memory.l2.size = [\"16KiB\", \"64KiB\", \"256KiB\"]\n");
    // For each number of cores some points that are soon done and one that never is: two processes get through the
    // first ones, and no machine is so fast, nor a test so slow, that the sweep ends by itself.
    std::string scenes;
    for (int frames = 1; frames <= scenes_ / 2; ++frames) {
      scenes += "{ file = \"tiny.obj\", size = \"48x36\", frames = \"0:" + std::to_string(frames) + "\" }, ";
    }
    write("endless.toml", "scenes = [" + scenes +
                              "{ file = \"tiny.obj\", size = \"640x360\", frames = \"0:100000\" }]\n"
                              "pictures = \"none\"\n[grid]\ncore.count = [1, 2]\n");
  }

  Running sweep(const std::string& grid, const std::string& folder) const {
    return start({"sweep", grid, "-o", folder, "--resume", "--jobs", "2"}, folder + ".err");
  }
  std::size_t count_of(const std::string& folder) const {
    return exists(folder + "/points") ? content(folder + "/points").size() : 0;
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
  void expect_kept(const std::map<std::string, ino_t>& before, const std::map<std::string, ino_t>& after) const {
    for (const auto& [point, inode] : before) {
      ASSERT_EQ(after.count(point), 1u) << point << " was lost";
      EXPECT_EQ(after.at(point), inode) << point << " was simulated again";
    }
  }

  static constexpr int scenes_ = 20;  // of the endless one, those that are soon done, with both numbers of cores
};

/// The moments are spread over the time that a sweep takes on this machine. Whether a kill comes before the end is left
/// to chance, so that the number of attempts is bounded as well, and the last one of a sweep is let through.
TEST_F(SweepKillTest, FiftyTimesAtRandom) {
  const auto begin = steady_clock::now();
  fine({"sweep", "grid.toml", "-o", "whole", "--jobs", "2"});
  const auto whole = steady_clock::now() - begin;
  std::mt19937 random(7);
  int kills = 0, attempts = 0, sweeps = 0;
  const auto goes_on = [&] {
    return kills < 50 && attempts < 200 && steady_clock::now() - begin < std::chrono::minutes(3);
  };
  do {
    const std::string folder = "out" + std::to_string(sweeps++);
    std::map<std::string, ino_t> before;
    for (bool running = true; running;) {
      Running run = sweep("grid.toml", folder);
      if (goes_on()) {
        ++attempts;
        std::this_thread::sleep_for(static_cast<int>(random() % 1000) * whole / 1000);
        run.send(SIGKILL);
      }
      const int code = run.wait();
      running = code == 128 + SIGKILL;
      if (running) {
        ++kills;
      } else {
        ASSERT_EQ(code, 0) << read(folder + ".err");
      }
      const auto after = finished(folder);
      expect_kept(before, after);
      before = after;
    }
    for (const char* file : {"points.csv", "points.sqlite", "sweep.json"}) {
      EXPECT_TRUE(read(folder + "/" + file) == read(std::string("whole/") + file)) << file;
    }
    EXPECT_EQ(content(folder), content("whole"));
    EXPECT_EQ(content(folder + "/points"), content("whole/points"));
  } while (goes_on() && !HasFailure());
}

TEST_F(SweepKillTest, EachTimeItGetsFurther) {
  std::map<std::string, ino_t> before;
  for (int kills = 0; kills < 5; ++kills) {
    Running run = sweep("endless.toml", "out");
    const std::size_t enough = std::min<std::size_t>(before.size() + 1, scenes_);
    ASSERT_TRUE(run.until([&] { return count_of("out") >= enough; })) << read("out.err");
    run.send(SIGKILL);
    EXPECT_EQ(run.wait(), 128 + SIGKILL);
    const auto after = finished("out");
    expect_kept(before, after);
    before = after;
  }
}

TEST_F(SweepKillTest, TwoAtTheSameTimeAreRefused) {
  Running run = sweep("endless.toml", "out");
  ASSERT_TRUE(run.until([&] { return exists("out/sweep.json"); })) << read("out.err");
  EXPECT_THAT(refused({"sweep", "endless.toml", "-o", "out", "--resume"}), HasSubstr("another artu sweep works on it"));
  // The first one goes on.
  EXPECT_TRUE(run.until([&] { return count_of("out") >= scenes_; })) << read("out.err");
  run.send(SIGINT);
  EXPECT_EQ(run.wait(), 128 + SIGINT);
}

TEST_F(SweepKillTest, AnInterruptionLeavesFinishedPointsOnly) {
  Running run = sweep("endless.toml", "out");
  ASSERT_TRUE(run.until([&] { return count_of("out") > 0; })) << read("out.err");
  run.send(SIGINT);
  EXPECT_EQ(run.wait(), 128 + SIGINT);
  EXPECT_FALSE(finished("out").empty());
  if (exists("out/points.partial")) {
    EXPECT_TRUE(content("out/points.partial").empty());
  }
}

}  // namespace
}  // namespace artu::test
