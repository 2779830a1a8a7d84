// Damage without intent and with it, systematically: the reader refuses or gives what is valid.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "traces/trace.h"
#include "unit/traces/support.h"

namespace artu::traces::test {
namespace {

Scene small_scene() {
  Scene scene = sample_scene(2);
  scene.name = "s";
  return scene;
}

std::vector<Raw> small_chunks() { return chunks_of(small_scene(), {sample_frame(0), sample_frame(1)}); }

TEST(Corruption, TheSampleItselfIsFine) {
  const std::vector<Raw> chunks = small_chunks();
  ASSERT_EQ(chunks.size(), 2u + 2u + 1u + 2u * 2u);
  EXPECT_EQ(refusal(joined(chunks)), "");
}

TEST(Corruption, EveryByteOfTheFileFlipped) {
  const TempFolder folder;
  const Raw file = joined(small_chunks());
  for (std::size_t i = 0; i < file.size(); ++i) {
    for (const std::uint8_t flip : {0x01, 0x04, 0x20, 0x80, 0xFF}) {
      Raw damaged = file;
      damaged[i] ^= flip;
      if (!refusal(damaged).empty()) continue;
      // A bit that zstd does not look at: the checksums vouch for the content.
      write_file(folder / "t", damaged);
      const Reader reader(folder / "t");
      expect_same(reader.scene(), small_scene());
      expect_same(reader.frame(0), sample_frame(0));
      expect_same(reader.frame(1), sample_frame(1));
    }
  }
}

TEST(Corruption, TheFileCutOffAtEveryLength) {
  const Raw file = joined(small_chunks());
  for (std::size_t length = 0; length < file.size(); ++length) {
    EXPECT_NE(refusal(Raw(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(length))), "") << length;
  }
}

TEST(Corruption, EveryByteOfEveryFlatBufferChanged) {
  const std::vector<Raw> chunks = small_chunks();
  std::vector<Raw> frames;
  for (const Raw& chunk : chunks) frames.push_back(compressed(chunk));
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    for (std::size_t i = 0; i < chunks[c].size(); ++i) {
      for (const std::uint8_t flip : {0x01, 0x08, 0x80, 0xFF}) {
        Raw damaged = chunks[c];
        damaged[i] ^= flip;
        Raw file;
        for (std::size_t k = 0; k < frames.size(); ++k) {
          const Raw frame = k == c ? compressed(damaged) : frames[k];
          file.insert(file.end(), frame.begin(), frame.end());
        }
        refusal(file);  // an exception of another kind, a crash or an invalid frame fails the test
      }
    }
  }
}

TEST(Corruption, EveryFlatBufferCutOffAtEveryLength) {
  const std::vector<Raw> chunks = small_chunks();
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    for (std::size_t length = 0; length < chunks[c].size(); ++length) {
      std::vector<Raw> damaged = chunks;
      damaged[c].resize(length);
      refusal(joined(damaged));
    }
  }
}

TEST(Corruption, AChunkMissing) {
  const std::vector<Raw> chunks = small_chunks();
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    std::vector<Raw> damaged = chunks;
    damaged.erase(damaged.begin() + static_cast<std::ptrdiff_t>(c));
    EXPECT_NE(refusal(joined(damaged)), "") << c;
  }
}

TEST(Corruption, AChunkTwice) {
  const std::vector<Raw> chunks = small_chunks();
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    std::vector<Raw> damaged = chunks;
    damaged.insert(damaged.begin() + static_cast<std::ptrdiff_t>(c), chunks[c]);
    EXPECT_NE(refusal(joined(damaged)), "") << c;
  }
}

TEST(Corruption, TwoNeighboursExchanged) {
  const std::vector<Raw> chunks = small_chunks();
  for (std::size_t c = 0; c + 1 < chunks.size(); ++c) {
    if (c == 2) continue;  // two textures: another scene, but a valid one
    std::vector<Raw> damaged = chunks;
    std::swap(damaged[c], damaged[c + 1]);
    EXPECT_NE(refusal(joined(damaged)), "") << c;
  }
}

TEST(Corruption, RandomBytes) {
  std::uint32_t state = 1;
  for (int round = 0; round < 300; ++round) {
    Raw file(static_cast<std::size_t>(round));
    for (std::uint8_t& byte : file) byte = static_cast<std::uint8_t>((state = state * 1664525u + 1013904223u) >> 24);
    EXPECT_NE(refusal(file), "");
    const Raw magic{0x28, 0xB5, 0x2F, 0xFD};
    file.insert(file.begin(), magic.begin(), magic.end());
    EXPECT_NE(refusal(file), "");
    EXPECT_NE(refusal(compressed(file)), "");
  }
}

}  // namespace
}  // namespace artu::traces::test
