#include <cmath>

#include "unit/sim/import_fixture.h"

namespace artu::sim::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

class View : public ImportTest {
 protected:
  View() {
    options.width = 200;
    options.height = 100;
  }
  static std::vector<float> direction(const traces::Camera& c, float fx, float fy) {
    return {c.corner.x + c.du.x * fx + c.dv.x * fy, c.corner.y + c.du.y * fx + c.dv.y * fy,
            c.corner.z + c.du.z * fx + c.dv.z * fy};
  }
  static std::vector<float> origin(const traces::Camera& c, float fx, float fy) {
    return {c.origin.x + c.origin_du.x * fx + c.origin_dv.x * fy, c.origin.y + c.origin_du.y * fx + c.origin_dv.y * fy,
            c.origin.z + c.origin_du.z * fx + c.origin_dv.z * fy};
  }
  void light(const Json& light, const Json& node) {
    g.triangle();
    g.j["extensionsUsed"] = {"KHR_lights_punctual"};
    g.j["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({light});
    Json with = node;
    with["extensions"]["KHR_lights_punctual"]["light"] = 0;
    g.j["nodes"] = {with, {{"mesh", 0}}};
    g.j["scenes"] = {{{"nodes", {0, 1}}}};
    open(g);
  }
  Gltf g;
};

TEST_F(View, PerspectiveKeepsTheVerticalFieldOfView) {
  g.add("cameras",
        {{"type", "perspective"}, {"perspective", {{"yfov", M_PI / 2}, {"znear", 0.1}, {"aspectRatio", 5}}}});
  g.add("nodes", {{"camera", 0}, {"translation", {1, 2, 3}}});
  const auto c = open(g).frame(0).camera;
  EXPECT_THAT(origin(c, 0, 0), near({1, 2, 3}));
  EXPECT_THAT(direction(c, 0, 0), near({-2, 1, -1})) << "upper left corner of the picture";
  EXPECT_THAT(direction(c, 200, 100), near({2, -1, -1})) << "lower right";
  EXPECT_THAT(direction(c, 100, 50), near({0, 0, -1})) << "middle";
  EXPECT_THAT(direction(c, 0.5, 0.5), near({-1.99f, 0.99f, -1})) << "first pixel";
}

TEST_F(View, OrthographicMovesTheOrigin) {
  g.add("cameras",
        {{"type", "orthographic"}, {"orthographic", {{"xmag", 9}, {"ymag", 3}, {"znear", 0}, {"zfar", 10}}}});
  g.add("nodes", {{"camera", 0}});
  const auto c = open(g).frame(0).camera;
  EXPECT_THAT(origin(c, 0, 0), near({-6, 3, 0}));
  EXPECT_THAT(origin(c, 200, 100), near({6, -3, 0}));
  EXPECT_THAT(direction(c, 123, 45), near({0, 0, -1}));
}

TEST_F(View, CamerasFollowTheirNodesWithoutTheirScale) {
  g.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", M_PI / 2}, {"znear", 0.1}}}});
  const float s = std::sqrt(0.5f);
  g.j["nodes"] = {{{"children", {1}}, {"rotation", {0, s, 0, s}}, {"scale", {4, 4, 4}}}, {{"camera", 0}}};
  g.animate(0, "translation", g.scalars({0, 1}), g.vec3({0, 0, 0, 30, 0, 0}));
  EXPECT_THAT(direction(open(g).frame(15).camera, 100, 50), near({-1, 0, 0}));
  EXPECT_THAT(direction(source->frame(15).camera, 0, 0), near({-1, 1, 2}));
  EXPECT_THAT(origin(source->frame(15).camera, 0, 0), near({15, 0, 0}));
}

TEST_F(View, ASceneWithoutOneGetsACameraThatSeesAllAndStays) {
  g.mesh({{"POSITION", g.vec3({-1, -1, -1, 1, 1, 1, 1, -1, 1})}});
  g.add("nodes", {{"mesh", 0}});
  g.animate(0, "translation", g.scalars({0, 1}), g.vec3({0, 0, 0, 20, 0, 0}));
  const auto first = open(g).frame(0).camera;
  EXPECT_THAT(log, Contains(HasSubstr("has no camera")));
  for (const std::uint32_t f : {0u, 10u, 28u}) {
    const auto frame = source->frame(f);
    EXPECT_EQ(xyz(frame.camera.corner), xyz(first.corner));
    for (const auto& p : frame.dynamic.positions) {
      // Solve for the pixel: d = corner + du x + dv y up to a factor.
      const auto& c = frame.camera;
      const auto dot = [](const traces::Vec3& a, const traces::Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
      const traces::Vec3 to{p.x - c.origin.x, p.y - c.origin.y, p.z - c.origin.z};
      const auto middle = direction(c, 100, 50);
      const float depth = to.x * middle[0] + to.y * middle[1] + to.z * middle[2];
      ASSERT_GT(depth, 0);
      EXPECT_LT(std::abs(dot(to, c.du) / dot(c.du, c.du) / depth), 100);
      EXPECT_LT(std::abs(dot(to, c.dv) / dot(c.dv, c.dv) / depth), 50);
    }
  }
}

TEST_F(View, ASceneWithoutLightsGetsAKeyLight) {
  g.triangle();
  g.add("nodes", {{"mesh", 0}});
  EXPECT_GE(open(g).frame(0).lights.size(), 1u);
  EXPECT_GT(source->frame(0).ambient.x, 0);
  EXPECT_THAT(log, Contains(HasSubstr("has no light")));
}

TEST_F(View, DirectionalLightsShineAlongMinusZ) {
  const float s = std::sqrt(0.5f);
  light({{"type", "directional"}, {"color", {1, 0.5, 0.25}}, {"intensity", 50000}}, {{"rotation", {-s, 0, 0, s}}});
  const auto lights = source->frame(0).lights;
  ASSERT_EQ(lights.size(), 1u);
  EXPECT_EQ(lights[0].kind, traces::LightKind::directional);
  EXPECT_THAT(xyz(lights[0].direction), near({0, -1, 0}));
  EXPECT_THAT(xyz(lights[0].color), near({1, 0.5, 0.25})) << "50,000 lux are exposed to 1";
  EXPECT_THAT(log, Contains(HasSubstr("lights are scaled")));
}

TEST_F(View, PointLightsAreExposedByTheirDistance) {
  light({{"type", "point"}, {"intensity", 700}, {"range", 12}}, {{"translation", {0.5, 10.5, 0}}});
  const auto lights = source->frame(0).lights;
  ASSERT_EQ(lights.size(), 1u);
  EXPECT_EQ(lights[0].kind, traces::LightKind::point);
  EXPECT_THAT(xyz(lights[0].position), near({0.5, 10.5, 0}));
  EXPECT_NEAR(lights[0].color.x, 100, 1e-3) << "an irradiance of 1 at the box's centre, 10 away";
  EXPECT_EQ(lights[0].range, 12);
}

TEST_F(View, SpotLightsHaveTheirCone) {
  light({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}}}},
        {{"translation", {0, 0, 5}}});
  const auto lights = source->frame(0).lights;
  ASSERT_EQ(lights.size(), 1u);
  EXPECT_EQ(lights[0].kind, traces::LightKind::spot);
  EXPECT_NEAR(lights[0].cos_inner, std::cos(0.25), 1e-6);
  EXPECT_NEAR(lights[0].cos_outer, std::cos(0.5), 1e-6);
  EXPECT_THAT(xyz(lights[0].direction), near({0, 0, -1}));
}

}  // namespace
}  // namespace artu::sim::test
