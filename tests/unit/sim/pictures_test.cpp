// Pictures: colours, keys, letters, and moving ones read back.
#include <gtest/gtest.h>

#include <filesystem>

#include "sim/report/apng.h"
#include "sim/report/heat.h"
#include "sim/report/legend.h"
#include "sim/report/picture_set.h"
#include "sim/report/pictures.h"
#include "sim/report/tiny_font.h"

namespace artu::sim {
namespace {

std::vector<int> pixel(const Image& image, std::uint32_t x, std::uint32_t y) {
  const std::uint8_t* p = &image.rgb.at(3 * (std::size_t{y} * image.width + x));
  return {p[0], p[1], p[2]};
}

std::vector<int> codes(Color c) { return {c.r, c.g, c.b}; }

TEST(Heat, GoesFromBlueToWhite) {
  EXPECT_EQ(codes(heat_color(0)), (std::vector<int>{40, 40, 160}));
  EXPECT_EQ(codes(heat_color(0.5)), (std::vector<int>{225, 50, 50}));
  EXPECT_EQ(codes(heat_color(1)), (std::vector<int>{255, 255, 255}));
  EXPECT_EQ(codes(heat_color(-1)), codes(heat_color(0)));
  EXPECT_EQ(codes(heat_color(2)), codes(heat_color(1)));
  EXPECT_EQ(codes(error_heat(0)), (std::vector<int>{0, 0, 0}));
  EXPECT_EQ(codes(error_heat(1)), codes(heat_color(0)));
  EXPECT_EQ(codes(code_heat(0)), codes(heat_color(0)));
  EXPECT_EQ(codes(code_heat(15)), codes(heat_color(0.5)));
  EXPECT_EQ(codes(code_heat(255)), codes(heat_color(1)));
  EXPECT_EQ(codes(cycles_heat(1000)), codes(heat_color(0.5)));
  EXPECT_EQ(codes(cycles_heat(1)), codes(heat_color(0)));
}

TEST(TinyFont, DrawsALetterPixelByPixel) {
  Image image = blank(6, 7, {0, 0, 0});
  draw_text(image, 0, 0, "t", {255, 255, 255});
  const char* rows[] = {"#####.", "..#...", "..#...", "..#...", "..#...", "..#...", "..#..."};
  for (std::uint32_t y = 0; y < 7; ++y) {
    for (std::uint32_t x = 0; x < 6; ++x) EXPECT_EQ(pixel(image, x, y)[0] != 0, rows[y][x] == '#') << x << ' ' << y;
  }
  draw_text(image, 4, 5, "W", {9, 9, 9});  // runs over the border: cut off
  EXPECT_EQ(image.rgb.size(), 6u * 7 * 3);
}

TEST(Legend, LeavesThePictureWhereItIs) {
  Image image = blank(200, 3, {1, 2, 3});
  set_pixel(image, 199, 2, {7, 8, 9});
  const Image out = with_legend(image, {"title", {{{50, 60, 70}, "first"}, {{80, 90, 100}, "second"}}});
  EXPECT_EQ(out.width, 200u);
  EXPECT_GT(out.height, 10u);
  EXPECT_EQ(pixel(out, 0, 0), (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(pixel(out, 199, 2), (std::vector<int>{7, 8, 9}));
  int swatch = 0;
  for (std::uint32_t y = 3; y < out.height; ++y) {
    for (std::uint32_t x = 0; x < out.width; ++x) swatch += pixel(out, x, y) == std::vector<int>{50, 60, 70};
  }
  EXPECT_EQ(swatch, 7 * 5);
}

TEST(Legend, ANarrowPictureGetsAMarginAndMoreLines) {
  const Legend legend{"t", {{{1, 1, 1}, "something long"}, {{2, 2, 2}, "something else"}}};
  const Image wide = with_legend(blank(400, 2, {0, 0, 0}), legend),
              narrow = with_legend(blank(2, 2, {0, 0, 0}), legend);
  EXPECT_GT(narrow.width, 2u);
  EXPECT_GT(narrow.height, wide.height);
}

FrameOutcome outcome() {
  FrameOutcome o;
  o.index = 4;
  o.width = 2;
  o.height = 1;
  o.pixels.resize(2);
  o.pixels[0].r = 200;
  o.pixels[0].cycles = 1000;
  o.pixels[0].hit_class = hw::HitClass::miss;
  o.pixels[1].decision = hw::Decision::interpolated;
  o.pixels[1].threshold = 15;
  o.pixels[1].difference = 3;
  return o;
}

TEST(Pictures, ShowWhatTheUnitDid) {
  EXPECT_EQ(pixel(threshold_picture(outcome()), 0, 0), (std::vector<int>{0, 0, 0}));
  EXPECT_EQ(pixel(threshold_picture(outcome()), 1, 0), codes(code_heat(15)));
  EXPECT_EQ(pixel(difference_picture(outcome()), 1, 0), codes(code_heat(3)));
  EXPECT_EQ(pixel(cycles_picture(outcome()), 0, 0), codes(cycles_heat(1000)));
  EXPECT_EQ(pixel(cycles_picture(outcome()), 1, 0), (std::vector<int>{0, 0, 0}));
}

FullRender full_of(const FrameOutcome& o) {
  FullRender full = full_render_of(o);
  full.image.rgb[3] = 64;  // the interpolated pixel is wrong by that
  return full;
}

TEST(Pictures, EveryKindCanBeMade) {
  const FullRender full = full_of(outcome());
  for (std::size_t i = 0; i < picture_count; ++i) {
    const Image image = picture_of(static_cast<Picture>(i), outcome(), &full);
    EXPECT_EQ(image.rgb.size(), std::size_t{3} * image.width * image.height) << picture_names[i];
    EXPECT_GT(image.width, 1u);
  }
  const Image error = picture_of(Picture::error, outcome(), &full);
  EXPECT_EQ(pixel(error, 0, 0), (std::vector<int>{0, 0, 0}));
  EXPECT_EQ(pixel(error, 1, 0), codes(error_heat(64)));
}

class PictureFiles : public ::testing::Test {
 protected:
  PictureFiles() {
    std::string name = (std::filesystem::path(::testing::TempDir()) / "artu_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~PictureFiles() override { std::filesystem::remove_all(folder_); }
  std::string path(const std::string& name) const { return folder_ + "/" + name; }
  std::string folder_;
};

struct Chunk {
  std::string type, data;
};

std::uint32_t number(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
  return value;
}

std::vector<Chunk> chunks_of(const std::string& bytes) {
  std::vector<Chunk> chunks;
  for (std::size_t at = 8; at < bytes.size();) {
    const std::uint32_t length = number(bytes, at);
    chunks.push_back({bytes.substr(at + 4, 4), bytes.substr(at + 8, length)});
    EXPECT_EQ(number(bytes, at + 8 + length), crc32_of(chunks.back().type + chunks.back().data));
    at += length + 12;
  }
  return chunks;
}

TEST(Crc32, IsThatOfPng) { EXPECT_EQ(crc32_of("123456789"), 0xcbf43926u); }

TEST_F(PictureFiles, AMovingPictureHoldsEveryFrame) {
  std::vector<Image> frames;
  for (const std::uint8_t code : {10, 90, 200}) frames.push_back(blank(5, 4, {code, 2, code}));
  set_pixel(frames[2], 3, 1, {255, 0, 0});
  AnimatedPng animation(path("a.png"), 3, 25);
  for (const Image& frame : frames) animation.add(encode_png("", frame));
  EXPECT_THROW(animation.add(encode_png("", frames[0])), std::logic_error);
  animation.close();

  const std::string bytes = read_file(path("a.png")), signature = bytes.substr(0, 8);
  EXPECT_EQ(signature, "\x89PNG\r\n\x1a\n");
  const std::vector<Chunk> chunks = chunks_of(bytes);
  std::vector<std::string> types;
  for (const Chunk& chunk : chunks) types.push_back(chunk.type);
  EXPECT_EQ(types, (std::vector<std::string>{"IHDR", "acTL", "fcTL", "IDAT", "fcTL", "fdAT", "fcTL", "fdAT", "IEND"}));
  EXPECT_EQ(number(chunks[1].data, 0), 3u);
  EXPECT_EQ(number(chunks[1].data, 4), 0u);
  std::uint32_t sequence = 0;
  std::size_t frame = 0;
  for (const Chunk& chunk : chunks) {
    if (chunk.type == "fcTL") {
      ASSERT_EQ(chunk.data.size(), 26u);
      EXPECT_EQ(number(chunk.data, 0), sequence++);
      EXPECT_EQ(number(chunk.data, 4), 5u);
      EXPECT_EQ(number(chunk.data, 8), 4u);
      EXPECT_EQ(number(chunk.data, 20), 40u << 16 | 1000u);  // 40/1000 s
      continue;
    }
    std::string pixels = chunk.data;
    if (chunk.type == "fdAT") {
      EXPECT_EQ(number(pixels, 0), sequence++);
      pixels.erase(0, 4);
    } else if (chunk.type != "IDAT") {
      continue;
    }
    // The frame as a PNG of its own.
    const std::uint32_t length = static_cast<std::uint32_t>(pixels.size());
    const std::string header = bytes.substr(0, 8 + 25);
    std::string size;
    for (const int shift : {24, 16, 8, 0}) size += static_cast<char>(length >> shift & 255);
    write_file(path("frame.png"),
               header + size + "IDAT" + pixels + std::string(4, '\0') + bytes.substr(bytes.size() - 12));
    EXPECT_EQ(read_png(path("frame.png")).rgb, frames.at(frame++).rgb);
  }
  EXPECT_EQ(frame, 3u);
}

TEST_F(PictureFiles, OnlyWhatWasAskedForIsWritten) {
  PictureWriter writer(path("x_"), {Picture::error, Picture::animation}, 1, 30);
  const FullRender full = full_of(outcome());
  writer.append(writer.write(outcome(), &full));
  writer.finish();
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"x_animation.png", "x_error_0004.png"}));
  EXPECT_TRUE((PictureSet{Picture::strip}).needs_full());
  EXPECT_FALSE((PictureSet{Picture::frame, Picture::decision, Picture::cycles}).needs_full());
}

}  // namespace
}  // namespace artu::sim
