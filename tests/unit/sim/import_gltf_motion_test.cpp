#include <cmath>

#include "unit/sim/import_fixture.h"

namespace artu::sim::test {
namespace {

using ::testing::HasSubstr;
using Floats = std::vector<float>;

/// Frames are seconds here, unless a test says otherwise.
class GltfMotion : public ImportTest {
 protected:
  GltfMotion() { options.fps = 4; }
  /// First corner of the dynamic geometry at a time in quarters of a second.
  std::vector<float> at(std::uint32_t quarter) { return xyz(source->frame(quarter).dynamic.positions.at(0)); }
  void moving_triangle(const char* path, const Floats& times, int values, const char* interpolation) {
    g.triangle();
    g.add("nodes", {{"mesh", 0}});
    g.animate(0, path, g.scalars(times), values, interpolation);
    open(g);
  }
  Gltf g;
};

TEST_F(GltfMotion, StepHoldsEachKey) {
  moving_triangle("translation", {0, 1, 2}, g.vec3({1, 0, 0, 2, 0, 0, 3, 0, 0}), "STEP");
  EXPECT_THAT(at(0), near({1, 0, 0}));
  EXPECT_THAT(at(3), near({1, 0, 0}));
  EXPECT_THAT(at(4), near({2, 0, 0}));
  EXPECT_THAT(at(7), near({2, 0, 0}));
}

TEST_F(GltfMotion, LinearRunsEvenlyAndLoops) {
  moving_triangle("translation", {0, 1, 2}, g.vec3({0, 0, 0, 4, 0, 0, 4, 8, 0}), "LINEAR");
  EXPECT_EQ(source->natural_frame_count(), 8u);
  EXPECT_THAT(at(1), near({1, 0, 0}));
  EXPECT_THAT(at(6), near({4, 4, 0}));
  EXPECT_THAT(at(9), near({1, 0, 0})) << "time is modulo the clip's 2 seconds";
}

TEST_F(GltfMotion, BeforeTheFirstKeyItIsHeld) {
  moving_triangle("translation", {1, 2}, g.vec3({5, 0, 0, 7, 0, 0}), "LINEAR");
  EXPECT_THAT(at(0), near({5, 0, 0}));
  EXPECT_THAT(at(6), near({6, 0, 0}));
}

TEST_F(GltfMotion, RotationsTakeTheShortWay) {
  const float s = std::sqrt(0.5f);
  // To -90 degrees about z, written as the opposite quaternion.
  g.mesh({{"POSITION", g.vec3({1, 0, 0, 2, 0, 0, 1, 1, 0})}});
  g.add("nodes", {{"mesh", 0}});
  g.animate(0, "rotation", g.scalars({0, 1}), g.vec4({0, 0, 0, 1, 0, 0, s, -s}));
  open(g);
  const float half = std::cos(M_PI / 4);
  EXPECT_THAT(at(2), near({half, -half, 0}));
  EXPECT_THAT(at(1), near({std::cos(static_cast<float>(M_PI) / 8), -std::sin(static_cast<float>(M_PI) / 8), 0}));
}

TEST_F(GltfMotion, CubicSplineUsesItsTangents) {
  // in-tangent, value, out-tangent a key; 2 seconds between the keys.
  moving_triangle("translation", {0, 2}, g.vec3({0, 0, 0, 0, 0, 0, 3, 0, 0, 1, 0, 0, 2, 0, 0, 0, 0, 0}), "CUBICSPLINE");
  // s = 1/4: h10 = s^3 - 2 s^2 + s = 0.140625, h01 = 3 s^2 - 2 s^3 = 0.15625, h11 = s^3 - s^2 = -0.046875
  EXPECT_THAT(at(2), near({2 * 3 * 0.140625f + 2 * 0.15625f + 2 * 1 * -0.046875f, 0, 0}));
}

TEST_F(GltfMotion, ScaleIsAnimated) {
  g.mesh({{"POSITION", g.vec3({1, 1, 1, 2, 1, 1, 1, 2, 1})}});
  g.add("nodes", {{"mesh", 0}, {"translation", {1, 0, 0}}});
  g.animate(0, "scale", g.scalars({0, 1}), g.vec3({1, 1, 1, 3, 1, 1}));
  open(g);
  EXPECT_THAT(at(2), near({3, 1, 1}));
}

TEST_F(GltfMotion, TwoJointsShareAVertex) {
  // Vertex 0 hangs on joint 0, vertex 1 on joint 1, vertex 2 half on each, with weights that do not sum to 1.
  const int joints = g.joints({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0});
  const int weights = g.vec4({1, 0, 0, 0, 0, 1, 0, 0, 2, 2, 0, 0});
  const Floats identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  Floats binds = identity;
  binds.insert(binds.end(), identity.begin(), identity.end());
  binds[16 + 13] = -1;  // joint 1 is bound at y = 1
  g.mesh({{"POSITION", g.vec3({0, 0, 0, 0, 2, 0, 1, 2, 0})}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}});
  g.j["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", g.mat4(binds)}}};
  g.j["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {100, 0, 0}}},  // its own place does not count
                  {{"children", {2}}},
                  {{"translation", {0, 1, 0}}}};
  g.j["scenes"] = {{{"nodes", {0, 1}}}};
  const float s = std::sqrt(0.5f);
  g.animate(2, "rotation", g.scalars({0, 1}), g.vec4({0, 0, s, s, 0, 0, 0, 1}));
  open(g);
  // At 0 joint 1 is turned by 90 degrees about z at y = 1: (0, 2) goes to (-1, 1), (1, 2) to (-1, 2).
  EXPECT_THAT(corners(source->frame(0).dynamic), near({0, 0, 0, -1, 1, 0, 0, 2, 0}));
  EXPECT_EQ(source->scene().static_geometry.triangle_count(), 0u);
}

