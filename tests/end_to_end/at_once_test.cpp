// Several programs at once that want the same place: one has it, the others are refused, and nothing is mixed.
#include <gmock/gmock.h>

#include <csignal>
#include <filesystem>

#include "end_to_end/program.h"

namespace artu::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class AtOnceTest : public ProgramTest {
 protected:
  AtOnceTest() { write_scene("tiny.obj"); }

  /// `first` runs in the background; once there is `file`, so does `second`; then the first is killed, so that what it
  /// has begun stays.  What the second says is on stderr.
  Finished second_of(const std::string& first, const std::string& file, const std::string& second) const {
    return program("/bin/sh",
                   {"-c", "artu='" ARTU_BINARY "'; \"$artu\" " + first + " >/dev/null 2>&1 & until test -e " + file +
                              " || ! kill -0 $!; do sleep 0.01; done; \"$artu\" " + second +
                              "; code=$?; kill -9 $!; wait $! 2>/dev/null; exit $code"});
  }
};

TEST_F(AtOnceTest, ATraceIsWrittenByOne) {
  const Finished second = second_of("import tiny.obj --size 64x64 --frames 0:1000000 -o t.artu", "t.artu.partial",
                                    "import tiny.obj --size 32x32 -o t.artu");
  EXPECT_EQ(second.code, 2);
  EXPECT_THAT(second.err, AllOf(StartsWith("error: "), HasSubstr("t.artu.partial: another process writes it"),
                                HasSubstr("would be right")));
  // What a killed one has left is in nobody's way.
  EXPECT_THAT(content(), ElementsAre("t.artu.partial", "tiny.obj"));
  fine({"import", "tiny.obj", "--size", "32x32", "-o", "t.artu"});
  EXPECT_THAT(content(), ElementsAre("t.artu", "tiny.obj"));
  fine({"run", "t.artu", "--dry-run"});
}

TEST_F(AtOnceTest, AFileIsWrittenByOne) {
  const Finished second = second_of("run tiny.obj --size 64x36 --frames 0:1000000 -o a --dump-pixels p.csv",
                                    "p.csv.partial", "run tiny.obj --size 8x8 -o b --dump-pixels p.csv");
  EXPECT_EQ(second.code, 2);
  EXPECT_THAT(second.err, AllOf(HasSubstr("p.csv.partial: another process writes it"), HasSubstr("would be right")));
  EXPECT_FALSE(exists("b"));
}

TEST_F(AtOnceTest, ForceDoesNotTakeAFolderThatIsBeingWritten) {
  fine({"run", "tiny.obj", "--size", "8x8", "-o", "out"});
  const auto files = content("out");
  const Finished second = second_of("run tiny.obj --size 64x36 --frames 0:1000000 -o out --force", "out.partial",
                                    "run tiny.obj --size 8x8 -o out --force");
  EXPECT_EQ(second.code, 2);
  EXPECT_THAT(second.err, AllOf(StartsWith("error: "), HasSubstr("out.partial: another run writes it"),
                                HasSubstr("would be right")));
  EXPECT_EQ(content("out"), files);
  fine({"run", "tiny.obj", "--size", "8x8", "-o", "out", "--force"});
  EXPECT_THAT(content(), ElementsAre("out", "tiny.obj"));
}

/// The old folder has gone by another name in the meantime; one of the user's is not in the way.
TEST_F(AtOnceTest, ForceReplacesBesideAFolderOfASimilarName) {
  fine({"run", "tiny.obj", "--size", "8x8", "-o", "out"});
  std::filesystem::create_directory(path("out.replaced"));
  write("out.replaced/mine", "");
  fine({"run", "tiny.obj", "--size", "9x9", "-o", "out", "--force"});
  EXPECT_THAT(read("out/manifest.json"), HasSubstr("\"width\": 9"));
  EXPECT_THAT(content("out.replaced"), ElementsAre("mine"));
  EXPECT_THAT(content(), ElementsAre("out", "out.replaced", "tiny.obj"));
}

TEST_F(AtOnceTest, ResumeLeavesWhatAPartIsAtWorkOn) {
  write("grid.toml", "scenes = [\"tiny.obj\"]\nsize = \"8x8\"\n[grid]\ncore.count = [1, 2]\n");
  fine({"sweep", "grid.toml", "-o", "s"});
  for (const std::string& point : content("s/points")) std::filesystem::remove_all(path("s/points/" + point));
  // A part that is alive, and one that was killed.
  std::filesystem::create_directories(path("s/points.partial/alive"));
  std::filesystem::create_directories(path("s/points.partial/dead"));
  const auto beside = [&](const std::string& last) {
    return program(
        "/bin/sh",
        {"-c", "exec 9<s/points.partial/alive; flock -n 9; '" ARTU_BINARY "' sweep grid.toml -o s --quiet " + last});
  };
  const Finished force = beside("--force");
  EXPECT_EQ(force.code, 2);
  EXPECT_THAT(force.err, AllOf(HasSubstr("s: another artu sweep --part works on it"), HasSubstr("would be right")));
  EXPECT_THAT(content("s/points.partial"), ElementsAre("alive", "dead"));
  EXPECT_EQ(beside("--resume").code, 0);
  EXPECT_THAT(content("s/points.partial"), ElementsAre("alive"));
  EXPECT_EQ(content("s/points").size(), 2u);
  fine({"sweep", "grid.toml", "-o", "s", "--resume"});
  EXPECT_FALSE(exists("s/points.partial"));
}

/// A gnuplot that would never end.
TEST_F(AtOnceTest, AnInterruptionEndsGnuplot) {
  std::filesystem::create_directory(path("bin"));
  write("bin/gnuplot", "#!/bin/sh\necho $$ >../pid.new; mv ../pid.new ../pid; exec sleep 1000\n");
  std::filesystem::permissions(path("bin/gnuplot"), std::filesystem::perms::owner_all);
  const Finished run = program(
      "/bin/sh",
      {"-c", "PATH=$PWD/bin:$PATH '" ARTU_BINARY "' scaling tiny.obj --size 8x8 --vary core.count=1,2 --quiet -o out & "
             "until test -e pid || ! kill -0 $!; do sleep 0.01; done; kill -TERM $!; wait $!; code=$?; "
             "kill -0 $(cat pid) 2>/dev/null && echo alive; exit $code"});
  EXPECT_EQ(run.code, 128 + SIGTERM);
  EXPECT_THAT(run.out, IsEmpty());
  EXPECT_THAT(content(), ElementsAre("bin", "pid", "tiny.obj"));
}

}  // namespace
}  // namespace artu::test
