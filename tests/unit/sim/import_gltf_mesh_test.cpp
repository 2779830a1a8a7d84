#include <cmath>

#include "unit/sim/import_fixture.h"

namespace artu::sim::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Floats = std::vector<float>;

class GltfMesh : public ImportTest {
 protected:
  const traces::Mesh& only(const Json& attributes, const Json& more = Json::object()) {
    g.mesh(attributes, more);
    g.add("nodes", {{"mesh", 0}});
    return open(g).scene().static_geometry;
  }
  Gltf g;
};

const Floats square = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};

TEST_F(GltfMesh, WithoutIndicesTakesVerticesInOrder) {
  const auto& mesh = only({{"POSITION", g.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0})}});
  EXPECT_THAT(corners(mesh), near({0, 0, 0, 1, 0, 0, 0, 1, 0}, 0));
  EXPECT_THAT(xyz(mesh.normals[0]), ElementsAre(0, 0, 0)) << "without normals the face is flat";
  EXPECT_EQ(mesh.colors[0], 0xffffffffu);
}

TEST_F(GltfMesh, IndicesShareVertices) {
  const int position = g.vec3(square);
  const auto& mesh = only({{"POSITION", position}}, {{"indices", g.indices({0, 1, 2, 2, 3, 0})}});
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.triangle_count(), 2u);
  EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 2, 3, 0));
}

TEST_F(GltfMesh, StripsAlternateTheirWinding) {
  const int position = g.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
  const auto& mesh = only({{"POSITION", position}}, {{"mode", 5}});
  EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 1, 3, 2));
}

TEST_F(GltfMesh, FansTurnAboutTheirFirstVertex) {
  const int position = g.vec3(square);
  EXPECT_THAT(only({{"POSITION", position}}, {{"mode", 6}}).indices, ElementsAre(0, 1, 2, 0, 2, 3));
}

TEST_F(GltfMesh, LinesAreSkippedWithALogLine) {
  const int position = g.vec3(square);
  EXPECT_EQ(only({{"POSITION", position}}, {{"mode", 1}}).triangle_count(), 0u);
  EXPECT_THAT(log, ::testing::Contains(HasSubstr("points and lines are skipped")));
}

TEST_F(GltfMesh, ByteStrideSkipsWhatIsBetween) {
  // Position and normal interleaved, 24 bytes a vertex.
  const int view = g.view(Floats{0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 2}, 24);
  const int p = g.add("accessors", {{"bufferView", view}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
  const int n = g.add(
      "accessors", {{"bufferView", view}, {"byteOffset", 12}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
  const auto& mesh = only({{"POSITION", p}, {"NORMAL", n}});
  EXPECT_THAT(corners(mesh), near({0, 0, 0, 1, 0, 0, 0, 1, 0}, 0));
  EXPECT_THAT(xyz(mesh.normals[2]), ElementsAre(0, 0, 1));
}

TEST_F(GltfMesh, NormalisedIntegersAreScaled) {
  const int view = g.view(std::vector<std::int16_t>{0, 0, 0, 0, 32767, 0, -32768, 0, 0, 16384, 0, 0}, 8);
  const int p =
      g.add("accessors",
            {{"bufferView", view}, {"componentType", 5122}, {"normalized", true}, {"count", 3}, {"type", "VEC3"}});
  EXPECT_THAT(corners(only({{"POSITION", p}})), near({0, 0, 0, 1, 0, -1, 0, 16384 / 32767.0f, 0}));
}

TEST_F(GltfMesh, VertexColoursOfEachKind) {
  const int p = g.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const int c = g.accessor("VEC4", 5121, std::vector<std::uint8_t>{1, 2, 3, 4, 255, 0, 0, 255, 0, 0, 9, 255}, 4);
  g.j["accessors"][c]["normalized"] = true;
  EXPECT_THAT(only({{"POSITION", p}, {"COLOR_0", c}}).colors, ElementsAre(0x04030201u, 0xff0000ffu, 0xff090000u));
}

TEST_F(GltfMesh, FloatColoursAreClamped) {
  const int p = g.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0}), c = g.vec3({0, 0.5f, 1, 2, -1, 0, 1, 1, 1});
  EXPECT_THAT(only({{"POSITION", p}, {"COLOR_0", c}}).colors, ElementsAre(0xffff8000u, 0xff0000ffu, 0xffffffffu));
}

TEST_F(GltfMesh, SparseValuesReplaceTheirBase) {
  const int p = g.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const int i = g.view(std::vector<std::uint16_t>{2}), v = g.view(Floats{7, 8, 9});
  g.j["accessors"][p]["sparse"] = {
      {"count", 1}, {"indices", {{"bufferView", i}, {"componentType", 5123}}}, {"values", {{"bufferView", v}}}};
  EXPECT_THAT(corners(only({{"POSITION", p}})), near({0, 0, 0, 1, 0, 0, 7, 8, 9}, 0));
}

TEST_F(GltfMesh, SparseWithoutABaseStartsAtZero) {
  const int i = g.view(std::vector<std::uint8_t>{1, 2}), v = g.view(Floats{1, 0, 0, 0, 1, 0});
  const int p = g.add(
      "accessors",
      {{"componentType", 5126},
       {"count", 3},
       {"type", "VEC3"},
       {"sparse",
        {{"count", 2}, {"indices", {{"bufferView", i}, {"componentType", 5121}}}, {"values", {{"bufferView", v}}}}}});
  EXPECT_THAT(corners(only({{"POSITION", p}})), near({0, 0, 0, 1, 0, 0, 0, 1, 0}, 0));
}

TEST_F(GltfMesh, MirroredNodesKeepTheirOutside) {
  const int p = g.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0}), n = g.vec3({0, 0, 1, 0, 0, 1, 0, 0, 1});
  g.mesh({{"POSITION", p}, {"NORMAL", n}});
  g.add("nodes", {{"mesh", 0}, {"scale", {-2, 1, 1}}});
  const auto& mesh = open(g).scene().static_geometry;
  // Turned so that the face's own normal still is +z, as the vertex normals are.
  EXPECT_THAT(corners(mesh), near({0, 0, 0, 0, 1, 0, -2, 0, 0}));
  EXPECT_THAT(xyz(mesh.normals[0]), near({0, 0, 1}));
}

