// Scenes written on the fly for the importer's tests: a glTF builder, what came out.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/import/import.h"
#include "traces/error.h"
#include "unit/sim/temp_folder.h"

namespace artu::sim::test {

using Json = nlohmann::json;

inline std::string base64(const std::string& bytes) {
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t n = 0;
    for (std::size_t k = 0; k < 3; ++k)
      n = n << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? digits[n >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

/// A 2 x 1 PNG: texel 0 is (255, 0, 0), texel 1 is (0, 128, 255).
inline std::string png_2x1() {
  static const unsigned char bytes[] = {
      0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00,
      0x00, 0x02, 0x00, 0x00, 0x00, 0x01, 0x08, 0x02, 0x00, 0x00, 0x00, 0x7b, 0x40, 0xe8, 0xdd, 0x00, 0x00, 0x00,
      0x0f, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0xf8, 0xcf, 0xc0, 0xc0, 0xd0, 0xf0, 0x1f, 0x00, 0x08, 0x00,
      0x02, 0x7f, 0x25, 0x3e, 0xfc, 0x09, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
  return std::string(reinterpret_cast<const char*>(bytes), sizeof bytes);
}

/// A glTF file whose buffer grows with what is added.  It starts with one scene of node 0.
struct Gltf {
  Json j = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", {0}}}}}};
  std::string data;

  template <typename T>
  int view(const std::vector<T>& values, int stride = 0) {
    while (data.size() % 4) data += '\0';
    Json view = {{"buffer", 0}, {"byteOffset", data.size()}, {"byteLength", values.size() * sizeof(T)}};
    if (stride) view["byteStride"] = stride;
    data.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    return add("bufferViews", view);
  }
  template <typename T>
  int accessor(const char* type, int component, const std::vector<T>& values, std::size_t width) {
    return add(
        "accessors",
        {{"bufferView", view(values)}, {"componentType", component}, {"count", values.size() / width}, {"type", type}});
  }
  int scalars(const std::vector<float>& v) { return accessor("SCALAR", 5126, v, 1); }
  int vec2(const std::vector<float>& v) { return accessor("VEC2", 5126, v, 2); }
  int vec3(const std::vector<float>& v) { return accessor("VEC3", 5126, v, 3); }
  int vec4(const std::vector<float>& v) { return accessor("VEC4", 5126, v, 4); }
  int mat4(const std::vector<float>& v) { return accessor("MAT4", 5126, v, 16); }
  int indices(const std::vector<std::uint16_t>& v) { return accessor("SCALAR", 5123, v, 1); }
  int joints(const std::vector<std::uint8_t>& v) { return accessor("VEC4", 5121, v, 4); }

  int add(const char* where, const Json& item) {
    j[where].push_back(item);
    return static_cast<int>(j[where].size()) - 1;
  }
  /// A mesh of one primitive, and no node.
  int mesh(const Json& attributes, const Json& more = Json::object()) {
    Json primitive = more;
    primitive["attributes"] = attributes;
    return add("meshes", {{"primitives", {primitive}}});
  }
  /// The triangle (0,0,0) (1,0,0) (0,1,0).
  int triangle() { return mesh({{"POSITION", vec3({0, 0, 0, 1, 0, 0, 0, 1, 0})}}); }

  void animate(int node, const char* path, int times, int values, const char* interpolation = "LINEAR") {
    if (!j.contains("animations")) add("animations", {{"channels", Json::array()}, {"samplers", Json::array()}});
    Json& clip = j["animations"][0];
    clip["samplers"].push_back({{"input", times}, {"output", values}, {"interpolation", interpolation}});
    clip["channels"].push_back(
        {{"sampler", clip["samplers"].size() - 1}, {"target", {{"node", node}, {"path", path}}}});
  }

  std::string text() const {
    Json out = j;
    if (!data.empty() && !out.contains("buffers"))
      out["buffers"] = {{{"byteLength", data.size()}, {"uri", "data:application/octet-stream;base64," + base64(data)}}};
    return out.dump();
  }
  std::string glb() const {
    Json out = j;
    std::string bin = data;
    while (bin.size() % 4) bin += '\0';
    out["buffers"] = {{{"byteLength", data.size()}}};
    std::string json = out.dump();
    while (json.size() % 4) json += ' ';
    const auto word = [](std::size_t n) {
      const auto v = static_cast<std::uint32_t>(n);
      return std::string(reinterpret_cast<const char*>(&v), 4);
    };
    return "glTF" + word(2) + word(28 + json.size() + bin.size()) + word(json.size()) + "JSON" + json +
           word(bin.size()) + std::string("BIN\0", 4) + bin;
  }
};

/// Writes, opens, poses.
class ImportTest : public ::testing::Test {
 protected:
  TempFolder folder;
  ImportOptions options;
  std::vector<std::string> log;
  std::unique_ptr<SceneSource> source;

  SceneSource& open(const std::string& path) {
    log.clear();
    source = SceneSource::open(path, options, log);
    return *source;
  }
  SceneSource& open(const Gltf& gltf) { return open(folder.write("scene.gltf", gltf.text())); }

  /// The message of the InputError that opening `path` gives.
  std::string error_of(const std::string& path) {
    try {
      open(path);
    } catch (const InputError& e) {
      return e.what();
    }
    return "(no error)";
  }
  std::string error_of(const Gltf& gltf) { return error_of(folder.write("bad.gltf", gltf.text())); }
};

inline std::vector<float> xyz(const traces::Vec3& v) { return {v.x, v.y, v.z}; }

/// The corners of the mesh's triangles, one after the other, through the indices.
inline std::vector<float> corners(const traces::Mesh& mesh) {
  std::vector<float> out;
  for (const std::uint32_t i : mesh.indices) {
    const traces::Vec3& p = mesh.positions[i];
    out.insert(out.end(), {p.x, p.y, p.z});
  }
  return out;
}

MATCHER_P2(NearAll, expected, tolerance, "each number is near its twin in " + ::testing::PrintToString(expected)) {
  if (arg.size() != expected.size()) return false;
  for (std::size_t i = 0; i < arg.size(); ++i) {
    if (!(std::abs(arg[i] - expected[i]) <= tolerance)) return false;
  }
  return true;
}

inline auto near(const std::vector<float>& expected, double tolerance = 1e-5) { return NearAll(expected, tolerance); }

}  // namespace artu::sim::test
