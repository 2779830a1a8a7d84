// Files that are valid zstd, and mostly valid FlatBuffers, with content that lies.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "frame_generated.h"
#include "unit/traces/support.h"

namespace artu::traces::test {
namespace {

using flatbuffers::FlatBufferBuilder;
using testing::HasSubstr;
using testing::StartsWith;

// The chunks of the sample: header, materials, two textures, one part, then two frames of one part each.
enum At { header, materials, texture0, texture1, static_part, frame0, dynamic0, frame1, dynamic1 };

std::vector<Raw> sample_chunks() { return chunks_of(sample_scene(2), {sample_frame(0), sample_frame(1)}); }

template <typename T>
Raw finish(FlatBufferBuilder& b, fb::Body kind, flatbuffers::Offset<T> body, std::uint32_t version = 1,
           const char* identifier = fb::ChunkIdentifier()) {
  b.Finish(fb::CreateChunk(b, version, kind, body.Union()), identifier);
  return Raw(b.GetBufferPointer(), b.GetBufferPointer() + b.GetSize());
}

struct HeaderFields {
  std::uint32_t version = 1, frames = 2, materials = 2, textures = 2, vertices = 7, triangles = 5;
  std::string name = "n";
  const char* identifier = "ARTU";
};

Raw header_chunk(const HeaderFields& f) {
  FlatBufferBuilder b;
  const auto name = b.CreateString(f.name);
  return finish(b, fb::Body_Header,
                fb::CreateHeader(b, name, name, 64, 64, 30, f.frames, f.materials, f.textures, f.vertices, f.triangles),
                f.version, f.identifier);
}

std::string refusal_with(At at, const Raw& chunk) {
  std::vector<Raw> chunks = sample_chunks();
  chunks[at] = chunk;
  return refusal(joined(chunks));
}

std::string refusal_with_header(const HeaderFields& fields) { return refusal_with(header, header_chunk(fields)); }

TEST(Hostile, TheHandMadeHeaderIsFine) { EXPECT_EQ(refusal_with_header({}), ""); }

TEST(Hostile, AnotherVersion) {
  HeaderFields f;
  f.version = 3;
  EXPECT_EQ(refusal_with_header(f), "chunk 0 (at byte 0): trace version 3, this program reads 1");
}

TEST(Hostile, AnotherVersionWithATableThatIsNotUnderstood) {
  FlatBufferBuilder b;
  const auto start = b.StartTable();
  b.AddElement<std::uint32_t>(fb::Chunk::VT_VERSION, 2, 0);
  b.AddElement<std::uint64_t>(fb::Chunk::VT_BODY, ~0ull, 0);  // not an offset
  b.Finish(flatbuffers::Offset<fb::Chunk>(b.EndTable(start)), "ARTU");
  EXPECT_EQ(refusal_with(header, Raw(b.GetBufferPointer(), b.GetBufferPointer() + b.GetSize())),
            "chunk 0 (at byte 0): trace version 2, this program reads 1");
}

TEST(Hostile, AnotherIdentifier) {
  HeaderFields f;
  f.identifier = "XRTU";
  EXPECT_THAT(refusal_with_header(f), HasSubstr("is not a trace's: its bytes 4 to 7, decompressed, must be \"ARTU\""));
}

TEST(Hostile, NotATrace) {
  EXPECT_THAT(refusal({'o', ' ', 'b', 'o', 'x', '\n'}), HasSubstr("no zstd frame begins here"));
  EXPECT_THAT(refusal(compressed({'h', 'e', 'l', 'l', 'o', ',', ' ', 'y', 'o', 'u'})), HasSubstr("is not a trace's"));
  EXPECT_THAT(refusal({}), HasSubstr("is empty"));
}

TEST(Hostile, CountsThatDoNotHold) {
  HeaderFields f;
  f.materials = 3;
  EXPECT_THAT(refusal_with_header(f),
              AllOf(StartsWith("chunk 1 "), HasSubstr("materials has 2 elements; must have 3")));
  f = {};
  f.textures = 1;
  EXPECT_THAT(refusal_with_header(f), AllOf(StartsWith("chunk 3 "), HasSubstr("StaticPart must be here")));
  f = {};
  f.textures = 3;
  EXPECT_THAT(refusal_with_header(f), HasSubstr("is of kind StaticPart; Texture must be here"));
  f = {};
  f.vertices = 8;
  EXPECT_THAT(refusal_with_header(f),
              AllOf(StartsWith("chunk 4 "), HasSubstr("positions has 7 elements; must have 8")));
  f = {};
  f.triangles = 4;
  EXPECT_THAT(refusal_with_header(f), HasSubstr("indices has 15 elements; must have 12"));
  f = {};
  f.frames = 3;
  EXPECT_THAT(refusal_with_header(f), HasSubstr("the file ends here; frame 2 (of 3) must follow"));
  f = {};
  f.frames = 1;
  EXPECT_THAT(refusal_with_header(f), HasSubstr("bytes follow the last of 1 frames; the file must end here"));
  f = {};
  f.frames = 0;
  EXPECT_THAT(refusal_with_header(f), HasSubstr("frame_count is 0"));
}

TEST(Hostile, HugeCountsInASmallFile) {
  HeaderFields f;
  f.vertices = f.triangles = 1u << 28;
  EXPECT_THAT(refusal_with_header(f), HasSubstr("must follow. Is it cut off?"));
  f.vertices = f.triangles = 1u << 20;
  EXPECT_THAT(refusal_with_header(f), HasSubstr("positions has 7 elements; must have 1048576"));
  f.vertices = 0xFFFFFFFFu;
  EXPECT_THAT(refusal_with_header(f), HasSubstr("static_vertices is 4294967295; must be at most 268435456"));
  f = {};
  f.triangles = 0xFFFFFFFFu;
  EXPECT_THAT(refusal_with_header(f), HasSubstr("static_triangles is 4294967295; must be at most 268435456"));
  f = {};
  f.materials = f.textures = f.frames = 0xFFFFFFFFu;
  EXPECT_THAT(refusal_with_header(f), HasSubstr("material_count is 4294967295; must be at most 65536"));
  f.materials = 2;
  EXPECT_THAT(refusal_with_header(f), HasSubstr("texture_count is 4294967295; must be at most 65536"));
  f.textures = 2;
  EXPECT_THAT(refusal_with_header(f), HasSubstr("the file ends here; frame 2 (of 4294967295) must follow"));
}

TEST(Hostile, TextThatIsLongOrNotText) {
  HeaderFields f;
  f.name.assign(5000, 'x');
  EXPECT_THAT(refusal_with_header(f), HasSubstr("name has 5000 bytes; must have at most 4096"));
  f.name = "\x1b[2J";
  EXPECT_THAT(refusal_with_header(f), HasSubstr("byte 0 of name is 27; must be UTF-8 text"));
}

TEST(Hostile, ManyOffsetsToOneMaterial) {
  FlatBufferBuilder b;
  const fb::Vec3 v(0, 0, 0);
  const auto name = b.CreateString(std::string(4096, 'x'));
  const auto one = fb::CreateMaterial(b, name, &v, &v, 0, &v, &v, 1, &v);
  const auto list = b.CreateVector(std::vector<flatbuffers::Offset<fb::Material>>(1000000, one));
  EXPECT_THAT(refusal_with(materials, finish(b, fb::Body_Materials, fb::CreateMaterials(b, list))),
              HasSubstr("chunk 1 "));
}

TEST(Hostile, BodiesThatAreMissingOrUnknown) {
  FlatBufferBuilder b;
  const auto nothing = fb::CreateAnyVersion(b, 1);
  EXPECT_THAT(refusal_with(frame0, finish(b, fb::Body_NONE, nothing)),
              HasSubstr("is of kind NONE; Frame must be here"));
  FlatBufferBuilder c;
  const auto unknown = fb::CreateAnyVersion(c, 1);
  EXPECT_THAT(refusal_with(frame0, finish(c, static_cast<fb::Body>(77), unknown)), HasSubstr("is of kind unknown"));
  FlatBufferBuilder d;
  const auto start = d.StartTable();  // fb::CreateChunk() would insist on a body
  d.AddElement<std::uint32_t>(fb::Chunk::VT_VERSION, 1, 0);
  d.Finish(flatbuffers::Offset<fb::Chunk>(d.EndTable(start)), "ARTU");
  EXPECT_THAT(refusal_with(frame0, Raw(d.GetBufferPointer(), d.GetBufferPointer() + d.GetSize())),
              HasSubstr("is not a valid FlatBuffer of the trace's schema"));
}

TEST(Hostile, RequiredFieldsThatAreMissing) {
  FlatBufferBuilder b;
  const auto start = b.StartTable();
  const flatbuffers::Offset<fb::Frame> empty(b.EndTable(start));
  EXPECT_THAT(refusal_with(frame0, finish(b, fb::Body_Frame, empty)),
              HasSubstr("is not a valid FlatBuffer of the trace's schema"));
}

struct PartLengths {
  std::uint32_t part = 0;
  std::size_t positions = 7, normals = 7, uvs = 7, colors = 7, indices = 15, materials = 5;
};

std::string refusal_with_part(const PartLengths& n) {
  FlatBufferBuilder b;
  const auto positions = b.CreateVectorOfStructs(std::vector<fb::Vec3>(n.positions));
  const auto normals = b.CreateVectorOfStructs(std::vector<fb::Vec3>(n.normals));
  const auto uvs = b.CreateVectorOfStructs(std::vector<fb::Vec2>(n.uvs));
  const auto colors = b.CreateVector(std::vector<std::uint32_t>(n.colors));
  const auto indices = b.CreateVector(std::vector<std::uint32_t>(n.indices));
  const auto of = b.CreateVector(std::vector<std::uint32_t>(n.materials));
  return refusal_with(static_part, finish(b, fb::Body_StaticPart,
                                          fb::CreateMeshPart(b, n.part, positions, normals, uvs, colors, indices, of)));
}

TEST(Hostile, PartsOfTheWrongNumberOrSize) {
  PartLengths n;
  EXPECT_EQ(refusal_with_part(n), "");
  n.part = 1;
  EXPECT_THAT(refusal_with_part(n), HasSubstr("is part 1 of its mesh; part 0 must be here"));
  n = {};
  n.normals = 6;
  EXPECT_THAT(refusal_with_part(n), HasSubstr("normals has 6 elements; must have 7"));
  n = {};
  n.uvs = 0;
  EXPECT_THAT(refusal_with_part(n), HasSubstr("uvs has 0 elements; must have 7"));
  n = {};
  n.colors = 8;
  EXPECT_THAT(refusal_with_part(n), HasSubstr("colors has 8 elements; must have 7"));
  n = {};
  n.materials = 4;
  EXPECT_THAT(refusal_with_part(n), HasSubstr("materials has 4 elements; must have 5"));
}

TEST(Hostile, ValuesThatValidateRefuses) {
  Scene scene = sample_scene(2);
  std::vector<Frame> frames{sample_frame(0), sample_frame(1)};
  scene.static_geometry.indices[3] = 7;
  EXPECT_EQ(refusal(joined(chunks_of(scene, frames))),
            "static geometry: indices[3] is 7; must be below 7, the number of vertices");
  scene = sample_scene(2);
  scene.textures[0].width = 16384;
  EXPECT_THAT(refusal(joined(chunks_of(scene, frames))), HasSubstr("rgba has 4 elements; must have 65536"));
  scene = sample_scene(2);
  frames[1].dynamic.materials[0] = 2;
  EXPECT_THAT(refusal(joined(chunks_of(scene, frames))),
              AllOf(StartsWith("chunk 7 "), HasSubstr("frame 1: dynamic geometry: materials[0] is 2")));
  frames[1] = sample_frame(1);
  frames[1].lights.resize(65);
  EXPECT_THAT(refusal(joined(chunks_of(scene, frames))), HasSubstr("the number of lights is 65; must be at most 64"));
}

TEST(Hostile, GeometryThatMovedAlthoughItSaysNot) {
  std::vector<Frame> frames{sample_frame(0), sample_frame(0)};
  frames[1].dynamic_moved = false;
  EXPECT_EQ(refusal(joined(chunks_of(sample_scene(2), frames))), "");
  frames[1].dynamic.positions[0].x = 9;
  EXPECT_THAT(refusal(joined(chunks_of(sample_scene(2), frames))), HasSubstr("frame 1: dynamic_moved is false, but"));
}

}  // namespace
}  // namespace artu::traces::test
