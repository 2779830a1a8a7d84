#include <cmath>
#include <limits>

#include "unit/sim/import_fixture.h"

namespace artu::sim::test {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Floats = std::vector<float>;

/// Each message names the file, the place in it, and what is wrong there.
class BadGltf : public ImportTest {
 protected:
  BadGltf() {
    g.triangle();
    g.add("nodes", {{"mesh", 0}});
  }
  Json& primitive() { return g.j["meshes"][0]["primitives"][0]; }
  std::string error() { return error_of(g); }
  Gltf g;
};

TEST_F(BadGltf, TheGoodOneOpens) { EXPECT_EQ(error(), "(no error)"); }

TEST_F(BadGltf, MissingFile) { EXPECT_THAT(error_of(folder.path("none.glb")), EndsWith("none.glb: no such file")); }

TEST_F(BadGltf, AnotherKindOfFile) {
  EXPECT_THAT(error_of(folder.write("a.fbx", "x")),
              HasSubstr("a.fbx: is not a model that can be read; .glb, .gltf and .obj can"));
}

TEST_F(BadGltf, SyntaxErrorsHaveALine) {
  EXPECT_THAT(error_of(folder.write("a.gltf", "{\n\"asset\":\n]")), HasSubstr("a.gltf:3: not valid JSON at byte"));
}

TEST_F(BadGltf, NumbersThatNoDoubleHolds) {
  EXPECT_THAT(error_of(folder.write("a.gltf", "{\"asset\":{\"version\":\"2.0\"},\"scene\":1e999}")),
              HasSubstr("a.gltf: not valid JSON: "));
}

TEST_F(BadGltf, ExtensionsOfTheWrongType) {
  const Json strange = {
      {"KHR_materials_transmission", {{"transmissionTexture", {{"index", 1e300}, {"extensions", 3}}}}},
      {"KHR_materials_ior", 7},
      {"KHR_materials_pbrSpecularGlossiness", {{"diffuseFactor", "red"}, {"diffuseTexture", {1}}}}};
  g.j["materials"] = {{{"extensions", strange}}};
  EXPECT_EQ(error(), "(no error)");
  g.j["nodes"][0]["extensions"] = {{"KHR_lights_punctual", {{"light", 1e300}}}};
  EXPECT_THAT(error(), HasSubstr("nodes[0]: light is not a whole number"));
}

TEST_F(BadGltf, OldVersion) {
  g.j["asset"]["version"] = "1.0";
  EXPECT_THAT(error(), HasSubstr("is glTF version 1.0; only 2.x can be read"));
}

TEST_F(BadGltf, TruncatedGlbAtEveryLength) {
  const std::string whole = g.glb();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::string message = error_of(folder.write("cut.glb", whole.substr(0, size)));
    ASSERT_THAT(message, HasSubstr("cut.glb")) << size;
    if (size >= 20) {
      ASSERT_THAT(message, HasSubstr("truncated .glb")) << size;
    }
  }
}

TEST_F(BadGltf, AnyFlippedByteIsAnErrorOrAScene) {
  const std::string whole = g.glb();
  for (std::size_t i = 0; i < whole.size(); ++i) {
    for (const char flip : {1, 4, 64, -128}) {
      std::string broken = whole;
      broken[i] = static_cast<char>(broken[i] ^ flip);
      const std::string path = folder.write("flip.glb", broken);
      try {
        open(path);
        source->frame(0);
      } catch (const InputError&) {
      }
    }
  }
}

TEST_F(BadGltf, NestingIsLimited) {
  EXPECT_THAT(error_of(folder.write("deep.gltf", "{\"extras\":" + std::string(100000, '['))),
              HasSubstr("nested deeper than 128"));
}

