// The example of a virtual platform: every sample trace over TLM alone, against the golden model.
#include <gmock/gmock.h>

#include <algorithm>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using ::testing::HasSubstr;

class PlatformTest : public ProgramTest {};

TEST_F(PlatformTest, EverySampleComesBackOverTlmAsTheGoldenModelSays) {
  int traces = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(ARTU_SOURCE_DIR) + "/traces/samples")) {
    if (entry.path().extension() != ".artu") continue;
    const std::string picture = entry.path().stem().string() + ".png";
    const Finished first = program(ARTU_PLATFORM_BINARY, {entry.path().string(), picture});
    EXPECT_EQ(first.code, 0) << first.out << first.err;
    EXPECT_THAT(first.out, HasSubstr(" 0 differing"));
    const Finished again = program(ARTU_PLATFORM_BINARY, {entry.path().string(), "again.png"});
    EXPECT_EQ(again.out, first.out) << "the same cycles and lines";
    EXPECT_TRUE(read("again.png") == read(picture));
    std::filesystem::remove(path("again.png"));
    // The built-in DRAM gives the same picture.
    fine({"run", entry.path().string(), "-o", "built_in", "--force", "--quiet"});
    const std::vector<std::string> names = content("built_in");
    const auto frame = std::find_if(names.begin(), names.end(),
                                    [](const std::string& name) { return name.compare(0, 6, "frame_") == 0; });
    ASSERT_NE(frame, names.end());
    EXPECT_TRUE(read("built_in/" + *frame) == read(picture)) << entry.path();
    ++traces;
  }
  EXPECT_GT(traces, 0);
}

TEST_F(PlatformTest, BadInputIsRefused) {
  EXPECT_EQ(program(ARTU_PLATFORM_BINARY, {}).code, 2);
  EXPECT_EQ(program(ARTU_PLATFORM_BINARY, {"none.artu", "a.png"}).code, 2);
  write("old.png", "precious");
  const std::string sample = std::string(ARTU_SOURCE_DIR) + "/traces/samples/scene.artu";
  EXPECT_EQ(program(ARTU_PLATFORM_BINARY, {sample, "old.png"}).code, 2);
  EXPECT_EQ(read("old.png"), "precious");
}

}  // namespace
}  // namespace artu::test
