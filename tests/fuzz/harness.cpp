#include "fuzz/harness.h"

#include <stdlib.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "traces/error.h"

namespace artu::fuzz {
namespace {

/// A triangle with a texture, in a file beside.
constexpr const char* model_gltf =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0,"name":"still"},{"mesh":0,"name":"mover"}],)"
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
    R"("buffers":[{"uri":"data.bin","byteLength":256}],"bufferViews":[{"buffer":0,"byteLength":64}],)"
    R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},)"
    R"({"bufferView":0,"byteOffset":12,"componentType":5126,"count":2,"type":"SCALAR"},)"
    R"({"bufferView":0,"byteOffset":12,"componentType":5126,"count":2,"type":"VEC3"}],)"
    R"("animations":[{"name":"walk","samplers":[{"input":1,"output":2}],)"
    R"("channels":[{"sampler":0,"target":{"node":1,"path":"translation"}}]}]})";

constexpr unsigned char texture_png[] = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00,
    0x00, 0x02, 0x00, 0x00, 0x00, 0x01, 0x08, 0x02, 0x00, 0x00, 0x00, 0x7b, 0x40, 0xe8, 0xdd, 0x00, 0x00, 0x00,
    0x0f, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0xf8, 0xcf, 0xc0, 0xc0, 0xd0, 0xf0, 0x1f, 0x00, 0x08, 0x00,
    0x02, 0x7f, 0x25, 0x3e, 0xfc, 0x09, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

}  // namespace

Sandbox::Sandbox() {
  const bool in_memory = std::filesystem::is_directory("/dev/shm");
  std::string name = (in_memory ? "/dev/shm" : std::filesystem::temp_directory_path().string()) + "/artu-fuzz-XXXXXX";
  require(mkdtemp(name.data()) != nullptr, "a temporary folder");
  path_ = name;
}

Sandbox::~Sandbox() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string Sandbox::write(const std::string& name, const std::uint8_t* bytes, std::size_t size) const {
  std::string path = path_ + "/" + name;
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  file.close();
  require(file.good(), "a file of the sandbox written");
  return path;
}

std::string Sandbox::write(const std::string& name, const std::string& bytes) const {
  return write(name, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

std::string Sandbox::write_folder(const std::string& name, const std::string& text) const {
  const std::string mark = "%FILE ";
  std::string folder = path_ + "/" + name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  for (std::size_t at = text.find(mark); at != std::string::npos;) {
    const std::size_t line = std::min(text.find('\n', at), text.size()), next = text.find(mark, line);
    const std::string file = text.substr(at + mark.size(), line - at - mark.size());
    const bool plain = !file.empty() && file.size() < 100 && file[0] != '.' && file.find('/') == std::string::npos &&
                       file.find('\0') == std::string::npos;
    if (plain) write(name + "/" + file, text.substr(std::min(line + 1, text.size()), next - line - 1));
    at = next;
  }
  return folder;
}

void Sandbox::furnish() const {
  const float corners[64] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0.5, 1.5, 2};  // times 0.5 and 1.5 are in order, too
  write("data.bin", reinterpret_cast<const std::uint8_t*>(corners), sizeof corners);
  write("texture.png", texture_png, sizeof texture_png);
  write("model.gltf", model_gltf);
  write("model.obj", "mtllib model.mtl\nusemtl paint\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write("model.mtl", "newmtl paint\nKd 1 0 0\nmap_Kd texture.png\n");
}

void read_or_refuse(const std::function<void()>& read) {
  try {
    read();
  } catch (const InputError& error) {
    require(error.what()[0] != '\0', "an error that says something");
  }
}

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  abort();
}

}  // namespace artu::fuzz
