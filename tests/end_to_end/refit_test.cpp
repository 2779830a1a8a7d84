// With refit a frame takes its nodes from another one, which the program finds: in a scene, and in a trace.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using nlohmann::json;

class RefitTest : public ProgramTest {
 protected:
  /// A strip of triangles that turns.
  RefitTest() {
    std::string strip;
    for (int i = 0; i < 42; ++i) {
      strip += "v " + std::to_string(i * 0.1) + " " + std::to_string(i % 2) + " " + std::to_string(i % 5 * 0.1) + "\n";
    }
    for (int i = 1; i <= 40; ++i) {
      strip += "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) + "\n";
    }
    write("strip.obj", strip);
    write("scene.stage.toml",
          "duration = 1\n[[file]]\npath = \"strip.obj\"\n[[file.key]]\ntime = 0\nrotation = [0, 0, 0]\n"
          "[[file.key]]\ntime = 1\nrotation = [0, 170, 90]\n");
  }

  json frames(const std::string& input, const std::string& range, std::vector<std::string> more = {}) const {
    std::vector<std::string> args{"run",      input,
                                  "--frames", range,
                                  "-o",       "out",
                                  "--force",  "--quiet",
                                  "--set",    "tree_builder.refit=true",
                                  "--set",    "tree_builder.refit_interval=4"};
    args.insert(args.end(), more.begin(), more.end());
    fine(args);
    return json::parse(read("out/stats.json")).at("frames");
  }
  static const std::vector<std::string> size;
};
const std::vector<std::string> RefitTest::size{"--size", "24x16"};

TEST_F(RefitTest, AFrameOfASceneAloneIsAsInItsSequence) {
  const json all = frames("scene.stage.toml", "0:7", size);
  for (const int index : {6, 4, 3}) {
    EXPECT_EQ(frames("scene.stage.toml", std::to_string(index), size).at(0), all.at(static_cast<std::size_t>(index)));
  }
  EXPECT_EQ(all.at(4).at("blocks").at("tree_builder").at("builds"), 1);
  EXPECT_EQ(all.at(6).at("blocks").at("tree_builder").at("refits"), 1);
  EXPECT_EQ(all.at(6).at("tree").at("references"), 40);
}

TEST_F(RefitTest, ATraceThatBeginsWithABaseIsRunLikeItsScene) {
  fine({"import", "scene.stage.toml", "--size", "24x16", "--frames", "4:7", "-o", "whole.trace", "--quiet"});
  EXPECT_EQ(frames("whole.trace", "4:7"), frames("scene.stage.toml", "4:7", size));
  EXPECT_EQ(frames("whole.trace", "6").at(0), frames("scene.stage.toml", "6", size).at(0));
}

TEST_F(RefitTest, ATraceThatBeginsLaterHasItsFirstFrameAsABase) {
  fine({"import", "scene.stage.toml", "--size", "24x16", "--frames", "1:7", "-o", "late.trace", "--quiet"});
  const json all = frames("late.trace", "1:7");
  EXPECT_EQ(all.at(0).at("blocks").at("tree_builder").at("builds"), 1);
  EXPECT_EQ(all.at(1).at("blocks").at("tree_builder").at("refits"), 1);
  EXPECT_EQ(frames("late.trace", "3").at(0), all.at(2));
}

TEST_F(RefitTest, PrecisionRefusesKdTreesWithIt) {
  EXPECT_THAT(refused({"precision", "scene.stage.toml", "--set", "tree_builder.refit=true"}),
              ::testing::HasSubstr("tree_builder.refit = true does not go with accel.dynamic.kind = kd"));
}

}  // namespace
}  // namespace artu::test
