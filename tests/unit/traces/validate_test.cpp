// Each refusal of validate(), and its words.
#include "traces/validate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "traces/limits.h"
#include "unit/traces/support.h"

namespace artu::traces::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float limit = coordinate_limit;

struct Refusal {
  std::string name;
  std::function<void(Scene&, Frame&)> damage;
  std::string message;
};

class Validate : public testing::TestWithParam<Refusal> {};

TEST_P(Validate, Refuses) {
  Scene scene = sample_scene();
  Frame frame = sample_frame(0);
  GetParam().damage(scene, frame);
  const std::string message = message_of([&] {
    validate(scene, "here");
    validate(scene, frame, "here");
  });
  EXPECT_EQ(message, "here: " + GetParam().message);
}

using S = Scene;
using F = Frame;
const std::string coordinate = "; must be finite and below 2^62 in magnitude";
const std::string weight = "; must be finite, not negative and below 2^62";
const std::string text = "; must be UTF-8 text without control characters";

const Refusal scene_refusals[] = {
    {"NameControl", [](S& s, F&) { s.name = "a\nb"; }, "byte 1 of name is 10" + text},
    {"NameDelete", [](S& s, F&) { s.name = "\x7F"; }, "byte 0 of name is 127" + text},
    {"NameC1Control", [](S& s, F&) { s.name = "\xC2\x9B"; }, "byte 0 of name is 194" + text},
    {"NameLatin1", [](S& s, F&) { s.name = "caf\xE9"; }, "byte 3 of name is 233" + text},
    {"NameOverlong", [](S& s, F&) { s.name = "\xC0\xAF"; }, "byte 0 of name is 192" + text},
    {"NameOverlong3", [](S& s, F&) { s.name = "\xE0\x80\xAF"; }, "byte 0 of name is 224" + text},
    {"NameOverlong3Last", [](S& s, F&) { s.name = "\xE0\x9F\xBF"; }, "byte 0 of name is 224" + text},
    {"NameOverlong4Last", [](S& s, F&) { s.name = "\xF0\x8F\xBF\xBF"; }, "byte 0 of name is 240" + text},
    {"NameSurrogate", [](S& s, F&) { s.name = "\xED\xA0\x80"; }, "byte 0 of name is 237" + text},
    {"NameBeyond", [](S& s, F&) { s.name = "\xF4\x90\x80\x80"; }, "byte 0 of name is 244" + text},
    {"NameCut", [](S& s, F&) { s.name = "\xF0\x9F\x98"; }, "byte 0 of name is 240" + text},
    {"NameLong", [](S& s, F&) { s.name.assign(4097, 'x'); }, "name has 4097 bytes; must have at most 4096"},
    {"Generator", [](S& s, F&) { s.generator = std::string(1, '\0'); }, "byte 0 of generator is 0" + text},
    {"Width0", [](S& s, F&) { s.width = 0; }, "width is 0; must be 1 ... 16384"},
    {"Height16385", [](S& s, F&) { s.height = 16385; }, "height is 16385; must be 1 ... 16384"},
    {"Fps0", [](S& s, F&) { s.fps = 0; }, "fps is 0; must be finite and above 0"},
    {"FpsNan", [](S& s, F&) { s.fps = nan; }, "fps is nan; must be finite and above 0"},
    {"FpsInf", [](S& s, F&) { s.fps = inf; }, "fps is inf; must be finite and above 0"},
    {"Materials", [](S& s, F&) { s.materials.resize(65537); },
     "the number of materials is 65537; must be at most 65536"},
    {"Textures", [](S& s, F&) { s.textures.resize(65537); }, "the number of textures is 65537; must be at most 65536"},
    {"MaterialName", [](S& s, F&) { s.materials[1].name = "\t"; }, "materials[1]: byte 0 of name is 9" + text},
    {"DiffuseNegative", [](S& s, F&) { s.materials[1].diffuse.y = -0.5f; }, "materials[1]: diffuse.y is -0.5" + weight},
    {"SpecularNan", [](S& s, F&) { s.materials[0].specular.z = nan; }, "materials[0]: specular.z is nan" + weight},
    {"SpecularLog2", [](S& s, F&) { s.materials[0].specular_log2 = 11; },
     "materials[0]: specular_log2 is 11; must be at most 10"},
    {"MirrorInf", [](S& s, F&) { s.materials[0].mirror.x = inf; }, "materials[0]: mirror.x is inf" + weight},
    {"Transmission", [](S& s, F&) { s.materials[0].transmission.x = -inf; },
     "materials[0]: transmission.x is -inf" + weight},
    {"IorSmall", [](S& s, F&) { s.materials[1].ior = 0.125f; }, "materials[1]: ior is 0.125; must be 0.25 ... 4"},
    {"IorLarge", [](S& s, F&) { s.materials[1].ior = 4.5f; }, "materials[1]: ior is 4.5; must be 0.25 ... 4"},
    {"IorNan", [](S& s, F&) { s.materials[1].ior = nan; }, "materials[1]: ior is nan; must be 0.25 ... 4"},
    {"Emission", [](S& s, F&) { s.materials[1].emission.z = -1; }, "materials[1]: emission.z is -1" + weight},
    {"EmissionHuge", [](S& s, F&) { s.materials[1].emission.z = limit; },
     "materials[1]: emission.z is 4.61168602e+18" + weight},
    {"TextureBeyond", [](S& s, F&) { s.materials[1].texture = 2; },
     "materials[1]: texture is 2; must be -1 or below 2, the number of textures"},
    {"TextureNegative", [](S& s, F&) { s.materials[1].texture = -2; },
     "materials[1]: texture is -2; must be -1 or below 2, the number of textures"},
    {"TextureName", [](S& s, F&) { s.textures[1].name = "\r"; }, "textures[1]: byte 0 of name is 13" + text},
    {"TextureWidth", [](S& s, F&) { s.textures[1].width = 0; }, "textures[1]: width is 0; must be 1 ... 16384"},
    {"TextureHeight", [](S& s, F&) { s.textures[1].height = 99999; },
     "textures[1]: height is 99999; must be 1 ... 16384"},
    {"WrapU", [](S& s, F&) { s.textures[0].wrap_u = Wrap{3}; },
     "textures[0]: wrap_u is 3; must be repeat, clamp or mirror: 0 ... 2"},
    {"WrapV", [](S& s, F&) { s.textures[0].wrap_v = Wrap{255}; },
     "textures[0]: wrap_v is 255; must be repeat, clamp or mirror: 0 ... 2"},
    {"Texels", [](S& s, F&) { s.textures[1].rgba.pop_back(); },
     "textures[1]: rgba has 7 elements; must have 8, four a texel"},
};