TEST_F(GltfMesh, NormalsGoByTheInverseTranspose) {
  const float s = std::sqrt(0.5f);
  const int p = g.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0}), n = g.vec3({s, s, 0, s, s, 0, s, s, 0});
  g.mesh({{"POSITION", p}, {"NORMAL", n}});
  g.add("nodes", {{"mesh", 0}, {"scale", {2, 1, 1}}});
  // (s / 2, s) made unit: (1, 2) / sqrt(5)
  EXPECT_THAT(xyz(open(g).scene().static_geometry.normals[0]), near({0.4472136f, 0.8944272f, 0}));
}

TEST_F(GltfMesh, InstancesAreCopiesInTheirPlaces) {
  g.triangle();
  g.j["nodes"] = {{{"children", {1, 2}}, {"translation", {10, 0, 0}}},
                  {{"mesh", 0}, {"translation", {0, 1, 0}}},
                  {{"mesh", 0}, {"matrix", {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 5, 1}}}};
  EXPECT_THAT(corners(open(g).scene().static_geometry),
              near({10, 1, 0, 11, 1, 0, 10, 2, 0, 10, 0, 5, 12, 0, 5, 10, 2, 5}));
}

TEST_F(GltfMesh, NodesOutsideTheSceneAreNotShown) {
  g.triangle();
  g.j["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}}};
  EXPECT_EQ(open(g).scene().static_geometry.triangle_count(), 1u);
}

TEST_F(GltfMesh, GlbHasTheSameTriangles) {
  g.triangle();
  g.add("nodes", {{"mesh", 0}});
  EXPECT_THAT(corners(open(folder.write("scene.glb", g.glb())).scene().static_geometry),
              near({0, 0, 0, 1, 0, 0, 0, 1, 0}, 0));
}

TEST_F(GltfMesh, ExternalBuffersComeFromTheSceneFolder) {
  g.triangle();
  g.add("nodes", {{"mesh", 0}});
  folder.write("data/my buffer.bin", g.data);
  g.j["buffers"] = {{{"byteLength", g.data.size()}, {"uri", "data/my%20buffer.bin"}}};
  EXPECT_EQ(open(g).scene().static_geometry.triangle_count(), 1u);
}

TEST_F(GltfMesh, TextureCoordinatesOfTheSetAndTransformThatTheMaterialNames) {
  g.add("images", {{"uri", "data:image/png;base64," + base64(png_2x1())}});
  g.add("textures", {{"source", 0}});
  const Json transform = {{"offset", {0.5, 0.25}}, {"rotation", M_PI / 2}, {"scale", {2, 3}}};
  g.add("materials", {{"pbrMetallicRoughness",
                       {{"baseColorTexture",
                         {{"index", 0}, {"texCoord", 1}, {"extensions", {{"KHR_texture_transform", transform}}}}}}}});
  const int p = g.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0}), zero = g.vec2({9, 9, 9, 9, 9, 9}),
            one = g.vec2({0, 0, 1, 0, 0, 1});
  const auto& mesh = only({{"POSITION", p}, {"TEXCOORD_0", zero}, {"TEXCOORD_1", one}}, {{"material", 0}});
  // u' = cos * 2u + sin * 3v + 0.5, v' = -sin * 2u + cos * 3v + 0.25
  EXPECT_NEAR(mesh.uvs[0].x, 0.5, 1e-6);
  EXPECT_NEAR(mesh.uvs[0].y, 0.25, 1e-6);
  EXPECT_NEAR(mesh.uvs[1].x, 0.5, 1e-6);
  EXPECT_NEAR(mesh.uvs[1].y, -1.75, 1e-6);
  EXPECT_NEAR(mesh.uvs[2].x, 3.5, 1e-6);
  EXPECT_NEAR(mesh.uvs[2].y, 0.25, 1e-6);
}

}  // namespace
}  // namespace artu::sim::test
