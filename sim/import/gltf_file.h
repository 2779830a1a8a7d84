// A glTF file in memory: parsed, its outside references resolved, nothing decoded yet.
#pragma once

#include <string>
#include <vector>

#include <tiny_gltf.h>

namespace artu::sim {

struct GltfFile {
  std::string path;
  tinygltf::Model json;  // tinygltf's mirror of the JSON, with the buffers' bytes
  /// Encoded bytes of images that are not in a buffer view; by image.
  std::vector<std::vector<unsigned char>> image_bytes;

  /// "FILE: meshes[3].primitives[0]" for messages.
  std::string at(const std::string& place) const { return path + ": " + place; }
};

/// Throws InputError for whatever is not a glTF 2.0 file that can be read: syntax, chunks, names of files outside the
/// folder, missing files, required extensions that are not supported.
GltfFile read_gltf(const std::string& path, std::vector<std::string>& log);

}  // namespace artu::sim