const Refusal mesh_refusals[] = {
    {"PositionNan", [](S& s, F&) { s.static_geometry.positions[3].y = nan; },
     "static geometry: positions[3].y is nan" + coordinate},
    {"PositionInf", [](S& s, F&) { s.static_geometry.positions[6].z = -inf; },
     "static geometry: positions[6].z is -inf" + coordinate},
    {"PositionLimit", [](S&, F& f) { f.dynamic.positions[0].x = -limit; },
     "dynamic geometry: positions[0].x is -4.61168602e+18" + coordinate},
    {"Normal", [](S& s, F&) { s.static_geometry.normals[1].x = inf; },
     "static geometry: normals[1].x is inf" + coordinate},
    {"UvNan", [](S& s, F&) { s.static_geometry.uvs[2].y = nan; },
     "static geometry: uvs[2].y is nan; must be finite and at most 2^20 in magnitude"},
    {"UvLarge", [](S& s, F&) { s.static_geometry.uvs[2].x = -1048577; },
     "static geometry: uvs[2].x is -1048577; must be finite and at most 2^20 in magnitude"},
    {"Normals", [](S& s, F&) { s.static_geometry.normals.pop_back(); },
     "static geometry: normals has 6 elements; must have 7, as positions"},
    {"Uvs", [](S& s, F&) { s.static_geometry.uvs.emplace_back(); },
     "static geometry: uvs has 8 elements; must have 7, as positions"},
    {"Colors", [](S& s, F&) { s.static_geometry.colors.clear(); },
     "static geometry: colors has 0 elements; must have 7, as positions"},
    {"Indices", [](S& s, F&) { s.static_geometry.indices.pop_back(); },
     "static geometry: indices has 14 elements; must have 15, three a triangle"},
    {"IndexBeyond", [](S& s, F&) { s.static_geometry.indices[14] = 7; },
     "static geometry: indices[14] is 7; must be below 7, the number of vertices"},
    {"IndexHuge", [](S&, F& f) { f.dynamic.indices[0] = 0xFFFFFFFFu; },
     "dynamic geometry: indices[0] is 4294967295; must be below 4, the number of vertices"},
    {"MaterialBeyond", [](S& s, F&) { s.static_geometry.materials[4] = 2; },
     "static geometry: materials[4] is 2; must be below 2, the number of the scene's materials"},
    {"NoMaterials", [](S& s, F&) { s.materials.clear(); },
     "static geometry: materials[0] is 0; must be below 0, the number of the scene's materials"},
    {"NoVertices",
     [](S&, F& f) {
       f.dynamic = {{}, {}, {}, {}, {0, 0, 0}, {0}};
     },
     "dynamic geometry: indices[0] is 0; must be below 0, the number of vertices"},
};

