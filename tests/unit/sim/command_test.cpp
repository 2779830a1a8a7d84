// Option values that the commands parse themselves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

#include "sim/command/commands.h"
#include "sim/command/ranges.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

using ::testing::HasSubstr;

template <class Parse>
std::string error_of(Parse parse) {
  try {
    parse();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Frames, AreAHalfOpenRangeOrOneFrameOrAll) {
  EXPECT_EQ(parse_frames("2:7")->first, 2u);
  EXPECT_EQ(parse_frames("2:7")->last, 7u);
  EXPECT_EQ(parse_frames("5")->count(), 1u);
  EXPECT_EQ(parse_frames("5")->first, 5u);
  EXPECT_FALSE(parse_frames("all"));
}

TEST(Frames, WhatIsNoRangeIsRefused) {
  for (const char* text : {"", ":", "1:", ":1", "a:b", "1:2:3", "-1:2", "1.5", " 1", "+1", "0x1"}) {
    EXPECT_THAT(error_of([&] { parse_frames(text); }), HasSubstr("is not a range")) << text;
  }
  for (const char* text : {"3:3", "4:3"}) {
    EXPECT_THAT(error_of([&] { parse_frames(text); }), HasSubstr("is empty")) << text;
  }
  for (const char* text : {"4294967295", "4294967296", "0:4294967296", "4294967295:4294967296"}) {
    EXPECT_EQ(error_of([&] { parse_frames(text); }),
              std::string("--frames: ") + text + " is out of range; frames of 0 ... 4294967294 would be right");
  }
  EXPECT_EQ(parse_frames("4294967294")->last, 4294967295u);
  EXPECT_EQ(parse_frames("1:4294967295")->last, 4294967295u);
}

TEST(Pictures, NoneStandsAlone) {
  EXPECT_EQ(error_of([] { parse_pictures("none"); }), "no error");
  for (const char* text : {"none,frame", "frame,none", "none,none"}) {
    EXPECT_THAT(error_of([&] { parse_pictures(text); }), HasSubstr("--pictures: none stands alone")) << text;
  }
}

TEST(Size, IsWidthByHeight) {
  EXPECT_EQ(parse_size("16384x1").width, 16384u);
  EXPECT_EQ(parse_size("16384x1").height, 1u);
  for (const char* text : {"", "x", "1x", "x1", "1", "1x1x1", "1*1", "-1x1"}) {
    EXPECT_THAT(error_of([&] { parse_size(text); }), HasSubstr("is not a size")) << text;
  }
  for (const char* text : {"0x1", "1x0", "16385x1", "1x4000000000", "99999999999999999999x5"}) {
    EXPECT_THAT(error_of([&] { parse_size(text); }), HasSubstr("is out of range")) << text;
  }
}

TEST(Seed, IsAnyUnsignedInteger) {
  EXPECT_EQ(parse_seed("18446744073709551615"), 18446744073709551615u);
  for (const char* text : {"", "-1", "1.5", "18446744073709551616", "x"}) {
    EXPECT_THAT(error_of([&] { parse_seed(text); }), HasSubstr("--seed")) << text;
  }
}

template <class Exception>
int code_of(const Exception& exception, std::string& line) {
  ::testing::internal::CaptureStderr();
  const int code = exit_code_of([&]() -> int { throw exception; });
  line = ::testing::internal::GetCapturedStderr();
  return code;
}

TEST(ExitCode, ControlCharactersOfAMessageAreShown) {
  std::string line;
  EXPECT_EQ(code_of(InputError(std::string("a\0b", 3), "\033[2J\t\x7f"), line), 2);
  EXPECT_EQ(line, "error: a\\x00b: \\x1b[2J\\x09\\x7f\n");
}

TEST(ExitCode, IsThatOfTheKindOfFailure) {
  std::string line;
  EXPECT_EQ(code_of(InputError("a.glb", "bad; good would be right"), line), 2);
  EXPECT_EQ(line, "error: a.glb: bad; good would be right\n");
  EXPECT_EQ(code_of(InputError("two\nlines.glb", "bad"), line), 2);
  EXPECT_EQ(line, "error: two lines.glb: bad\n");
  EXPECT_EQ(code_of(DeadLock("a waits for b"), line), 3);
  EXPECT_EQ(line, "error: dead-lock: a waits for b\n");
  EXPECT_EQ(code_of(std::logic_error("impossible"), line), 4);
  EXPECT_EQ(line, "error: internal: impossible\n");
  EXPECT_EQ(code_of(std::bad_alloc(), line), 2);
  const auto folder = std::make_error_code(std::errc::is_a_directory);
  EXPECT_EQ(code_of(std::filesystem::filesystem_error("file_size", "a.png", folder), line), 2);
  EXPECT_EQ(line, "error: a.png: Is a directory; a file or folder that can be used would be right\n");
  EXPECT_EQ(code_of(std::system_error(folder, "poll"), line), 4) << "not what could not be printed";
  EXPECT_EQ(line, "error: internal: poll: Is a directory\n");
  EXPECT_EQ(exit_code_of([] { return 1; }), 1);
}

}  // namespace
}  // namespace artu::sim