TEST_F(BadGltf, FilesOutsideTheFolder) {
  const auto with_uri = [&](const char* where, const std::string& uri) {
    Gltf bad = g;
    if (std::string(where) == "buffers") {
      bad.j["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
    } else {
      bad.j["images"] = {{{"uri", uri}}};
    }
    return error_of(bad);
  };
  folder.write("outside.bin", g.data);
  for (const char* where : {"buffers", "images"}) {
    EXPECT_THAT(with_uri(where, "../outside.bin"), AllOf(HasSubstr(std::string(where) + "[0]"), HasSubstr("\"..\"")));
    EXPECT_THAT(with_uri(where, "a/%2e%2e/../x"), HasSubstr("\"..\""));
    EXPECT_THAT(with_uri(where, "/etc/hostname"), HasSubstr("is an absolute path"));
    EXPECT_THAT(with_uri(where, "file:///etc/hostname"), HasSubstr("has a scheme"));
    EXPECT_THAT(with_uri(where, "https://example.org/x"), HasSubstr("has a scheme"));
    EXPECT_THAT(with_uri(where, "C:\\x.bin"), HasSubstr("has a scheme or a drive"));
    EXPECT_THAT(with_uri(where, "absent.bin"), HasSubstr("file \"absent.bin\" cannot be read"));
    EXPECT_THAT(with_uri(where, "."), HasSubstr("is not a regular file"));
  }
}

TEST_F(BadGltf, LinksThatLeaveTheFolder) {
  TempFolder other;
  other.write("secret.bin", g.data);
  std::filesystem::create_symlink(other.path("secret.bin"), folder.path("link.bin"));
  g.j["buffers"] = {{{"byteLength", 36}, {"uri", "link.bin"}}};
  EXPECT_THAT(error(), HasSubstr("is a link that leaves the scene's folder"));
}

TEST_F(BadGltf, BufferShorterThanItSays) {
  g.j["buffers"] = {{{"byteLength", 4000}, {"uri", "data:application/octet-stream;base64," + base64(g.data)}}};
  EXPECT_THAT(error(), HasSubstr("not a valid glTF file"));
}

TEST_F(BadGltf, NumbersThatAreNone) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  primitive()["attributes"]["POSITION"] = g.vec3({0, 0, 0, 1, nan, 0, 0, 1, 0});
  EXPECT_THAT(error(), HasSubstr("meshes[0].primitives[0].POSITION (accessors[1]): element 1 is not a finite number"));
  primitive()["attributes"]["POSITION"] = g.vec3({0, 0, 0, 1, 0, 0, 0, INFINITY, 0});
  EXPECT_THAT(error(), HasSubstr("element 2 is not a finite number"));
}

TEST_F(BadGltf, TransformsThatLeaveTheNumbers) {
  g.j["nodes"][0]["scale"] = {1e25, 1, 1};
  EXPECT_THAT(error(), HasSubstr("too far away once it is in world space"));
}

TEST_F(BadGltf, IndexOutOfRange) {
  primitive()["indices"] = g.indices({0, 1, 3});
  EXPECT_THAT(error(), HasSubstr("indices: index 3 (element 2) is not below the vertex count 3"));
}

TEST_F(BadGltf, AccessorOutsideItsView) {
  g.j["accessors"][0]["count"] = 4;
  EXPECT_THAT(error(), HasSubstr("4 elements of 12 bytes at offset 0, stride 12, leave the buffer view of 36 bytes"));
  g.j["accessors"][0]["count"] = std::uint64_t{1} << 60;
  EXPECT_THAT(error(), HasSubstr("leave the buffer view"));
  g.j["accessors"][0]["count"] = 3;
  g.j["accessors"][0]["byteOffset"] = 4;
  EXPECT_THAT(error(), HasSubstr("leave the buffer view"));
  g.j["accessors"][0]["byteOffset"] = std::uint64_t{1} << 62;
  EXPECT_THAT(error(), HasSubstr("leave the buffer view"));
}

TEST_F(BadGltf, ViewOutsideItsBuffer) {
  g.j["bufferViews"][0]["byteLength"] = 37;
  EXPECT_THAT(error(), HasSubstr("bufferViews[0] (offset 0, length 37) leaves its buffer of 36 bytes"));
  g.j["bufferViews"][0]["byteLength"] = 36;
  g.j["bufferViews"][0]["buffer"] = 7;
  EXPECT_THAT(error(), HasSubstr("is of buffer 7, which does not exist"));
}