TEST_F(GltfMotion, MorphTargetsAddUp) {
  const int base = g.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const Json targets = {{{"POSITION", g.vec3({1, 0, 0, 1, 0, 0, 1, 0, 0})}},
                        {{"POSITION", g.vec3({0, 2, 0, 0, 0, 0, 0, 0, 0})}}};
  g.mesh({{"POSITION", base}}, {{"targets", targets}});
  g.j["meshes"][0]["weights"] = {0.5, 0.25};
  g.add("nodes", {{"mesh", 0}});
  EXPECT_THAT(corners(open(g).scene().static_geometry), near({0.5, 0.5, 0, 1.5, 0, 0, 0.5, 1, 0}));
  g.animate(0, "weights", g.scalars({0, 1}), g.scalars({0, 0, 1, 3}));
  EXPECT_THAT(corners(open(g).frame(2).dynamic), near({0.5, 3, 0, 1.5, 0, 0, 0.5, 1, 0}));
}

TEST_F(GltfMotion, MorphTargetsMoveNormals) {
  const int n = g.vec3({0, 0, 1, 0, 0, 1, 0, 0, 1}), to_x = g.vec3({1, 0, -1, 1, 0, -1, 1, 0, -1});
  g.mesh({{"POSITION", g.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0})}, {"NORMAL", n}}, {{"targets", {{{"NORMAL", to_x}}}}});
  g.add("nodes", {{"mesh", 0}, {"weights", {1}}});
  EXPECT_THAT(xyz(open(g).scene().static_geometry.normals[0]), near({1, 0, 0}));
}

