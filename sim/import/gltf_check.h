// What is checked in a glTF file's JSON before tinygltf sees it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace artu::sim {

/// The JSON text of a .gltf or .glb, and whether it is the latter.
struct GltfText {
  const char* json = nullptr;
  std::size_t size = 0;
  bool binary = false;
};

/// Checks the container's header and chunk lengths.
GltfText find_gltf_text(const std::vector<std::uint8_t>& file, const std::string& path);

/// Checks syntax, version, required extensions and every file that the JSON names.
void check_gltf_json(const GltfText& text, const std::string& path, std::vector<std::string>& log);

}  // namespace artu::sim
