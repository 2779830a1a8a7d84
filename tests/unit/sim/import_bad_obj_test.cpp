// OBJ files whose faces tinyobjloader would read as others.
#include "unit/sim/import_fixture.h"

namespace artu::sim::test {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

/// Five vertices, a texture coordinate and a normal, in seven lines.
const char corners_of_faces[] = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 2 0\nvt 0 0\nvn 0 0 1\n";

class BadObj : public ImportTest {
 protected:
  /// What a file is refused with whose eighth line is this.
  std::string refused(const std::string& line) {
    return error_of(folder.write("scene.obj", corners_of_faces + line + "\n"));
  }
  const traces::Mesh& mesh(const std::string& text) {
    return open(folder.write("scene.obj", text)).scene().static_geometry;
  }
};

TEST_F(BadObj, IndicesAreIntegers) {
  for (const char* word : {"1.5", "x",    "2x",  "0x1",  "1e0",   "--1",     "+-1",   "+",    "-", "1/", "1//", "/1",
                           "//1", "1/1/", "1/x", "1//x", "1/1/x", "1/1/1/1", "1///1", "1\\1", "#", "\\", "\""}) {
    const std::string what = refused(std::string("f 2 3 ") + word);
    EXPECT_THAT(what, AllOf(HasSubstr("scene.obj:8: "), HasSubstr(std::string("\"f ... ") + word + "\"")));
    EXPECT_THAT(what, HasSubstr("integers as in 1, 1/2, 1//3 or 1/2/3 would be right"));
    EXPECT_EQ(refused(std::string("f ") + word + " 2 3"), what) << "at every place of the line";
  }
}

TEST_F(BadObj, IndicesDoNotWrapAround) {
  for (const char* word : {"6", "4294967299", "99999999999999999999", "-6", "-4294967293", "-99999999999999999999", "0",
                           "-0", "2147483648", "18446744073709551617"}) {
    const std::string named = std::string("a face uses vertex ") + word + " of 5; 1 ... 5 would be right";
    EXPECT_THAT(refused(std::string("f 1 2 ") + word), HasSubstr("scene.obj:8: " + named));
    EXPECT_THAT(refused(std::string("f ") + word + "/1/1 2/1/1 3/1/1 4/1/1"), HasSubstr(named));
  }
  EXPECT_THAT(refused("f 1/1 2/4294967297 3/1"), HasSubstr("texture coordinate 4294967297 of 1; 1 ... 1"));
  EXPECT_THAT(refused("f 1//1 2//1 3//-4294967295"), HasSubstr("normal -4294967295 of 1; 1 ... 1"));
  // The normal behind the last one would be taken for one that was left out.
  EXPECT_THAT(refused("f 1//1 2//1 3//-2"), HasSubstr("normal -2 of 1"));
  EXPECT_THAT(error_of(folder.write("scene.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//1 2//1 3//1\n")),
              HasSubstr("scene.obj:4: a face uses normal 1 of 0; a file that has it would be right"));
}

TEST_F(BadObj, TheFaceIsNamedAndNotTheEndOfTheFile) {
  EXPECT_THAT(error_of(folder.write("scene.obj", "v 0 0 0\r\nv 1 0 0\r\n\r\nf 1 2 4\r\nv 0 1 0\r\n")),
              HasSubstr("scene.obj:4: a face uses vertex 4 of 3"));
}

TEST_F(BadObj, FacesHaveThreeCorners) {
  EXPECT_THAT(refused("f 1 2"), HasSubstr("scene.obj:8: a face of 2 corners; at least 3 would be right"));
  EXPECT_THAT(refused("f"), HasSubstr("a face of 0 corners"));
  EXPECT_THAT(refused("f 1 2 3\nf\t4\t\nf 1 2 3"), HasSubstr("scene.obj:9: a face of 1 corners"));
}

TEST_F(BadObj, ControlCharactersAreShown) {
  EXPECT_THAT(refused(std::string("f 1 2 3\0x", 9)), HasSubstr("\"f ... 3\\x00x\": integers"));
  EXPECT_THAT(refused("f 1 2 \033[31m3"), HasSubstr("\\x1b[31m3"));
}

/// What is unusual and fine.
TEST_F(BadObj, OtherWaysToWriteAFaceAreRead) {
  const std::string usual = std::string(corners_of_faces) + "f 1/1/1 2/1/1 3/1/1\n";
  const auto expected = corners(mesh(usual));
  for (const char* face : {"f +1/1/1 2/1/1 3/1/1", "  f  1/-1/-1\t-4/1/1 3/1/1 \t", "f 1 2 3", "f 1/1 2 3//1",
                           "f 01/01/01 2/1/1 3/1/1", "f 1 2 3\r", "g a b\nusemtl none\ns off\nf 1 2 3\nl 1 2\np 1"}) {
    EXPECT_EQ(corners(mesh(std::string(corners_of_faces) + face + "\n")), expected) << face;
  }
  EXPECT_EQ(corners(mesh("f 1 2 3\n" + std::string(corners_of_faces))), expected) << "before its corners";
  std::string old = usual;
  std::replace(old.begin(), old.end(), '\n', '\r');
  EXPECT_EQ(corners(mesh(old)), expected) << "carriage returns alone";
  EXPECT_EQ(mesh(std::string(corners_of_faces) + "f 1 2 3 4\nf 1 2 3 5 4\n").triangle_count(), 5u);
  EXPECT_THAT(log, Not(Contains(HasSubstr("lacks"))));
}

TEST_F(BadObj, AByteOrderMarkIsNoPartOfTheFirstLine) {
  EXPECT_EQ(corners(mesh("\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n")),
            (std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0}));
  EXPECT_THAT(error_of(folder.write("scene.obj", "\xef\xbb\xbfv 0 0 x\n")), HasSubstr("scene.obj:1: \"v ... x\""));
  folder.write("m.mtl", "\xef\xbb\xbfnewmtl a\nKd 1 0 0\n");
  mesh("\xef\xbb\xbfmtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl a\nf 1 2 3\n");
  EXPECT_EQ(source->scene().materials.at(0).name, "a");
}

/// tinyobjloader cuts a group's faces where the group ends, and leaves out those whose corners come later.
TEST_F(BadObj, FacesThatAreLeftOutAreNoted) {
  mesh(std::string(corners_of_faces) + "g a\nf 1 2 6 7\ng b\nf 1 2 3\nv 0 3 0\nv 0 4 0\n");
  EXPECT_THAT(log, Contains(HasSubstr("scene.obj: lacks 2 of 3 triangles: faces of more than three corners that ")));
}

}  // namespace
}  // namespace artu::sim::test
