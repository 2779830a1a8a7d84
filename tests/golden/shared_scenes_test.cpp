// Real scenes beside the repository, small: rigid, skinned, morphing, mirrors and glass.
#include <filesystem>

#include "golden/harness.h"
#include "sim/import/import.h"

namespace artu::golden_tests {
namespace {

class SharedScene : public testing::TestWithParam<const char*> {};

TEST_P(SharedScene, IsExact) {
  const std::filesystem::path path = std::filesystem::path(ARTU_SOURCE_DIR) / ".." / "shared" / "scenes" / GetParam();
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "skipped: no shared scenes";
  sim::ImportOptions options;
  options.width = 161;
  options.height = 120;
  options.first_frame = 5;
  options.last_frame = 7;
  std::vector<std::string> log;
  const auto source = sim::SceneSource::open(path.string(), options, log);
  TestScene test;
  test.scene = source->scene();
  for (std::uint32_t i = 5; i < 7; ++i) test.frames.push_back(source->frame(i));
  expect_exact(run(test));
}

INSTANTIATE_TEST_SUITE_P(All, SharedScene,
                         testing::Values("dream-apartment.glb",           // static only
                                         "CesiumMilkTruck.glb",           // rigid wheels on a static body
                                         "CesiumMan.glb",                 // skinned, dynamic only
                                         "MorphStressTest.glb",           // morph targets
                                         "IridescentDishWithOlives.glb",  // glass and metal, moving
                                         "TransmissionTest.glb",          // glass
                                         "Knight.glb",                    // skinned and rigid
                                         "InterpolationTest.glb", "Fox.glb", "cornellBox.glb"));

}  // namespace
}  // namespace artu::golden_tests
