// --jobs: the same files as with one process, and nothing left where a process dies.
#include <gmock/gmock.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using ::testing::HasSubstr;

class JobsTest : public ProgramTest {
 protected:
  void expect_same_folders(const std::string& a, const std::string& b) const {
    ASSERT_EQ(content(a), content(b));
    for (const std::string& name : content(a)) {
      const std::string in_a = repeatable(name, read(a + "/" + name)), in_b = repeatable(name, read(b + "/" + name));
      EXPECT_TRUE(in_a == in_b) << name;
    }
  }
  /// Runs the command with one process and with three.
  void expect_same(std::vector<std::string> args) const {
    args.insert(args.end(), {"-o", "one"});
    fine(args);
    args.back() = "three";
    args.insert(args.end(), {"--jobs", "3"});
    fine(args);
    expect_same_folders("one", "three");
  }

  /// `artu run` of more frames than it ever gets through, with two processes; returns when they are at work.
  Running start_endless() const {
    Running run =
        start({"run", "tiny.obj", "--size", "640x360", "--frames", "0:100000", "--jobs", "2", "-o", "out"}, "err");
    EXPECT_TRUE(run.until([&] { return workers_of(run.pid()).size() == 2 && exists("out.partial"); })) << read("err");
    return run;
  }
  static std::string children_of(pid_t pid) {
    return "/proc/" + std::to_string(pid) + "/task/" + std::to_string(pid) + "/children";
  }
  static bool knows_children() { return std::ifstream(children_of(getpid())).is_open(); }
  static std::vector<pid_t> workers_of(pid_t parent) {
    std::ifstream file(children_of(parent));
    std::vector<pid_t> workers;
    for (pid_t pid; file >> pid;) workers.push_back(pid);
    return workers;
  }

  JobsTest() { write_scene("tiny.obj"); }
  const std::string sample_ = std::string(ARTU_SOURCE_DIR) + "/traces/samples/skinned_tube.artu";
};

TEST_F(JobsTest, ARunWritesTheSameFiles) {
  const std::vector<std::string> run{"run", "tiny.obj", "--size",     "20x14", "--frames",
                                     "0:7", "--check",  "--pictures", "all"};
  std::vector<std::string> with = run;
  with.insert(with.end(), {"--dump-pixels", "one.csv", "-o", "one"});
  const Finished one = fine(with);
  with = run;
  with.insert(with.end(), {"--dump-pixels", "three.csv", "-o", "three", "--jobs", "3"});
  const Finished three = fine(with);
  expect_same_folders("one", "three");
  EXPECT_TRUE(read("one.csv") == read("three.csv"));
  EXPECT_THAT(three.out, HasSubstr("1960 pixels compared with the golden model, 0 differing"));
}

TEST_F(JobsTest, AMismatchIsTheSame) {
  const std::vector<std::string> check{"check",    "tiny.obj", "--size",         "20x14",
                                       "--frames", "0:5",      "--inject-fault", "shading:3"};
  const Finished one = artu(check);
  std::vector<std::string> with = check;
  with.insert(with.end(), {"--jobs", "2"});
  const Finished two = artu(with);
  EXPECT_EQ(one.code, 1);
  EXPECT_EQ(two.code, 1);
  const std::string mismatch = one.out.substr(one.out.find("check: mismatch"));
  EXPECT_THAT(mismatch, HasSubstr("first at frame 0"));
  EXPECT_THAT(two.out, HasSubstr(mismatch));
}

TEST_F(JobsTest, ASequenceWithRefittedTreesIsTheSame) {
  expect_same({"run", sample_, "--frames", "all", "--set", "tree_builder.refit=true"});
}

TEST_F(JobsTest, SweepsWriteTheSameFiles) {
  expect_same({"quality", "tiny.obj", "--size", "24x20", "--frames", "0:3", "--references", "4,16", "--pictures",
               "strip,animation"});
}

TEST_F(JobsTest, ScalingWritesTheSameFiles) {
  expect_same({"scaling", "tiny.obj", "--size", "24x20", "--frames", "0:3", "--vary", "core.count=1,2"});
}

