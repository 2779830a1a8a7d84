// zstd frames that lie, or that are valid but not what a trace is made of.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "traces/trace.h"
#include "unit/traces/support.h"

namespace artu::traces::test {
namespace {

using testing::HasSubstr;

std::vector<Raw> sample_frames() {
  std::vector<Raw> frames;
  for (const Raw& chunk : chunks_of(sample_scene(1), {sample_frame(0)})) frames.push_back(compressed(chunk));
  return frames;
}

/// The sample with its frame `number` replaced.
std::string refusal_with(std::size_t number, const Raw& frame) {
  const std::vector<Raw> frames = sample_frames();
  Raw file;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Raw& f = i == number ? frame : frames[i];
    file.insert(file.end(), f.begin(), f.end());
  }
  return refusal(file);
}

Raw first_chunk() { return chunks_of(sample_scene(1), {}).front(); }

TEST(HostileZstd, WithoutChecksum) {
  EXPECT_THAT(refusal_with(0, compressed(first_chunk(), {false, true})),
              HasSubstr("chunk 0 (at byte 0): has no checksum"));
}

TEST(HostileZstd, WithoutContentSize) {
  EXPECT_THAT(refusal_with(0, compressed(first_chunk(), {true, false})),
              HasSubstr("does not declare its decompressed"));
}

TEST(HostileZstd, SkippableFrame) {
  EXPECT_THAT(refusal_with(1, {0x50, 0x2A, 0x4D, 0x18, 0, 0, 0, 0}), HasSubstr("no zstd frame begins here"));
}

TEST(HostileZstd, ReservedBitAndDictionary) {
  Raw frame = sample_frames()[0];
  frame[4] ^= 0x08;
  EXPECT_THAT(refusal_with(0, frame), HasSubstr("a reserved bit"));
  frame[4] ^= 0x08 ^ 0x01;
  EXPECT_THAT(refusal_with(0, frame), HasSubstr("needs a zstd dictionary"));
}

/// One frame with an 8-byte content size and the blocks given.
Raw frame_of(std::uint64_t content_size, const std::vector<Raw>& blocks, bool single_segment = true) {
  Raw frame{0x28, 0xB5, 0x2F, 0xFD, static_cast<std::uint8_t>(single_segment ? 0xE4 : 0xC4)};
  if (!single_segment) frame.push_back(0xFF);  // the largest window
  for (int i = 0; i < 8; ++i) frame.push_back(static_cast<std::uint8_t>(content_size >> (8 * i)));
  for (const Raw& block : blocks) frame.insert(frame.end(), block.begin(), block.end());
  frame.insert(frame.end(), 4, 0);  // the checksum
  return frame;
}

Raw repeated_byte_block(std::uint32_t size, bool last) {
  const std::uint32_t header = size << 3 | 1 << 1 | static_cast<std::uint32_t>(last);
  return {static_cast<std::uint8_t>(header), static_cast<std::uint8_t>(header >> 8),
          static_cast<std::uint8_t>(header >> 16), 0};
}

TEST(HostileZstd, DeclaresMoreThanItsBlocksCanGive) {
  EXPECT_THAT(
      refusal_with(0, frame_of(1ull << 62, {repeated_byte_block(1000, true)})),
      HasSubstr("declares 4611686018427387904 bytes of content, but its compressed data can give at most 1000"));
}

TEST(HostileZstd, ABlockThatIsTooLarge) {
  EXPECT_THAT(refusal_with(0, frame_of(1 << 20, {repeated_byte_block(131073, true)})),
              HasSubstr("a zstd block has no valid header"));
}

TEST(HostileZstd, ABlockThatIsLargerThanTheWindow) {
  EXPECT_THAT(refusal_with(0, frame_of(500, {repeated_byte_block(501, true)})),
              HasSubstr("a zstd block has no valid header"));
}

TEST(HostileZstd, ABlockOfTheReservedKind) {
  EXPECT_THAT(refusal_with(0, frame_of(100, {{0x07, 0, 0}})), HasSubstr("a zstd block has no valid header"));
}

TEST(HostileZstd, ABombIsRefusedByTheSizeOfItsKind) {
  std::vector<Raw> blocks(16000, repeated_byte_block(131072, false));
  blocks.push_back(repeated_byte_block(131072, true));
  const Raw bomb = frame_of(16001ull * 131072, blocks);
  EXPECT_LT(bomb.size(), 65000u);
  EXPECT_THAT(refusal_with(0, bomb), HasSubstr("declares 2097283072 bytes of content; a header has at most 65536"));
  EXPECT_THAT(refusal_with(1, bomb), HasSubstr("the materials has at most 536870912"));
  EXPECT_THAT(refusal_with(2, bomb), HasSubstr("texture 0 (of 2) has at most 1073807360"));
  EXPECT_THAT(refusal_with(4, bomb), HasSubstr("of the static geometry has at most 54591488"));
  EXPECT_THAT(refusal_with(5, bomb), HasSubstr("frame 0 (of 1) has at most 65536"));
  EXPECT_THAT(refusal_with(6, bomb), HasSubstr("of frame 0's dynamic geometry has at most 54591488"));
}

TEST(HostileZstd, ManyTexturesOfTheLargestSizeAreRefusedTogether) {
  Scene scene = sample_scene(1);
  scene.textures.resize(17);
  const std::vector<Raw> sample = chunks_of(scene, {});
  std::vector<Raw> blocks(8191, repeated_byte_block(131072, false));
  blocks.push_back(repeated_byte_block(131072, true));
  const Raw texture = frame_of(1ull << 30, blocks);
  Raw file = compressed(sample[0]);
  const Raw materials = compressed(sample[1]), part = compressed(sample.back());
  file.insert(file.end(), materials.begin(), materials.end());
  for (int i = 0; i < 17; ++i) file.insert(file.end(), texture.begin(), texture.end());
  file.insert(file.end(), part.begin(), part.end());
  EXPECT_THAT(refusal(file), HasSubstr("this program reads at most 17179869184"));
}

TEST(HostileZstd, AContentThatIsShorterOrLongerThanDeclared) {
  // The declared size is a lie that the blocks' headers allow.
  EXPECT_THAT(refusal_with(0, frame_of(500, {repeated_byte_block(400, false), repeated_byte_block(400, true)})),
              HasSubstr("chunk 0 (at byte 0): damaged (zstd)"));
  const Raw empty_compressed_block{0x05, 0, 0};
  EXPECT_THAT(refusal_with(0, frame_of(500, {empty_compressed_block})), HasSubstr("damaged (zstd)"));
}

TEST(HostileZstd, AWindowThatNeedsMuchMemory) {
  EXPECT_THAT(refusal_with(0, frame_of(1000, {repeated_byte_block(1000, true)}, false)), HasSubstr("damaged (zstd)"));
}

TEST(HostileZstd, AnEmptyFrame) { EXPECT_THAT(refusal_with(0, compressed({})), HasSubstr("is not a trace's")); }

TEST(HostileZstd, BytesAfterTheEnd) {
  Raw file;
  for (const Raw& frame : sample_frames()) file.insert(file.end(), frame.begin(), frame.end());
  file.push_back(0);
  EXPECT_THAT(refusal(file), HasSubstr("1 bytes follow the last of 1 frames; the file must end here"));
}

TEST(Reader, RefusesWhatIsNotAFile) {
  const TempFolder folder;
  EXPECT_THAT(message_of([&] { Reader(folder / "absent"); }),
              HasSubstr("absent: cannot open the file: No such file or directory"));
  EXPECT_THAT(message_of([&] { Reader(folder / "."); }), HasSubstr("is not a regular file"));
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(message_of([&] { Reader(folder / "pipe"); }), HasSubstr("is not a regular file"));
}

}  // namespace
}  // namespace artu::traces::test
