// Scenes of many triangles and pictures of many pixels: what they take of the host's memory.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

class LargeTest : public ProgramTest {
 protected:
  /// The `simulation` part of a run's stats.json.
  nlohmann::json simulation(std::vector<std::string> args) const {
    args.insert(args.begin(), "run");
    args.insert(args.end(), {"-o", "out", "--force", "--quiet"});
    fine(args);
    const auto stats = nlohmann::json::parse(read("out/stats.json"));
    triangles_ = stats.at("totals").at("triangles").at("static");
    return stats.at("simulation");
  }
  mutable std::uint64_t triangles_ = 0;
};

TEST_F(LargeTest, TenMillionTrianglesFitIntoEightGibibytes) {
  const Finished made =
      program("/usr/bin/env", {"python3", "-B", ARTU_SOURCE_DIR "/scripts/make_large.py", "large.gltf", "300000"});
  ASSERT_EQ(made.code, 0) << made.err;
  for (const char* kind : {"bvh2", "kd"}) {
    const auto use = simulation({"large.gltf", "--size", "48x32", "--set", std::string("accel.static.kind=") + kind});
    EXPECT_EQ(triangles_, 301056u);
    const double bytes = use.at("bytes_per_triangle");
    EXPECT_GT(bytes, 150) << kind;  // the records alone are 128
    EXPECT_LT(bytes, 600) << kind;  // 10^7 of them are 6 GB
  }
}

TEST_F(LargeTest, APictureOf3840x2160FitsIntoEightGibibytes) {
  write_scene("tiny.obj");
  const auto use = simulation({"tiny.obj", "--size", "960x540", "--check", "--pictures", "all"});
  EXPECT_GT(use.at("bytes_per_pixel").get<double>(), 32);   // a record is that much
  EXPECT_LT(use.at("bytes_per_pixel").get<double>(), 400);  // of 3840x2160: 3.3 GB
}

}  // namespace
}  // namespace artu::test