TEST_F(GltfMotion, OnlyWhatCanMoveIsDynamic) {
  g.triangle();
  g.j["nodes"] = {{{"children", {1, 2, 4}}},
                  {{"mesh", 0}},        // static
                  {{"children", {3}}},  // animated: its child moves
                  {{"mesh", 0}},        //
                  {{"mesh", 0}}};       // animated, but all keys are alike
  const int times = g.scalars({0, 1});
  g.animate(2, "translation", times, g.vec3({0, 0, 0, 1, 0, 0}));
  g.animate(4, "translation", times, g.vec3({5, 0, 0, 5, 0, 0}));
  open(g);
  EXPECT_EQ(source->scene().static_geometry.triangle_count(), 2u);
  EXPECT_EQ(source->frame(0).dynamic.triangle_count(), 1u);
  EXPECT_THAT(corners(source->scene().static_geometry), near({0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0}));
}

TEST_F(GltfMotion, ASkinIsStaticWhereItsJointsAre) {
  g.mesh({{"POSITION", g.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0})},
          {"JOINTS_0", g.joints(std::vector<std::uint8_t>(12, 0))},
          {"WEIGHTS_0", g.vec4({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0})}});
  g.j["skins"] = {{{"joints", {1}}}};
  g.j["nodes"] = {{{"mesh", 0}, {"skin", 0}}, Json::object()};
  g.animate(0, "translation", g.scalars({0, 1}), g.vec3({0, 0, 0, 1, 0, 0}));
  EXPECT_EQ(open(g).scene().static_geometry.triangle_count(), 1u) << "the mesh's own node does not move it";
}

TEST_F(GltfMotion, MovedComparesWithTheFrameBefore) {
  moving_triangle("translation", {0, 1, 2}, g.vec3({0, 0, 0, 0, 0, 0, 4, 0, 0}), "LINEAR");
  EXPECT_TRUE(source->frame(0).dynamic_moved);
  EXPECT_FALSE(source->frame(3).dynamic_moved);
  EXPECT_FALSE(source->frame(4).dynamic_moved);
  EXPECT_TRUE(source->frame(5).dynamic_moved);
  EXPECT_TRUE(source->frame(8).dynamic_moved) << "back at the start";
  EXPECT_EQ(source->frame(5).index, 5u);
  EXPECT_EQ(source->frame(5).time, 1.25);
}

TEST_F(GltfMotion, TheFirstClipPlaysAndThoseThatMoveOtherNodes) {
  g.triangle();
  g.j["nodes"] = {{{"mesh", 0}, {"children", {1}}}, {{"mesh", 0}}};
  const int times = g.scalars({0, 1}), values = g.vec3({0, 0, 0, 1, 0, 0});
  const auto clip = [&](const char* name, int node) {
    g.add("animations", {{"name", name},
                         {"samplers", {{{"input", times}, {"output", values}}}},
                         {"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", "translation"}}}}}}});
  };
  clip("walk", 0);
  clip("run", 0);
  open(g);
  EXPECT_THAT(log, ::testing::Contains(HasSubstr("has 2 clips; the first, \"walk\", plays")));
  clip("wave", 1);
  open(g);
  EXPECT_THAT(log, ::testing::Contains(HasSubstr("has 3 clips; 2 that move different nodes play together")));
  EXPECT_THAT(corners(source->frame(2).dynamic), near({0.5, 0, 0, 1.5, 0, 0, 0.5, 1, 0, 1, 0, 0, 2, 0, 0, 1, 1, 0}));
}

TEST_F(GltfMotion, ClipsThatPlayTogetherStartAgainTogether) {
  g.triangle();
  g.j["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}}};
  g.j["scenes"] = {{{"nodes", {0, 1}}}};
  for (const int node : {0, 1}) {
    const int times = g.scalars({0, node ? 2.0f : 1.0f}), values = g.vec3({0, 0, 0, 4, 0, 0});
    g.add("animations", {{"samplers", {{{"input", times}, {"output", values}}}},
                         {"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", "translation"}}}}}}});
  }
  EXPECT_EQ(open(g).natural_frame_count(), 8u);
  EXPECT_THAT(at(6), near({4, 0, 0})) << "the shorter clip waits for the longer one";
  EXPECT_THAT(at(9), near({1, 0, 0}));
}

}  // namespace
}  // namespace artu::sim::test
