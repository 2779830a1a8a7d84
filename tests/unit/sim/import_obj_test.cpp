#include <cmath>

#include "sim/import/obj_file.h"
#include "unit/sim/import_fixture.h"

namespace artu::sim::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Obj : public ImportTest {
 protected:
  const traces::Mesh& mesh(const std::string& text) {
    return open(folder.write("scene.obj", text)).scene().static_geometry;
  }
};

const char square[] = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(Obj, QuadsBecomeTwoTriangles) {
  const auto& m = mesh(std::string(square) + "f 1 2 3 4\n");
  EXPECT_EQ(m.triangle_count(), 2u);
  EXPECT_EQ(m.positions.size(), 4u) << "equal corners are one vertex";
  EXPECT_THAT(xyz(m.normals[0]), near({0, 0, 1})) << "normals are made where there are none";
}

TEST_F(Obj, NegativeIndicesCountFromTheEnd) {
  EXPECT_THAT(corners(mesh(std::string(square) + "f -4 -3 -2\n")), near({0, 0, 0, 1, 0, 0, 1, 1, 0}));
}

TEST_F(Obj, AMissingMtlIsALogLine) {
  mesh("mtllib none.mtl\nusemtl x\n" + std::string(square) + "f 1 2 3\n");
  EXPECT_THAT(log, Contains(HasSubstr("file \"none.mtl\" cannot be read")));
  EXPECT_EQ(source->scene().materials.size(), 1u);
}

TEST_F(Obj, MaterialsAreMapped) {
  folder.write("m.mtl",
               "newmtl shiny\nKd 0.5 0.25 0\nKs 0.6 0.6 0.6\nNs 64\nillum 3\nKe 1 2 3\n"
               "newmtl glass\nKd 1 1 1\nd 0.25\nNi 1.5\nillum 7\n"
               "newmtl matt\nKd 0.1 0.2 0.3\nKs 1 1 1\nillum 1\n");
  const auto& m = mesh("mtllib m.mtl\n" + std::string(square) + "usemtl glass\nf 1 2 3\nusemtl shiny\nf 1 3 4\n");
  const auto& materials = source->scene().materials;
  ASSERT_EQ(materials.size(), 4u);
  EXPECT_EQ(materials[0].name, "shiny");
  EXPECT_THAT(xyz(materials[0].diffuse), near({0.5, 0.25, 0}));
  EXPECT_THAT(xyz(materials[0].mirror), near({0.6, 0.6, 0.6}));
  EXPECT_EQ(materials[0].specular_log2, 6u);
  EXPECT_THAT(xyz(materials[0].emission), near({1, 2, 3}));
  EXPECT_THAT(xyz(materials[1].transmission), near({0.75, 0.75, 0.75}));
  EXPECT_THAT(xyz(materials[1].diffuse), near({0.25, 0.25, 0.25}));
  EXPECT_FLOAT_EQ(materials[1].ior, 1.5f);
  EXPECT_THAT(xyz(materials[2].specular), near({0, 0, 0})) << "illum 1 has no highlight";
  EXPECT_THAT(m.materials, ElementsAre(0u, 1u));
}

TEST_F(Obj, TexturesAndTheirCoordinates) {
  folder.write("maps/a.png", png_2x1());
  folder.write("m.mtl", "newmtl t\nKd 0 0 0\nmap_Kd maps\\a.png\n");
  const auto& m = mesh("mtllib m.mtl\nvt 0.25 0.75\n" + std::string(square) + "usemtl t\nf 1/1 2/1 3/1\n");
  EXPECT_EQ(source->scene().materials[0].texture, 0);
  EXPECT_THAT(xyz(source->scene().materials[0].diffuse), near({1, 1, 1}));
  EXPECT_FLOAT_EQ(m.uvs[0].x, 0.25f);
  EXPECT_FLOAT_EQ(m.uvs[0].y, 0.25f) << "v counts from the bottom in OBJ, from the top in the unit";
}

