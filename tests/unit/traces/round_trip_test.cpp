#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "traces/limits.h"
#include "traces/trace.h"
#include "unit/traces/support.h"

namespace artu::traces::test {
namespace {

using testing::HasSubstr;

TEST(RoundTrip, EveryFieldComesBackExactly) {
  const TempFolder folder;
  const Scene scene = sample_scene();
  const std::vector<Frame> frames{sample_frame(0), sample_frame(1)};
  write_trace(folder / "t", scene, frames);
  const Reader reader(folder / "t");
  expect_same(reader.scene(), scene);
  expect_same(reader.frame(0), frames[0]);
  expect_same(reader.frame(1), frames[1]);
}

TEST(RoundTrip, SceneWithNothingInIt) {
  const TempFolder folder;
  Scene scene;
  scene.width = scene.height = scene.frame_count = 1;
  write_trace(folder / "t", scene, {Frame()});
  const Reader reader(folder / "t");
  expect_same(reader.scene(), scene);
  expect_same(reader.frame(0), Frame());
}

TEST(RoundTrip, VerticesWithoutTrianglesAndTheReverse) {
  const TempFolder folder;
  Scene scene = sample_scene(1);
  scene.textures.clear();
  scene.materials[1].texture = -1;
  scene.static_geometry = sample_mesh(3, 0, 1);
  Frame frame = sample_frame(0);
  frame.dynamic = Mesh();
  write_trace(folder / "t", scene, {frame});
  const Reader reader(folder / "t");
  expect_same(reader.scene(), scene);
  expect_same(reader.frame(0), frame);
}

TEST(RoundTrip, ManyFramesInAnyOrder) {
  const TempFolder folder;
  constexpr std::uint32_t count = 300;
  std::vector<Frame> frames;
  for (std::uint32_t i = 0; i < count; ++i) {
    frames.push_back(sample_frame(i));
    if (i % 4 == 0) frames.back().dynamic = Mesh();
  }
  write_trace(folder / "t", sample_scene(count), frames);
  const Reader reader(folder / "t");
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t position = i * 127 % count;
    expect_same(reader.frame(position), frames[position]);
  }
  expect_same(reader.frame(0), reader.frame(0));
  EXPECT_THAT(message_of([&] { reader.frame(count); }), HasSubstr("frame 300 does not exist; the last one is 299"));
}

TEST(RoundTrip, MeshesOfSeveralParts) {
  const TempFolder folder;
  Scene scene = sample_scene(2);
  Frame frame = sample_frame(0), next = sample_frame(1);
  // One with fewer triangles than vertices, one with a last part that has triangles alone, one exactly full.
  scene.static_geometry = sample_mesh(2 * part_elements + 1, 10, 2);
  frame.dynamic = sample_mesh(5, part_elements + 3, 2);
  next.dynamic = sample_mesh(part_elements, part_elements, 2);
  EXPECT_EQ(part_count(scene.static_geometry.positions.size(), 10), 3u);
  EXPECT_EQ(part_count(part_elements, part_elements), 1u);
  write_trace(folder / "t", scene, {frame, next});
  const Reader reader(folder / "t");
  expect_same(reader.scene(), scene);
  expect_same(reader.frame(1), next);
  expect_same(reader.frame(0), frame);
}

TEST(RoundTrip, TextureOfTheLargestSide) {
  const TempFolder folder;
  Scene scene = sample_scene(1);
  scene.textures[0] = {"wide", max_side, 64, Wrap::repeat, Wrap::repeat, Raw(std::size_t{max_side} * 64 * 4)};
  for (std::size_t i = 0; i < scene.textures[0].rgba.size(); ++i) {
    scene.textures[0].rgba[i] = static_cast<std::uint8_t>(i * i >> 7);
  }
  write_trace(folder / "t", scene, {Frame()});
  expect_same(Reader(folder / "t").scene(), scene);
}

TEST(RoundTrip, TheLimitsThemselvesAreAllowed) {
  const TempFolder folder;
  Scene scene = sample_scene(1);
  scene.materials.resize(max_materials);
  scene.name = std::string(max_text, 'n');
  Frame frame = sample_frame(0);
  frame.lights.resize(max_lights);
  write_trace(folder / "t", scene, {frame});
  const Reader reader(folder / "t");
  expect_same(reader.scene(), scene);
  expect_same(reader.frame(0), frame);
}

TEST(RoundTrip, SameInputSameBytes) {
  const TempFolder folder;
  write_trace(folder / "a", sample_scene(), {sample_frame(0), sample_frame(1)});
  write_trace(folder / "b", sample_scene(), {sample_frame(0), sample_frame(1)});
  EXPECT_EQ(read_file(folder / "a"), read_file(folder / "b"));
}

TEST(RoundTrip, UnmovedGeometryIsKept) {
  const TempFolder folder;
  std::vector<Frame> frames{sample_frame(0), sample_frame(1), sample_frame(2)};
  frames[0].dynamic_moved = false;  // has no meaning in a first frame
  frames[1].dynamic_moved = false;
  frames[1].dynamic = frames[0].dynamic;
  write_trace(folder / "t", sample_scene(3), frames);
  const Reader reader(folder / "t");
  for (std::uint32_t i = 0; i < 3; ++i) expect_same(reader.frame(i), frames[i]);
}

TEST(IsTrace, TellsTracesFromOtherFiles) {
  const TempFolder folder;
  write_trace(folder / "t", sample_scene(1), {Frame()});
  write_file(folder / "gltf", {'g', 'l', 'T', 'F', 2, 0, 0, 0});
  write_file(folder / "short", {0x28, 0xB5});
  EXPECT_TRUE(is_trace(folder / "t"));
  EXPECT_FALSE(is_trace(folder / "gltf"));
  EXPECT_FALSE(is_trace(folder / "short"));
  EXPECT_FALSE(is_trace(folder / "absent"));
  EXPECT_FALSE(is_trace(folder / "."));
}

}  // namespace
}  // namespace artu::traces::test
