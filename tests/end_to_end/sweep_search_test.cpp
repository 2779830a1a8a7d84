// scripts/search: Optuna chooses the points of a sweep.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
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

  Finished search(const std::vector<std::string>& args) const { return program(script_, args); }
  bool has_optuna() const { return search({"none.toml", "-o", "none"}).err.find("no Optuna") == std::string::npos; }

  const std::string script_ = ARTU_SOURCE_DIR "/scripts/search";
};

TEST_F(SweepSearchTest, TheSameSeedGivesTheSamePointsHoweverItEnds) {
  if (!has_optuna()) GTEST_SKIP() << "skipped: no Optuna (python3-optuna)";
  const Finished whole = search({"grid.toml", "-o", "whole"});
  ASSERT_EQ(whole.code, 0) << whole.err;
  EXPECT_THAT(whole.out, HasSubstr("not dominated by another point"));
  const auto rows = csv("whole/points.csv");
  EXPECT_GT(rows.size(), 12u);
  EXPECT_LE(rows.size(), 19u);

  // Killed when the second batch is to be simulated, by a program that waits until it is killed; then begun again.
  std::filesystem::create_symlink(ARTU_BINARY, path("artu"));
  write("artu-that-waits",
        "#!/bin/sh\n[ -n \"$(ls killed/points 2>/dev/null)\" ] || exec ./artu \"$@\"\n"
        "echo >waits\nexec sleep 100000\n");
  std::filesystem::permissions(path("artu-that-waits"), std::filesystem::perms::owner_all);
  setenv("ARTU", path("artu-that-waits").c_str(), 1);
  Running killed = start_program(script_, {"grid.toml", "-o", "killed"}, "killed.err");
  EXPECT_TRUE(killed.until([&] { return exists("waits"); })) << read("killed.err");
  kill_all();
  setenv("ARTU", ARTU_BINARY, 1);
  const std::size_t points = content("killed/points").size();
  EXPECT_GT(points, 0u);
  EXPECT_LT(points, rows.size() - 1);
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

TEST_F(SweepSearchTest, WordsThatAreOfNoSearchAreRefused) {
  const std::vector<std::string> refused[] = {{},
                                              {"grid.toml"},
                                              {"grid.toml", "-o"},
                                              {"-o", "out", "grid.toml"},
                                              {"grid.toml", "-o", "out", "--dry-run"},
                                              {"grid.toml", "-o", "out", "--part=0/2"}};
  for (const auto& words : refused) {
    const Finished run = search(words);
    EXPECT_EQ(run.code, 2) << run.err;
    EXPECT_THAT(run.err, ::testing::StartsWith("error: search: "));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
  EXPECT_FALSE(exists("out"));
}

}  // namespace
}  // namespace artu::test
