#include <cmath>

#include "sim/import/stage_toml.h"
#include "unit/sim/import_fixture.h"

namespace artu::sim::test {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;

class Stage : public ImportTest {
 protected:
  Stage() {
    options.fps = 4;
    Gltf g;
    g.triangle();
    g.j["nodes"] = {{{"name", "still"}, {"mesh", 0}}, {{"name", "mover"}, {"mesh", 0}}};
    g.j["scenes"] = {{{"nodes", {0, 1}}}};
    g.j["materials"] = {{{"name", "paint"}}};
    const int times = g.scalars({0, 2}), values = g.vec3({0, 0, 0, 8, 0, 0});
    for (const char* name : {"walk", "jump"}) {
      g.add("animations",
            {{"name", name},
             {"samplers", {{{"input", times}, {"output", values}}}},
             {"channels",
              {{{"sampler", 0}, {"target", {{"node", 1}, {"path", name[0] == 'w' ? "translation" : "scale"}}}}}}});
    }
    folder.write("model.gltf", g.text());
  }
  SceneSource& stage(const std::string& text) { return open(folder.write("a.stage.toml", text)); }
  std::string error(const std::string& text) { return error_of(folder.write("a.stage.toml", text)); }
};

const std::string one = "[[file]]\npath = \"model.gltf\"\n";

TEST_F(Stage, FilesAreComposedAndPlaced) {
  stage(one + "clip = -1\nposition = [1, 0, 0]\n" + one + "clip = -1\nscale = 2\nrotation = [0, 0, 90]\n");
  const auto& mesh = source->scene().static_geometry;
  EXPECT_EQ(mesh.triangle_count(), 4u);
  const auto c = corners(mesh);
  EXPECT_THAT(std::vector<float>(c.begin(), c.begin() + 9), near({1, 0, 0, 2, 0, 0, 1, 1, 0}));
  EXPECT_THAT(std::vector<float>(c.begin() + 18, c.begin() + 27), near({0, 0, 0, 0, 2, 0, -2, 0, 0}));
}

TEST_F(Stage, RotationIsAboutXThenYThenZ) {
  stage(one + "clip = -1\nrotation = [90, 0, 90]\n");
  // (0, 1, 0) goes to (0, 0, 1) about x, and stays there about z.
  const auto c = corners(source->scene().static_geometry);
  EXPECT_THAT(std::vector<float>(c.begin(), c.begin() + 9), near({0, 0, 0, 0, 1, 0, 0, 0, 1}));
}

TEST_F(Stage, ClipsHaveSpeedStartAndLoop) {
  const auto mover = [&](std::uint32_t quarter) { return source->frame(quarter).dynamic.positions.at(0).x; };
  stage(one + "clip = \"walk\"\nspeed = 2\nstart = 0.5\n");
  EXPECT_NEAR(mover(0), 2, 1e-5);
  EXPECT_NEAR(mover(1), 4, 1e-5);
  EXPECT_NEAR(mover(3), 0, 1e-5) << "looped at 2 seconds of clip time";
  EXPECT_EQ(source->natural_frame_count(), 4u);
  stage(one + "clip = 0\nloop = false\n");
  EXPECT_NEAR(mover(100), 8, 1e-5);
}

TEST_F(Stage, KeysMoveAFile) {
  stage(one +
        "clip = -1\n[[file.key]]\ntime = 0\nposition = [0, 0, 0]\n[[file.key]]\ntime = 1\nposition = [0, 4, 0]\n");
  EXPECT_EQ(source->scene().static_geometry.triangle_count(), 0u);
  EXPECT_THAT(xyz(source->frame(1).dynamic.positions[0]), near({0, 1, 0}));
  EXPECT_THAT(xyz(source->frame(5).dynamic.positions[0]), near({0, 1, 0}));
}

TEST_F(Stage, KeyedAnglesRunThroughFullTurns) {
  stage(one +
        "clip = -1\n[[file.key]]\ntime = 0\nrotation = [0, 0, 0]\n[[file.key]]\ntime = 2\nrotation = [0, 0, 360]\n");
  EXPECT_THAT(xyz(source->frame(2).dynamic.positions[1]), near({0, 1, 0}));
  EXPECT_THAT(xyz(source->frame(4).dynamic.positions[1]), near({-1, 0, 0}));
  EXPECT_THAT(xyz(source->frame(1).dynamic.positions[1]), near({std::sqrt(0.5f), std::sqrt(0.5f), 0}));
}

TEST_F(Stage, MotionThatIsNotLoopedStaysAtItsEnd) {
  stage(one +
        "clip = -1\nmotion_loop = false\n[[file.key]]\ntime = 0\nposition = [0, 0, 0]\n[[file.key]]\ntime = 1\n"
        "position = [0, 4, 0]\n");
  EXPECT_THAT(xyz(source->frame(50).dynamic.positions[0]), near({0, 4, 0}));
}

TEST_F(Stage, NodesCanBeMoved) {
  stage(one +
        "clip = -1\n[[file.node]]\nname = \"still\"\nposition = [3, 0, 0]\n[[file.node.key]]\ntime = 0\n"
        "[[file.node.key]]\ntime = 2\nscale = 3\n");
  EXPECT_EQ(source->scene().static_geometry.triangle_count(), 1u);
  EXPECT_THAT(corners(source->frame(4).dynamic), near({3, 0, 0, 5, 0, 0, 3, 2, 0}));
}

TEST_F(Stage, StaticAndDynamicCanBeForced) {
  stage(one + "static = [\"mover\"]\ndynamic = \"still\"\n");
  EXPECT_EQ(source->scene().static_geometry.triangle_count(), 1u);
  EXPECT_THAT(corners(source->frame(4).dynamic), near({0, 0, 0, 1, 0, 0, 0, 1, 0}));
  stage(one + "dynamic = \"*\"\n");
  EXPECT_EQ(source->scene().static_geometry.triangle_count(), 0u);
}

TEST_F(Stage, CameraLightsAndSky) {
  options.width = options.height = 100;
  stage(one +
        "[camera]\nfov = 90\nposition = [0, 0, 5]\ntarget = [0, 0, 0]\n"
        "[[light]]\nkind = \"spot\"\nposition = [0, 5, 0]\ndirection = [0, -2, 0]\nintensity = 3\ncolor = [1, 0.5, 0]\n"
        "inner = 30\nouter = 60\nrange = 7\n[sky]\nzenith = [0, 0, 1]\nnadir = 0.5\nambient = [0.1, 0.2, 0.3]\n");
  const auto frame = source->frame(0);
  EXPECT_THAT(xyz(frame.camera.origin), near({0, 0, 5}));
  EXPECT_THAT(xyz(frame.camera.corner), near({-1, 1, -1}));
  ASSERT_EQ(frame.lights.size(), 1u);
  EXPECT_THAT(xyz(frame.lights[0].direction), near({0, -1, 0}));
  EXPECT_THAT(xyz(frame.lights[0].color), near({3, 1.5, 0}));
  EXPECT_NEAR(frame.lights[0].cos_outer, 0.5, 1e-6);
  EXPECT_EQ(frame.lights[0].range, 7);
  EXPECT_THAT(xyz(frame.sky_zenith), near({0, 0, 1}));
  EXPECT_THAT(xyz(frame.sky_nadir), near({0.5, 0.5, 0.5}));
  EXPECT_THAT(xyz(frame.ambient), near({0.1, 0.2, 0.3}));
}

TEST_F(Stage, CamerasPassThroughTheirKeys) {
  stage(one +
        "[camera]\ntarget = [0, 0, 0]\n[[camera.key]]\ntime = 0\nposition = [0, 0, 5]\n[[camera.key]]\ntime = 1\n"
        "position = [5, 0, 0]\n[[camera.key]]\ntime = 2\nposition = [0, 0, 5]\n");
  EXPECT_THAT(xyz(source->frame(0).camera.origin), near({0, 0, 5}));
  EXPECT_THAT(xyz(source->frame(4).camera.origin), near({5, 0, 0}));
  EXPECT_THAT(xyz(source->frame(8).camera.origin), near({0, 0, 5}));
}

TEST_F(Stage, MaterialsCanBeChangedInOneCopyOnly) {
  stage(one + "[[file.material]]\nname = \"paint\"\nmirror = 0.5\ndiffuse = [0.1, 0.2, 0.3]\nior = 1.2\n" + one);
  const auto& materials = source->scene().materials;
  ASSERT_EQ(materials.size(), 4u);
  EXPECT_THAT(xyz(materials[0].mirror), near({0.5, 0.5, 0.5}));
  EXPECT_THAT(xyz(materials[0].diffuse), near({0.1, 0.2, 0.3}));
  EXPECT_THAT(xyz(materials[2].diffuse), ::testing::Not(near({0.1, 0.2, 0.3})));
}

TEST_F(Stage, TheFirstCandidateThatExistsIsRead) {
  stage("[[file]]\npath = [\"absent.glb\", \"/absent/too.glb\", \"model.gltf\"]\n");
  EXPECT_EQ(source->scene().static_geometry.triangle_count(), 1u);
}

TEST_F(Stage, DurationSaysHowLong) { EXPECT_EQ(stage("duration = 10\n" + one).natural_frame_count(), 40u); }

TEST_F(Stage, UnknownKeysHaveALineAndASuggestion) {
  EXPECT_THAT(error(one + "positon = [0, 0, 0]\n"),
              EndsWith("a.stage.toml:3: unknown key \"positon\" in [[file]], did you mean \"position\"?"));
  EXPECT_THAT(error(one + "[camera]\nzzzzzzzzz = 1\n"),
              HasSubstr("a.stage.toml:4: unknown key \"zzzzzzzzz\" in [camera]; there are: fov"));
  EXPECT_THAT(error("fil = 3\n"),
              HasSubstr("a.stage.toml:1: unknown key \"fil\" in the stage, did you mean \"file\"?"));
}

TEST_F(Stage, MissingFilesHaveALine) {
  EXPECT_THAT(error("\n[[file]]\npath = \"none.glb\"\n"),
              AllOf(HasSubstr("a.stage.toml:3: [[file]]: no such file: "), HasSubstr("none.glb")));
  EXPECT_THAT(error("[[file]]\nscale = 1\n"), HasSubstr("a.stage.toml:1: [[file]]: path is missing"));
  EXPECT_THAT(error("duration = 1\n"), HasSubstr("needs at least one [[file]]"));
}

TEST_F(Stage, WrongTypesAndValuesHaveALine) {
  EXPECT_THAT(error("[[file]\n"), HasSubstr("a.stage.toml:1: "));
  EXPECT_THAT(error(one + "position = [0, 1]\n"),
              HasSubstr("a.stage.toml:3: [[file]]: position must be an array of three numbers"));
  EXPECT_THAT(error(one + "speed = \"fast\"\n"), HasSubstr("speed must be a finite number"));
  EXPECT_THAT(error(one + "speed = nan\n"), HasSubstr("speed must be a finite number"));
  EXPECT_THAT(error(one + "[camera]\nfov = 200\nposition = [0,0,1]\n"),
              HasSubstr("a.stage.toml:4: [camera]: fov is 200; 1 ... 170 is allowed"));
  EXPECT_THAT(error(one + "[camera]\nfov = 20\n"),
              HasSubstr("a.stage.toml:3: [camera]: position = [x, y, z] is missing"));
  EXPECT_THAT(error(one + "[[light]]\nkind = \"pont\"\n"),
              HasSubstr("\"pont\" is not a kind of light, did you mean \"point\"?"));
  EXPECT_THAT(error(one + "[[light]]\ndirection = [0,-1,0]\ncolor = [-1,0,0]\n"),
              HasSubstr("color must not be negative"));
  EXPECT_THAT(error(one + "[sky]\nzenith = \"blue\"\n"), HasSubstr("a.stage.toml:4: "));
}

TEST_F(Stage, CamerasThatSeeNowhereHaveALine) {
  EXPECT_THAT(error(one + "[camera]\nposition = [1, 2, 3]\ntarget = [1, 2, 3]\n"),
              HasSubstr("a.stage.toml:5: [camera]: target is the position; another point would be right"));
  EXPECT_THAT(error(one + "[camera]\nposition = [0, 0, 0]\n"),
              HasSubstr("a.stage.toml:4: [camera]: position is the target, [0, 0, 0] unless it is given"));
  EXPECT_THAT(error(one + "[camera]\nposition = [0, 0, 5]\nup = [0, 0, 0]\n"),
              HasSubstr("a.stage.toml:5: [camera]: up is zero; a direction such as [0, 1, 0] would be right"));
  EXPECT_THAT(error(one + "[camera]\nposition = [0, 0, 5]\nup = [0, 0, -2]\n"),
              HasSubstr("a.stage.toml:5: [camera]: up is along the view from position to target; a direction "
                        "across it, such as [0, 1, 0], would be right"));
  EXPECT_THAT(error(one + "[camera]\nposition = [0, 5, 0]\nup = [0, 1, 0]\n"), HasSubstr("such as [0, 0, 1], would"));
  // Straight down without an up: what is far away along -z is above.
  EXPECT_THAT(stage(one + "[camera]\nposition = [0, 5, 0]\n").frame(0).camera.dv.z, ::testing::Gt(0));
  EXPECT_THAT(error(one + "[camera]\n[[camera.key]]\ntime = 0\nposition = [0, 0, 5]\n[[camera.key]]\ntime = 1\n"
                          "target = [0, 0, 5]\n"),
              HasSubstr("a.stage.toml:9: [[key]]: target is the position"));
}

TEST_F(Stage, ADurationOfNothingIsRefused) {
  EXPECT_THAT(error("duration = 0\n" + one),
              HasSubstr("a.stage.toml:1: the stage: duration is 0; 1e-06 ... 1e+09 is allowed"));
}

TEST_F(Stage, NamesThatDoNotExistAreSuggested) {
  EXPECT_THAT(error(one + "clip = \"wlak\"\n"),
              HasSubstr("a.stage.toml:3: [[file]]: clip \"wlak\" is not a clip of this file, did you mean \"walk\"?"));
  EXPECT_THAT(error(one + "clip = 7\n"), HasSubstr("clip is 7; the file has 2 clips"));
  EXPECT_THAT(error(one + "static = [\"stil\"]\n"),
              HasSubstr("\"stil\" is not a node of this file, did you mean \"still\"?"));
  EXPECT_THAT(error(one + "[[file.node]]\nname = \"moved\"\n"), HasSubstr("did you mean \"mover\"?"));
  EXPECT_THAT(error(one + "[[file.material]]\nname = \"pain\"\n"), HasSubstr("did you mean \"paint\"?"));
}

TEST_F(Stage, WhatHasNoNamesIsCounted) {
  EXPECT_THAT(suggest("walk", {}), EndsWith("; there are none"));
  EXPECT_THAT(suggest("walk", {"", ""}), EndsWith("; it has 2, and none has a name"));
  EXPECT_THAT(suggest("walk", {"", "jump"}), EndsWith("; there are: jump"));
  EXPECT_THAT(suggest("foo", {"box"}), EndsWith("; there are: box"));
  Gltf g;
  g.triangle();
  g.j["nodes"] = {{{"mesh", 0}}};
  g.j["scenes"] = {{{"nodes", {0}}}};
  const int times = g.scalars({0, 2}), values = g.vec3({0, 0, 0, 8, 0, 0});
  for (int i = 0; i < 2; ++i) {
    g.add("animations", {{"samplers", {{{"input", times}, {"output", values}}}},
                         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}});
  }
  folder.write("unnamed.gltf", g.text());
  EXPECT_THAT(error("[[file]]\npath = \"unnamed.gltf\"\nclip = \"walk\"\n"),
              EndsWith("clip \"walk\" is not a clip of this file; it has 2, and none has a name; a number, 0 ... 1, "
                       "would be right"));
}

TEST_F(Stage, KeysMustBeInOrder) {
  EXPECT_THAT(error(one + "[[file.key]]\ntime = 1\n[[file.key]]\ntime = 1\n"),
              HasSubstr("a.stage.toml:6: [[key]]: time must be later"));
  EXPECT_THAT(error(one + "[[file.key]]\nposition = [0,0,0]\n"),
              HasSubstr("a.stage.toml:3: [[key]]: time (seconds) is missing"));
}

TEST_F(Stage, AStageCannotHoldAStage) {
  EXPECT_THAT(error("[[file]]\npath = \"a.stage.toml\"\n"), HasSubstr("a stage cannot hold another"));
}

}  // namespace
}  // namespace artu::sim::test
