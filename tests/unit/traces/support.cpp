#include "unit/traces/support.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <zstd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <type_traits>

#include "traces/pack.h"
#include "traces/trace.h"
#include "traces/validate.h"

namespace artu::traces::test {
namespace {

template <typename T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

template <typename T>
void expect_bytes(const T& a, const T& b, const char* what) {
  static_assert(std::is_trivially_copyable_v<T>);
  // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): bits are compared, those of numbers, too.
  EXPECT_EQ(std::memcmp(&a, &b, sizeof(T)), 0) << what;
}

}  // namespace

TempFolder::TempFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "artu_traces_XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("cannot create a temporary folder");
  path_ = name;
}

TempFolder::~TempFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

Mesh sample_mesh(std::size_t vertices, std::size_t triangles, std::uint32_t materials, float offset) {
  Mesh mesh;
  for (std::size_t i = 0; i < vertices; ++i) {
    const float f = static_cast<float>(i) + offset;
    mesh.positions.push_back({f, -f / 3, 1 / (f + 1)});
    mesh.normals.push_back({f / 7, 1, -0.0f});
    mesh.uvs.push_back({f / 16, 1 - f / 4});
    mesh.colors.push_back(0xFF000000u + static_cast<std::uint32_t>(i) * 0x10203u);
  }
  for (std::size_t i = 0; i < triangles; ++i) {
    for (std::size_t k = 0; k < 3; ++k) mesh.indices.push_back(static_cast<std::uint32_t>((i * 5 + k * 7) % vertices));
    mesh.materials.push_back(static_cast<std::uint32_t>(i % materials));
  }
  return mesh;
}

Scene sample_scene(std::uint32_t frame_count) {
  Scene scene;
  scene.name = "sample \xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80";
  scene.generator = "traces_tests";
  scene.width = 640;
  scene.height = 16384;
  scene.fps = 29.97;
  scene.frame_count = frame_count;
  scene.materials.resize(2);
  Material& m = scene.materials[1];
  m.name = "glass";
  m.diffuse = {0.1f, 0.2f, 0.3f};
  m.specular = {0.4f, 0.5f, 0.6f};
  m.specular_log2 = 10;
  m.mirror = {0.7f, 0.8f, 0.9f};
  m.transmission = {1.0f, 1.1f, 1.2f};
  m.ior = 1.33f;
  m.emission = {100.0f, 200.0f, 300.0f};
  m.texture = 1;
  m.tint = true;
  scene.textures.push_back({"one texel", 1, 1, Wrap::mirror, Wrap::clamp, {1, 2, 3, 4}});
  scene.textures.push_back({"two by one", 2, 1, Wrap::clamp, Wrap::mirror, {5, 6, 7, 8, 9, 10, 11, 255}});
  scene.static_geometry = sample_mesh(7, 5, 2);
  return scene;
}

Frame sample_frame(std::uint32_t number) {
  const float f = static_cast<float>(number);
  Frame frame;
  frame.index = 100 + number;
  frame.time = 0.1 * (number + 1);
  frame.camera = {{f, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}, {13, 14, 15}, {16, 17, 18}};
  frame.lights.push_back({LightKind::spot, {1, 2, 3}, {0, 0, 1}, {4, 5, 6}, 7.5f, 0.75f, 0.5f});
  frame.lights.push_back({LightKind::directional, {3, 2, 1}, {1, 0, 0}, {6, 5, 4}, 8.5f, 0.25f, 0.125f});
  frame.ambient = {0.25f, 0.5f, 0.75f};
  frame.sky_nadir = {1, 2, 3};
  frame.sky_zenith = {4, 5, 6};
  frame.dynamic_moved = true;
  frame.dynamic = sample_mesh(4 + number % 3, 2 + number % 2, 2, f);
  return frame;
}

void expect_same(const Mesh& a, const Mesh& b) {
  EXPECT_TRUE(same_bytes(a.positions, b.positions));
  EXPECT_TRUE(same_bytes(a.normals, b.normals));
  EXPECT_TRUE(same_bytes(a.uvs, b.uvs));
  EXPECT_TRUE(same_bytes(a.colors, b.colors));
  EXPECT_TRUE(same_bytes(a.indices, b.indices));
  EXPECT_TRUE(same_bytes(a.materials, b.materials));
}