const Refusal frame_refusals[] = {
    {"Time", [](S&, F& f) { f.time = nan; }, "time is nan; must be finite"},
    {"Origin", [](S&, F& f) { f.camera.origin.x = nan; }, "camera: origin.x is nan" + coordinate},
    {"OriginDu", [](S&, F& f) { f.camera.origin_du.y = inf; }, "camera: origin_du.y is inf" + coordinate},
    {"OriginDv", [](S&, F& f) { f.camera.origin_dv.z = -nan; }, "camera: origin_dv.z is nan" + coordinate},
    {"Corner", [](S&, F& f) { f.camera.corner.z = limit; }, "camera: corner.z is 4.61168602e+18" + coordinate},
    {"Du", [](S&, F& f) { f.camera.du.y = nan; }, "camera: du.y is nan" + coordinate},
    {"Dv", [](S&, F& f) { f.camera.dv.x = nan; }, "camera: dv.x is nan" + coordinate},
    {"Lights", [](S&, F& f) { f.lights.resize(65); }, "the number of lights is 65; must be at most 64"},
    {"LightKind", [](S&, F& f) { f.lights[1].kind = LightKind{3}; },
     "lights[1]: kind is 3; must be point, directional or spot: 0 ... 2"},
    {"LightPosition", [](S&, F& f) { f.lights[1].position.x = nan; }, "lights[1]: position.x is nan" + coordinate},
    {"LightDirection", [](S&, F& f) { f.lights[1].direction.x = nan; }, "lights[1]: direction.x is nan" + coordinate},
    {"LightColor", [](S&, F& f) { f.lights[0].color.x = -1; }, "lights[0]: color.x is -1" + weight},
    {"LightRangeNan", [](S&, F& f) { f.lights[1].range = nan; }, "lights[1]: range is nan" + coordinate},
    {"LightRange0", [](S&, F& f) { f.lights[0].range = 0; }, "lights[0]: range is 0; must be above 0"},
    {"LightLength", [](S&, F& f) { f.lights[0].direction.x = 1; },
     "lights[0]: the length of direction is 1.4142135623730951; must be 1, within 0.001"},
    {"LightLengthDirectional", [](S&, F& f) { f.lights[1].direction = {}; },
     "lights[1]: the length of direction is 0; must be 1, within 0.001"},
    {"CosInnerNan", [](S&, F& f) { f.lights[1].cos_inner = nan; }, "lights[1]: cos_inner is nan" + coordinate},
    {"CosOuterInf", [](S&, F& f) { f.lights[1].cos_outer = inf; }, "lights[1]: cos_outer is inf" + coordinate},
    {"CosInner", [](S&, F& f) { f.lights[0].cos_inner = 1.5f; }, "lights[0]: cos_inner is 1.5; must be at most 1"},
    {"CosOuter", [](S&, F& f) { f.lights[0].cos_outer = -1.5f; }, "lights[0]: cos_outer is -1.5; must be at least -1"},
    {"CosOrder", [](S&, F& f) { f.lights[0].cos_outer = 0.75f; },
     "lights[0]: cos_outer is 0.75; must be below cos_inner, which is 0.75"},
    {"Ambient", [](S&, F& f) { f.ambient.y = -1; }, "ambient.y is -1" + weight},
    {"SkyNadir", [](S&, F& f) { f.sky_nadir.z = nan; }, "sky_nadir.z is nan" + weight},
    {"SkyZenith", [](S&, F& f) { f.sky_zenith.x = inf; }, "sky_zenith.x is inf" + weight},
};

const auto by_name = [](const testing::TestParamInfo<Refusal>& info) { return info.param.name; };
INSTANTIATE_TEST_SUITE_P(OfScene, Validate, testing::ValuesIn(scene_refusals), by_name);
INSTANTIATE_TEST_SUITE_P(OfMesh, Validate, testing::ValuesIn(mesh_refusals), by_name);
INSTANTIATE_TEST_SUITE_P(OfFrame, Validate, testing::ValuesIn(frame_refusals), by_name);

TEST(ValidateAccepts, TheEdgesOfTheRanges) {
  Scene scene = sample_scene();
  Frame frame = sample_frame(0);
  scene.materials[0].ior = 0.25f;
  scene.materials[1].ior = 4.0f;
  scene.materials[0].diffuse = {-0.0f, std::nextafterf(limit, 0), 0};
  scene.static_geometry.positions[0] = {std::nextafterf(limit, 0), -std::nextafterf(limit, 0), -0.0f};
  scene.static_geometry.uvs[0] = {1048576, -1048576};
  frame.lights[0].cos_inner = 1;
  frame.lights[0].cos_outer = -1;
  frame.lights[0].direction = {0, 0.9995f, 0};
  frame.lights[1].range = 0;  // of a directional light: not used
  frame.lights.resize(64);
  frame.lights[5].direction = {};                                                   // of a point light: not used
  scene.name = "\xC2\xA0\xE0\xA0\x80\xED\x9F\xBF\xF0\x90\x80\x80\xF4\x8F\xBF\xBF";  // the first and last of a length
  EXPECT_EQ(message_of([&] { validate(scene, "here"); }), "");
  EXPECT_EQ(message_of([&] { validate(scene, frame, "here"); }), "");
}

}  // namespace
}  // namespace artu::traces::test