TEST_F(JobsTest, PrecisionFindsTheSame) {
  const std::vector<std::string> precision{"precision", "tiny.obj", "--size", "24x20", "--frames",
                                           "0:2",       "--bits",   "9,12",   "-o"};
  for (const char* jobs : {"1", "3"}) {
    std::vector<std::string> args = precision;
    args.insert(args.end(), {jobs, "--jobs", jobs});
    fine(args);
  }
  ASSERT_EQ(content("1"), content("3"));
  const auto one = csv("1/precision.csv"), three = csv("3/precision.csv");
  ASSERT_EQ(one.size(), 13u);  // four trees with three formats
  const std::size_t run_time =
      static_cast<std::size_t>(std::find(one[0].begin(), one[0].end(), "run_time_ratio") - one[0].begin());
  ASSERT_LT(run_time, one[0].size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    for (std::size_t column = 0; column < one[0].size(); ++column) {
      if (column == run_time) continue;
      EXPECT_EQ(one[i].at(column), three.at(i).at(column)) << one[0][column];
    }
  }
  for (const std::string& name : content("1")) {
    if (name.find("_0") == std::string::npos) continue;  // no picture of a frame
    EXPECT_TRUE(read("1/" + name) == read("3/" + name)) << name;
  }
}

TEST_F(JobsTest, AnErrorIsTheSameAndLeavesNothing) {
  // Frame 0 waits for an answer that never comes.
  const std::vector<std::string> run{"run",
                                     "tiny.obj",
                                     "--size",
                                     "16x16",
                                     "--frames",
                                     "0:4",
                                     "--inject-fault",
                                     "dram:0",
                                     "--set",
                                     "unit.watchdog=10000",
                                     "-o",
                                     "out"};
  const Finished one = artu(run);
  std::vector<std::string> with = run;
  with.insert(with.end(), {"--jobs", "2"});
  const Finished two = artu(with);
  EXPECT_EQ(one.code, 3);
  EXPECT_EQ(two.code, 3);
  EXPECT_EQ(one.err, two.err);
  EXPECT_THAT(content(), ::testing::ElementsAre("tiny.obj"));
}

TEST_F(JobsTest, WhatCannotBeSharedOutIsRefused) {
  EXPECT_THAT(refused({"run", "tiny.obj", "--jobs", "2", "--memory-trace", "m.txt"}),
              HasSubstr("without --jobs would be right"));
  EXPECT_THAT(refused({"run", "tiny.obj", "--jobs", "2", "--log", "*=info"}),
              HasSubstr("without --jobs would be right"));
  EXPECT_THAT(refused({"run", "tiny.obj", "--jobs", "0"}), HasSubstr("--jobs"));
  EXPECT_THAT(content(), ::testing::ElementsAre("tiny.obj"));
}

TEST_F(JobsTest, AWorkerThatIsKilledIsOneLine) {
  if (!knows_children()) GTEST_SKIP() << "skipped: this kernel does not list a process's children";
  Running run = start_endless();
  const std::vector<pid_t> workers = workers_of(run.pid());
  ASSERT_EQ(workers.size(), 2u);
  kill(workers[1], SIGKILL);
  EXPECT_EQ(run.wait(), 2);
  EXPECT_EQ(read("err"),
            "error: --jobs: one of the processes was killed, as happens when memory runs out; fewer jobs or a smaller "
            "scene would be right\n");
  EXPECT_THAT(content(), ::testing::ElementsAre("err", "tiny.obj"));
}

TEST_F(JobsTest, AnInterruptionEndsAllProcesses) {
  if (!knows_children()) GTEST_SKIP() << "skipped: this kernel does not list a process's children";
  for (const int signal : {SIGINT, SIGTERM}) {
    Running run = start_endless();
    const std::vector<pid_t> workers = workers_of(run.pid());
    run.send(signal);
    EXPECT_EQ(run.wait(), 128 + signal);
    for (const pid_t worker : workers) EXPECT_NE(kill(worker, 0), 0) << "still there";  // it was waited for
    EXPECT_EQ(read("err"), "");
    EXPECT_THAT(content(), ::testing::ElementsAre("err", "tiny.obj"));
  }
}

}  // namespace
}  // namespace artu::test
