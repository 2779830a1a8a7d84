// Scenes made by others: what each is known to hold.  They are not part of the repository.
#include <filesystem>

#include "unit/sim/import_fixture.h"

namespace artu::sim::test {
namespace {

struct Known {
  const char* file;
  std::size_t triangles, moving;
};

/// Or the test's name in a listing would be the struct's bytes.
void PrintTo(const Known& known, std::ostream* out) { *out << known.file; }

class RealScene : public ::testing::TestWithParam<Known> {};

TEST_P(RealScene, HasItsTrianglesAndMovesThem) {
  const std::string folder = ARTU_SOURCE_DIR "/../shared/scenes";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "skipped: no shared scenes";
  std::vector<std::string> log;
  const auto source = SceneSource::open(folder + "/" + GetParam().file, {}, log);
  const traces::Frame first = source->frame(0);
  EXPECT_EQ(source->scene().static_geometry.triangle_count() + first.dynamic.triangle_count(), GetParam().triangles);
  EXPECT_EQ(first.dynamic.triangle_count(), GetParam().moving);
  const std::uint32_t frames = source->natural_frame_count();
  EXPECT_EQ(frames > 1, GetParam().moving > 0);
  bool moved = false;
  for (std::uint32_t f = 1; f < frames && f < 60; f += 7) moved = moved || source->frame(f).dynamic_moved;
  EXPECT_EQ(moved, GetParam().moving > 0);
}

INSTANTIATE_TEST_SUITE_P(
    , RealScene,
    ::testing::Values(Known{"dream-apartment.glb", 177934, 0}, Known{"japanese-bridge-garden.glb", 21883, 0},
                      Known{"ToyCar.glb", 108936, 0}, Known{"FlightHelmet.glb", 94722, 0},
                      Known{"TransmissionTest.glb", 128775, 0}, Known{"MetalRoughSpheresNoTextures.glb", 1040409, 0},
                      Known{"cornellBox.glb", 16732, 0}, Known{"Streets_all.glb", 12558, 0},
                      Known{"PrimaryIonDrive.glb", 52072, 52072}, Known{"IridescentDishWithOlives.glb", 24448, 3584},
                      Known{"RecursiveSkeletons.glb", 6384, 6384}, Known{"Tank4.glb", 11402, 10806},
                      Known{"George.glb", 7864, 7864}, Known{"Knight.glb", 6952, 6952},
                      Known{"CesiumMan.glb", 4672, 4672}, Known{"CesiumMilkTruck.glb", 3624, 1536},
                      Known{"Fox.glb", 576, 576}, Known{"MorphStressTest.glb", 2412, 2412},
                      Known{"AnimatedMorphSphere.glb", 960, 960}, Known{"AnimatedMorphCube.glb", 12, 12},
                      Known{"BoxAnimated.glb", 254, 62}, Known{"InterpolationTest.glb", 110, 108}),
    [](const auto& info) {
      std::string name = info.param.file;
      name.resize(name.size() - 4);
      for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
      return name;
    });

TEST(DefaultStage, HoldsTheModelsOfTwoPackages) {
  for (const char* needed : {"/usr/share/glmark2/models/bunny.obj", "/usr/share/assimp/models/glTF2"}) {
    if (!std::filesystem::exists(needed)) GTEST_SKIP() << "skipped: no " << needed;
  }
  std::vector<std::string> log;
  const auto source = SceneSource::open(ARTU_SOURCE_DIR "/scripts/scenes/default.stage.toml", {}, log);
  EXPECT_EQ(source->natural_frame_count(), 300u);
  EXPECT_EQ(source->scene().static_geometry.triangle_count(), 2u + 69666 + 12 + 121496);
  const traces::Frame frame = source->frame(10);
  EXPECT_EQ(frame.dynamic.triangle_count(), 12u + 12 + 3 * 8 + 32 * 20 * 2 - 64) << "box, cube, banners, ball";
  EXPECT_TRUE(frame.dynamic_moved);
  EXPECT_EQ(frame.lights.size(), 2u);
}

}  // namespace
}  // namespace artu::sim::test
