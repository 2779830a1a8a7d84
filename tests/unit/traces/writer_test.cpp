#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <filesystem>

#include "traces/trace.h"
#include "unit/traces/support.h"

namespace artu::traces::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(Writer, TheNameAppearsOnlyAtClose) {
  const TempFolder folder;
  Writer writer(folder / "t", sample_scene(1));
  writer.add(sample_frame(0));
  EXPECT_TRUE(fs::exists(folder / "t.partial"));
  EXPECT_FALSE(fs::exists(folder / "t"));
  writer.close();
  EXPECT_FALSE(fs::exists(folder / "t.partial"));
  EXPECT_TRUE(fs::exists(folder / "t"));
  writer.close();  // again: nothing happens
  EXPECT_NE(message_of([&] { writer.add(sample_frame(1)); }), "");
}

TEST(Writer, WithoutCloseNothingIsLeftAndTheOldFileStays) {
  const TempFolder folder;
  write_file(folder / "t", {1, 2, 3});
  {
    Writer writer(folder / "t", sample_scene(2));
    writer.add(sample_frame(0));
  }
  EXPECT_FALSE(fs::exists(folder / "t.partial"));
  EXPECT_EQ(read_file(folder / "t"), (Raw{1, 2, 3}));
}

TEST(Writer, ReplacesAnOldFileAndAnOldPartialFile) {
  const TempFolder folder;
  write_file(folder / "t", {1, 2, 3});
  write_file(folder / "t.partial", Raw(100000));
  write_trace(folder / "t", sample_scene(1), {sample_frame(0)});
  EXPECT_EQ(message_of([&] { read_all(folder / "t"); }), "");
}

TEST(Writer, RefusesAFileThatIsBeingWritten) {
  const TempFolder folder;
  Writer first(folder / "t", sample_scene(1));
  EXPECT_THAT(message_of([&] { Writer(folder / "t", sample_scene(2)); }),
              HasSubstr("t.partial: another process writes it"));
  first.add(sample_frame(0));
  first.close();
  EXPECT_EQ(message_of([&] { read_all(folder / "t"); }), "");
}

TEST(Writer, RefusesTooFewFrames) {
  const TempFolder folder;
  Writer writer(folder / "t", sample_scene(2));
  writer.add(sample_frame(0));
  EXPECT_THAT(message_of([&] { writer.close(); }), HasSubstr("t: has 1 frames; its scene's frame_count is 2"));
  writer.add(sample_frame(1));  // can be put right
  writer.close();
}

TEST(Writer, RefusesTooManyFrames) {
  const TempFolder folder;
  Writer writer(folder / "t", sample_scene(1));
  writer.add(sample_frame(0));
  EXPECT_THAT(message_of([&] { writer.add(sample_frame(1)); }), HasSubstr("frame 1: is one too many"));
}

TEST(Writer, RefusesNoFrames) {
  const TempFolder folder;
  EXPECT_THAT(message_of([&] { Writer(folder / "t", sample_scene(0)); }), HasSubstr("frame_count is 0"));
}

TEST(Writer, ValidatesTheSceneBeforeItCreatesAFile) {
  const TempFolder folder;
  Scene scene = sample_scene(1);
  scene.static_geometry.indices[4] = 7;
  EXPECT_THAT(message_of([&] { Writer(folder / "t", scene); }), HasSubstr("static geometry: indices[4] is 7"));
  EXPECT_FALSE(fs::exists(folder / "t.partial"));
}

TEST(Writer, ValidatesFrames) {
  const TempFolder folder;
  Writer writer(folder / "t", sample_scene(1));
  Frame frame = sample_frame(0);
  frame.dynamic.materials[1] = 2;
  EXPECT_THAT(message_of([&] { writer.add(frame); }), HasSubstr("frame 0: dynamic geometry: materials[1] is 2"));
  writer.add(sample_frame(0));  // nothing of the refused frame was written
  writer.close();
  expect_same(Reader(folder / "t").frame(0), sample_frame(0));
}

TEST(Writer, HoldsDynamicMovedToItsWord) {
  const TempFolder folder;
  Writer writer(folder / "t", sample_scene(2));
  writer.add(sample_frame(0));
  Frame frame = sample_frame(0);
  frame.dynamic_moved = false;
  frame.dynamic.colors[0] ^= 1;
  EXPECT_THAT(message_of([&] { writer.add(frame); }), HasSubstr("frame 1: dynamic_moved is false, but"));
}

TEST(Writer, RefusesAFolderThatDoesNotExist) {
  const TempFolder folder;
  EXPECT_THAT(message_of([&] { Writer(folder / "no/t", sample_scene(1)); }),
              HasSubstr("no/t.partial: cannot create the file: No such file or directory"));
}

TEST(Writer, RefusesAFolderThatIsReadOnly) {
  if (::geteuid() == 0) GTEST_SKIP() << "nothing is read-only to root";
  const TempFolder folder;
  fs::create_directory(folder / "d");
  fs::permissions(folder / "d", fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THAT(message_of([&] { Writer(folder / "d/t", sample_scene(1)); }), HasSubstr("Permission denied"));
  fs::permissions(folder / "d", fs::perms::owner_all);
}

TEST(Writer, RefusesANameThatIsAFolder) {
  const TempFolder folder;
  fs::create_directories(folder / "t/inside");
  Writer writer(folder / "t", sample_scene(1));
  writer.add(sample_frame(0));
  EXPECT_THAT(message_of([&] { writer.close(); }), HasSubstr("t.partial: cannot rename the file to"));
}

TEST(Writer, AFullDiskIsAnErrorAndNotATrace) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  const TempFolder folder;
  fs::create_symlink("/dev/full", folder / "t.partial");
  EXPECT_THAT(message_of([&] { Writer(folder / "t", sample_scene(1)); }),
              HasSubstr("t.partial: cannot write the file: No space left on device"));
  EXPECT_FALSE(fs::exists(folder / "t"));
  EXPECT_FALSE(fs::is_symlink(folder / "t.partial"));
}

TEST(Writer, AfterAFailedWriteTheTraceCannotBeClosed) {
  const TempFolder folder;
  Frame frame = sample_frame(0);
  frame.dynamic = sample_mesh(100000, 1, 1);
  Writer writer(folder / "t", sample_scene(1));
  rlimit old{};
  ::getrlimit(RLIMIT_FSIZE, &old);
  const auto old_handler = ::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{65536, old.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);
  const std::string message = message_of([&] { writer.add(frame); });
  ::setrlimit(RLIMIT_FSIZE, &old);
  ::signal(SIGXFSZ, old_handler);
  EXPECT_THAT(message, HasSubstr("t.partial: cannot write the file: File too large"));
  EXPECT_THAT(message_of([&] { writer.add(frame); }), HasSubstr("an earlier write failed"));
  EXPECT_THAT(message_of([&] { writer.close(); }), HasSubstr("an earlier write failed"));
}

}  // namespace
}  // namespace artu::traces::test