TEST_F(Obj, TexturesOutsideTheFolderAreRefused) {
  folder.write("m.mtl", "newmtl t\nmap_Kd ../a.png\n");
  EXPECT_THAT(error_of(folder.write("scene.obj", "mtllib m.mtl\n" + std::string(square) + "f 1 2 3\n")),
              HasSubstr("material \"t\": \"../a.png\" leaves the scene's folder"));
}

TEST_F(Obj, IndicesOutOfRange) {
  EXPECT_THAT(error_of(folder.write("scene.obj", std::string(square) + "f 1 2 5\n")),
              HasSubstr("a face uses vertex 5 of 4"));
  EXPECT_THAT(error_of(folder.write("scene.obj", std::string(square) + "f 1//1 2//1 3//1\n")),
              HasSubstr("normal 1 of 0"));
}

TEST_F(Obj, NumbersThatAreNone) {
  const auto refused = [&](const std::string& line) {
    return error_of(folder.write("scene.obj", std::string(square) + line + "\nf 1 2 3\n"));
  };
  for (const char* word : {"nan", "inf", "-inf", "1e999", "x", "1.5y", "0x10"}) {
    EXPECT_THAT(refused(std::string("v 1 ") + word + " 0"), HasSubstr("scene.obj:5: ")) << word;
    EXPECT_THAT(refused(std::string("vn 0 0 ") + word), HasSubstr("a finite number would be right")) << word;
    EXPECT_THAT(refused(std::string("vt ") + word), HasSubstr("a finite number would be right")) << word;
  }
  EXPECT_THAT(refused("v 1 2"), HasSubstr("\"v\" with 2 numbers; at least 3"));
  EXPECT_THAT(refused("vt"), HasSubstr("at least 1"));
  // What is unusual and fine: a fourth coordinate, colours, tabs, signs, exponents, comments, carriage returns.
  mesh("v\t+0 0. -0e0 1\r\nv 1 .0 0 0.5 0.5 0.5 # corner\n  v 0 1e0 1e-999\r\nf 1 2 3\n");
}

TEST_F(Obj, WithoutFaces) { EXPECT_THAT(error_of(folder.write("scene.obj", square)), HasSubstr("has no face")); }

TEST(CreaseNormals, SmoothOverSmallBendsAndBreakAtSharpOnes) {
  // Three faces around the edge from vertex 0 to 1: the second bends 45 degrees from the first, the third 90.
  const float s = std::sqrt(0.5f);
  const std::vector<glm::vec3> p = {{0, 0, 0}, {0, 0, -1}, {-1, 0, 0}, {s, -s, 0}, {0, -1, 0}};
  const auto n = crease_normals(p, {0, 1, 2, 0, 3, 1});
  const float half = std::sin(static_cast<float>(M_PI) / 8), most = std::cos(static_cast<float>(M_PI) / 8);
  EXPECT_NEAR(n[0].x, half, 1e-6);
  EXPECT_NEAR(n[0].y, most, 1e-6);
  EXPECT_EQ(n[2], glm::vec3(0, 1, 0)) << "a vertex of one face has its normal";
  const auto sharp = crease_normals(p, {0, 1, 2, 0, 4, 1});
  EXPECT_EQ(sharp[0], glm::vec3(0, 1, 0));
  EXPECT_EQ(sharp[3], glm::vec3(1, 0, 0));
}

TEST(CreaseNormals, OfAHugeFanAreItsAverageAndLinearInItsSize) {
  // A million faces at the same three vertices: quadratic work would take hours.
  const std::vector<glm::vec3> p = {{0, 0, 0}, {0, 0, -1}, {-1, 0, 0}};
  std::vector<std::uint32_t> indices;
  for (int i = 0; i < 1000000; ++i) indices.insert(indices.end(), {0, 1, 2});
  const auto n = crease_normals(p, indices);
  EXPECT_EQ(n.front(), glm::vec3(0, 1, 0));
  EXPECT_EQ(n.back(), glm::vec3(0, 1, 0));
}

}  // namespace
}  // namespace artu::sim::test
