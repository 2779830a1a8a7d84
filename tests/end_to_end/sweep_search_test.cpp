// scripts/search: Optuna chooses the points of a sweep.
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using ::testing::HasSubstr;

class SweepSearchTest : public ProgramTest {
 protected:
  SweepSearchTest() {
    setenv("ARTU", ARTU_BINARY, 1);
    write_scene("tiny.obj");
    write("grid.toml",
          "scenes = [\"tiny.obj\"]\nsize = \"16x12\"\npictures = \"none\"\nobjectives = [\"cycles_per_frame\", "
          "\"memory.l2.size\"]\n[search]\nsamples = 18\nbatch = 6\nseed = 5\ncore.count = [1, 6]\n"
          "memory.l2.size = [\"16KiB\", \"1MiB\"]\naccel.static.kind = [\"bvh2\", \"bvh4\"]\n");
  }

  Finished search(const std::vector<std::string>& args) const {
    return program(std::string(ARTU_SOURCE_DIR) + "/scripts/search", args);
  }
  bool has_optuna() const { return search({}).err.find("no Optuna") == std::string::npos; }
};

TEST_F(SweepSearchTest, TheSameSeedGivesTheSamePointsHoweverItEnds) {
  if (!has_optuna()) GTEST_SKIP() << "skipped: no Optuna (python3-optuna)";
  const Finished whole = search({"grid.toml", "-o", "whole"});
  ASSERT_EQ(whole.code, 0) << whole.err;
  EXPECT_THAT(whole.out, HasSubstr("not dominated by another point"));
  const auto rows = csv("whole/points.csv");
  EXPECT_GT(rows.size(), 12u);
  EXPECT_LE(rows.size(), 19u);

  // Killed when the first batch is there, and begun again.
  const pid_t child = fork();
  if (child == 0) {
    setpgid(0, 0);
    if (chdir(path(".").c_str()) != 0 || !freopen("/dev/null", "w", stdout)) _exit(127);
    const std::string script = std::string(ARTU_SOURCE_DIR) + "/scripts/search";
    execl(script.c_str(), script.c_str(), "grid.toml", "-o", "killed", nullptr);
    _exit(127);
  }
  for (int i = 0; i < 6000 && !(exists("killed/points") && content("killed/points").size() >= 8); ++i) usleep(10'000);
  kill(-child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_LT(content("killed/points").size(), rows.size() - 1) << "it was done before it was killed";
  ASSERT_EQ(search({"grid.toml", "-o", "killed", "--jobs", "2"}).code, 0);
  for (const char* file : {"points.csv", "search.toml", "sweep.json"}) {
    EXPECT_TRUE(read(std::string("whole/") + file) == read(std::string("killed/") + file)) << file;
  }
  EXPECT_EQ(content("whole/points"), content("killed/points"));
}

TEST_F(SweepSearchTest, AGridWithoutASearchIsRefused) {
  if (!has_optuna()) GTEST_SKIP() << "skipped: no Optuna (python3-optuna)";
  write("other.toml", "scenes = [\"tiny.obj\"]\nsize = \"8x8\"\n[grid]\ncore.count = [1]\n");
  const Finished other = search({"other.toml", "-o", "out"});
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("has no [search]"));
  EXPECT_EQ(search({"none.toml", "-o", "none"}).code, 2);
}

}  // namespace
}  // namespace artu::test