void expect_same(const Scene& a, const Scene& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.generator, b.generator);
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  EXPECT_EQ(a.fps, b.fps);
  EXPECT_EQ(a.frame_count, b.frame_count);
  ASSERT_EQ(a.materials.size(), b.materials.size());
  for (std::size_t i = 0; i < a.materials.size(); ++i) {
    const Material &m = a.materials[i], &n = b.materials[i];
    EXPECT_EQ(m.name, n.name);
    expect_bytes(m.diffuse, n.diffuse, "diffuse");
    expect_bytes(m.specular, n.specular, "specular");
    EXPECT_EQ(m.specular_log2, n.specular_log2);
    expect_bytes(m.mirror, n.mirror, "mirror");
    expect_bytes(m.transmission, n.transmission, "transmission");
    EXPECT_EQ(m.ior, n.ior);
    expect_bytes(m.emission, n.emission, "emission");
    EXPECT_EQ(m.texture, n.texture);
    EXPECT_EQ(m.tint, n.tint);
  }
  ASSERT_EQ(a.textures.size(), b.textures.size());
  for (std::size_t i = 0; i < a.textures.size(); ++i) {
    const Texture &s = a.textures[i], &t = b.textures[i];
    EXPECT_EQ(s.name, t.name);
    EXPECT_EQ(s.width, t.width);
    EXPECT_EQ(s.height, t.height);
    EXPECT_EQ(s.wrap_u, t.wrap_u);
    EXPECT_EQ(s.wrap_v, t.wrap_v);
    EXPECT_EQ(s.rgba, t.rgba);
  }
  expect_same(a.static_geometry, b.static_geometry);
}

void expect_same(const Frame& a, const Frame& b) {
  EXPECT_EQ(a.index, b.index);
  EXPECT_EQ(a.time, b.time);
  expect_bytes(a.camera, b.camera, "camera");
  ASSERT_EQ(a.lights.size(), b.lights.size());
  for (std::size_t i = 0; i < a.lights.size(); ++i) {
    const Light &l = a.lights[i], &m = b.lights[i];
    EXPECT_EQ(l.kind, m.kind);
    expect_bytes(l.position, m.position, "position");
    expect_bytes(l.direction, m.direction, "direction");
    expect_bytes(l.color, m.color, "color");
    EXPECT_EQ(l.range, m.range);
    EXPECT_EQ(l.cos_inner, m.cos_inner);
    EXPECT_EQ(l.cos_outer, m.cos_outer);
  }
  expect_bytes(a.ambient, b.ambient, "ambient");
  expect_bytes(a.sky_nadir, b.sky_nadir, "sky_nadir");
  expect_bytes(a.sky_zenith, b.sky_zenith, "sky_zenith");
  EXPECT_EQ(a.dynamic_moved, b.dynamic_moved);
  expect_same(a.dynamic, b.dynamic);
}

Raw read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return Raw(std::istreambuf_iterator<char>(file), {});
}

void write_file(const std::string& path, const Raw& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

std::vector<Raw> chunks_of(const Scene& scene, const std::vector<Frame>& frames) {
  std::vector<Raw> chunks;
  const auto sink = [&](const std::uint8_t* data, std::size_t size) { chunks.emplace_back(data, data + size); };
  pack(scene, sink);
  for (const Frame& frame : frames) pack(frame, sink);
  return chunks;
}

Raw compressed(const Raw& content, Zstd options) {
  const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(), ZSTD_freeCCtx);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, options.checksum);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_contentSizeFlag, options.content_size);
  if (options.window_log) ZSTD_CCtx_setParameter(context.get(), ZSTD_c_windowLog, options.window_log);
  Raw out(ZSTD_compressBound(content.size()));
  const std::size_t size = ZSTD_compress2(context.get(), out.data(), out.size(), content.data(), content.size());
  if (ZSTD_isError(size)) throw std::runtime_error(ZSTD_getErrorName(size));
  out.resize(size);
  return out;
}

Raw joined(const std::vector<Raw>& chunks) {
  Raw file;
  for (const Raw& chunk : chunks) {
    const Raw frame = compressed(chunk);
    file.insert(file.end(), frame.begin(), frame.end());
  }
  return file;
}

void write_trace(const std::string& path, const Scene& scene, const std::vector<Frame>& frames) {
  Writer writer(path, scene);
  for (const Frame& frame : frames) writer.add(frame);
  writer.close();
}

void read_all(const std::string& path) {
  const Reader reader(path);
  EXPECT_NO_THROW(validate(reader.scene(), "read"));
  for (std::uint32_t i = 0; i < reader.scene().frame_count; ++i) {
    const Frame frame = reader.frame(i);
    EXPECT_NO_THROW(validate(reader.scene(), frame, "read"));
  }
}

std::string refusal(const Raw& file) {
  static const TempFolder folder;
  const std::string path = folder / "t.artu";
  write_file(path, file);
  std::string message = message_of([&] { read_all(path); });
  if (message.empty()) return message;
  EXPECT_EQ(message.find(path + ": "), 0u) << message;  // every refusal names the file
  return message.substr(path.size() + 2);
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace artu::traces::test
