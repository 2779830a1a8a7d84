// The rarer things that a glTF file can have wrong; each message says where and what.
#include "unit/sim/import_fixture.h"

namespace artu::sim::test {
namespace {

using ::testing::HasSubstr;

class BadGltfDetails : public ImportTest {
 protected:
  BadGltfDetails() {
    g.triangle();
    g.add("nodes", {{"mesh", 0}});
  }
  Json& primitive() { return g.j["meshes"][0]["primitives"][0]; }
  Json& positions() { return g.j["accessors"][0]; }
  std::string error() { return error_of(g); }
  Gltf g;
};

TEST_F(BadGltfDetails, StridesBelowAnElement) {
  g.j["bufferViews"][0]["byteStride"] = 4;
  EXPECT_THAT(error(), HasSubstr("byteStride 4 is less than an element's 12 bytes"));
}

TEST_F(BadGltfDetails, SparseAccessors) {
  const int indices = g.view(std::vector<std::uint16_t>{0}), values = g.view(std::vector<float>{0, 0, 0});
  const Json good = {{"count", 1},
                     {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                     {"values", {{"bufferView", values}}}};
  positions()["sparse"] = good;
  EXPECT_EQ(error(), "(no error)");
  positions()["sparse"]["count"] = 4;  // of three
  EXPECT_THAT(error(), HasSubstr("sparse.count is not between 0 and the accessor's count"));
  positions()["sparse"] = good;
  positions()["sparse"]["indices"]["componentType"] = 5126;
  EXPECT_THAT(error(), HasSubstr("sparse.indices have component type 5126"));
  positions()["sparse"] = good;
  positions()["sparse"]["count"] = 2;
  EXPECT_THAT(error(), HasSubstr("sparse indices or values leave their buffer view"));
}

TEST_F(BadGltfDetails, IndicesThatAreNoWholeNumbers) {
  primitive()["indices"] = g.scalars({0, 1, 2});
  EXPECT_THAT(error(), HasSubstr("component type 5126; unsigned byte, short or int is needed"));
}

TEST_F(BadGltfDetails, ModesThatThereAreNot) {
  primitive()["mode"] = 7;
  EXPECT_THAT(error(), HasSubstr("mode 7; 0 ... 6 is allowed"));
}

TEST_F(BadGltfDetails, SamplersThatDoNotExist) {
  g.animate(0, "translation", g.scalars({0}), g.vec3({0, 0, 0}));
  g.j["animations"][0]["channels"][0]["sampler"] = 3;
  EXPECT_THAT(error(), HasSubstr("sampler 3 does not exist; there are 1"));
}

TEST_F(BadGltfDetails, ListsOfOtherThings) {
  g.j["materials"] = Json::array({7});
  EXPECT_THAT(error(), HasSubstr("materials[0] is not an object"));
  g.j.erase("materials");
  g.j["extensionsUsed"] = Json::array({Json::object()});
  EXPECT_THAT(error(), HasSubstr("extensionsUsed[0] is not a string"));
}

TEST_F(BadGltfDetails, BuffersWithoutBytes) {
  g.j["buffers"] = {{{"byteLength", g.data.size()}}};
  EXPECT_THAT(error(), HasSubstr("buffers[0]: has no uri; only the first buffer of a .glb may do without"));
}

TEST_F(BadGltfDetails, TextureCoordinatesFarAway) {
  primitive()["attributes"]["TEXCOORD_0"] = g.vec2({0, 0, 1, 0, 4e6f, 0});
  g.j["images"] = {{{"uri", "data:image/png;base64," + base64(png_2x1())}}};
  g.j["textures"] = {{{"source", 0}}};
  g.j["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  primitive()["material"] = 0;
  EXPECT_THAT(error(), HasSubstr("element 2 is over 2^20; texture coordinates are near 0 ... 1"));
}

TEST_F(BadGltfDetails, JointsBeyondTheLimit) {
  std::vector<std::uint32_t> joints(12, 0);
  joints[4] = 65536;
  primitive()["attributes"]["JOINTS_0"] = g.accessor("VEC4", 5125, joints, 4);
  primitive()["attributes"]["WEIGHTS_0"] = g.vec4({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  EXPECT_THAT(error(), HasSubstr("joint 65536 of vertex 1 is over the limit of 65535"));
}

TEST_F(BadGltfDetails, TransformsOfAnotherLength) {
  g.j["nodes"][0]["translation"] = {1, 2};
  EXPECT_THAT(error(), HasSubstr("translation has 2 numbers, it must have 3"));
}

TEST_F(BadGltfDetails, Cameras) {
  g.j["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 4}, {"znear", 0.1}}}}};
  EXPECT_THAT(error(), HasSubstr("cameras[0]: yfov is 4.0"));
  g.j["cameras"] = {
      {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 0}, {"znear", 0.1}, {"zfar", 9}}}}};
  EXPECT_THAT(error(), HasSubstr("cameras[0]: ymag must be above 0"));
}

TEST_F(BadGltfDetails, Lights) {
  const auto lights = [&](const Json& light) {
    g.j["extensionsUsed"] = Json::array({"KHR_lights_punctual"});
    g.j["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({light});
    return error();
  };
  EXPECT_EQ(lights({{"type", "point"}}), "(no error)");
  EXPECT_THAT(lights({{"type", "laser"}}), HasSubstr("lights[0]: type is \"laser\"; point, spot or directional"));
  EXPECT_THAT(lights({{"type", "point"}, {"intensity", -1}}), HasSubstr("color times intensity must be 0 or more"));
}

TEST_F(BadGltfDetails, TexturesAndImagesThatDoNotExist) {
  g.j["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 5}}}}}}};
  primitive()["material"] = 0;
  primitive()["attributes"]["TEXCOORD_0"] = g.vec2({0, 0, 1, 0, 0, 1});
  EXPECT_THAT(error(), HasSubstr("texture 5 does not exist; there are 0"));
  g.j["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 0;
  g.j["textures"] = {{{"source", 2}}};
  EXPECT_THAT(error(), HasSubstr("image 2 does not exist; there are 0"));
}

/// The header is whole, the pixels are not.
TEST_F(BadGltfDetails, ImagesThatAreCut) {
  const std::string whole = png_2x1();
  g.j["images"] = {{{"uri", "data:image/png;base64," + base64(whole.substr(0, 50))}}};
  g.j["textures"] = {{{"source", 0}}};
  g.j["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  primitive()["material"] = 0;
  primitive()["attributes"]["TEXCOORD_0"] = g.vec2({0, 0, 1, 0, 0, 1});
  EXPECT_THAT(error(), HasSubstr("broken image: "));
}

}  // namespace
}  // namespace artu::sim::test