TEST_F(BadGltf, AccessorOrViewThatDoesNotExist) {
  primitive()["attributes"]["POSITION"] = 9;
  EXPECT_THAT(error(), HasSubstr("POSITION: accessor 9 does not exist; there are 1"));
  primitive()["attributes"]["POSITION"] = 0;
  g.j["accessors"][0]["bufferView"] = 5;
  EXPECT_THAT(error(), HasSubstr("buffer view 5 does not exist"));
}

TEST_F(BadGltf, HugeAccessorsWithoutBytes) {
  g.j["accessors"][0] = {{"componentType", 5126}, {"count", std::uint64_t{1} << 40}, {"type", "VEC3"}};
  EXPECT_THAT(error(), HasSubstr("elements without a buffer view; the limit is"));
}

TEST_F(BadGltf, AttributesOfAnotherLengthOrKind) {
  primitive()["attributes"]["NORMAL"] = g.vec3({0, 0, 1});
  EXPECT_THAT(error(), HasSubstr("NORMAL: has 1 elements, POSITION has 3"));
  primitive()["attributes"].erase("NORMAL");
  primitive()["attributes"]["POSITION"] = g.vec2({0, 0, 1, 0, 0, 1});
  EXPECT_THAT(error(), HasSubstr("has 2 numbers an element, which does not fit its use"));
}

TEST_F(BadGltf, SparseIndexOutOfRange) {
  const int i = g.view(std::vector<std::uint16_t>{3}), v = g.view(Floats{7, 8, 9});
  g.j["accessors"][0]["sparse"] = {
      {"count", 1}, {"indices", {{"bufferView", i}, {"componentType", 5123}}}, {"values", {{"bufferView", v}}}};
  EXPECT_THAT(error(), HasSubstr("sparse index 3 is not below the count 3"));
}

TEST_F(BadGltf, NodeCycles) {
  g.j["nodes"] = {{{"children", {1}}}, {{"children", {2}}}, {{"children", {1}}}};
  EXPECT_THAT(error(), HasSubstr("nodes[1]: is a child of both nodes[0] and nodes[2]"));
  g.j["nodes"] = {{{"mesh", 0}}, {{"children", {2}}}, {{"children", {1}}}};
  EXPECT_THAT(error(), HasSubstr("is its own ancestor (node cycle)"));
  g.j["nodes"] = {{{"children", {0}}}};
  EXPECT_THAT(error(), HasSubstr("nodes[0]: is its own child"));
}

TEST_F(BadGltf, DeepHierarchiesAreFine) {
  g.j["nodes"] = Json::array();
  for (int n = 0; n < 20000; ++n) g.j["nodes"].push_back({{"children", {n + 1}}});
  g.j["nodes"].push_back({{"mesh", 0}});
  EXPECT_EQ(error(), "(no error)");
}

TEST_F(BadGltf, RequiredExtensions) {
  g.j["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  EXPECT_THAT(error(), EndsWith("needs extension KHR_draco_mesh_compression, which is not supported"));
  g.j["extensionsRequired"] = {"KHR_lights_punctual"};
  g.j["extensionsUsed"] = {"KHR_lights_punctual", "EXT_something"};
  EXPECT_EQ(error(), "(no error)");
  EXPECT_THAT(log, ::testing::Contains(EndsWith("extension EXT_something is ignored")));
}

TEST_F(BadGltf, SkinWithTooFewMatrices) {
  g.j["skins"] = {{{"joints", {0, 0}}, {"inverseBindMatrices", g.mat4(Floats(16, 1))}}};
  EXPECT_THAT(error(), HasSubstr("skins[0]: has 1 inverse bind matrices for 2 joints"));
}

TEST_F(BadGltf, JointThatTheSkinDoesNotHave) {
  g.j["skins"] = {{{"joints", {0}}}};
  g.j["nodes"][0]["skin"] = 0;
  primitive()["attributes"]["JOINTS_0"] = g.joints({0, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0});
  primitive()["attributes"]["WEIGHTS_0"] = g.vec4({1, 0, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0});
  EXPECT_THAT(error(), HasSubstr("a vertex uses joint 3 of a skin with 1 joints"));
}

TEST_F(BadGltf, AnimationSamplers) {
  const int times = g.scalars({0, 1}), values = g.vec3({0, 0, 0, 1, 1, 1, 2, 2, 2});
  g.animate(0, "translation", times, values);
  EXPECT_THAT(error(), HasSubstr("animations[0].channels[0]: 2 keys need 6 numbers of output, there are 9"));
  g.j.erase("animations");
  g.animate(0, "translation", g.scalars({1, 0, 2}), values);
  EXPECT_THAT(error(), HasSubstr("key 1 is earlier than the key before it"));
  g.j.erase("animations");
  g.animate(0, "translation", times, values, "BEZIER");
  EXPECT_THAT(error(), HasSubstr("interpolation \"BEZIER\" is not supported; LINEAR, STEP or CUBICSPLINE is"));
  g.j.erase("animations");
  g.animate(7, "translation", times, values);
  EXPECT_THAT(error(), HasSubstr("node 7 does not exist; there are 1"));
}

TEST_F(BadGltf, ReferencesThatDoNotExist) {
  g.j["nodes"][0]["mesh"] = 4;
  EXPECT_THAT(error(), HasSubstr("nodes[0]: mesh 4 does not exist; there are 1"));
  g.j["nodes"][0] = {{"mesh", 0}, {"camera", 0}};
  EXPECT_THAT(error(), HasSubstr("camera 0 does not exist"));
  g.j["nodes"][0] = {{"mesh", 0}, {"children", {8}}};
  EXPECT_THAT(error(), HasSubstr("child 8 does not exist"));
  g.j["nodes"][0] = {{"mesh", 0}};
  primitive()["material"] = 2;
  EXPECT_THAT(error(), HasSubstr("material 2 does not exist"));
}

TEST_F(BadGltf, InstancingBombs) {
  primitive()["indices"] = g.accessor("SCALAR", 5123, std::vector<std::uint16_t>(30000, 0), 1);
  g.j["nodes"] = Json::array();
  Json children = Json::array();
  for (int n = 1; n <= 4000; ++n) children.push_back(n);
  g.j["nodes"].push_back({{"children", children}});
  for (int n = 0; n < 4000; ++n) g.j["nodes"].push_back({{"mesh", 0}});
  EXPECT_THAT(error(), HasSubstr("has more than 33554432 triangles or vertices once its instances are counted"));
}

TEST_F(BadGltf, BrokenImages) {
  g.j["images"] = {{{"uri", "data:image/png;base64," + base64("not a picture at all")}}};
  g.j["textures"] = {{{"source", 0}}};
  g.j["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  EXPECT_THAT(error(), HasSubstr("images[0]: is neither a PNG nor a JPEG image"));
  std::string big = png_2x1();
  big[18] = 0x40, big[19] = 1;  // 16385 wide
  g.j["images"][0]["uri"] = "data:image/png;base64," + base64(big);
  EXPECT_THAT(error(), HasSubstr("images[0]: image is 16385 x 1 pixels; 1 ... 16384 each way is allowed"));
  g.j["images"][0] = {{"bufferView", 0}, {"mimeType", "image/png"}};
  g.j["bufferViews"][0]["byteLength"] = 1 << 30;
  EXPECT_THAT(error(), HasSubstr("leaves its buffer"));
}

TEST_F(BadGltf, OptionsOutOfRange) {
  options.first_frame = 5;
  options.last_frame = 5;
  EXPECT_THAT(error(), HasSubstr("5:5 is empty"));
  options.first_frame = options.last_frame = 0;
  options.fps = 0;
  EXPECT_THAT(error(), StartsWith("fps: "));
  options.fps = 30;
  options.width = 0;
  EXPECT_THAT(error(), StartsWith("size: 0 x 360"));
}

}  // namespace
}  // namespace artu::sim::test
