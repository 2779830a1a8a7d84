#include "sim/import/gltf_file.h"

#include <exception>

#include "sim/import/gltf_check.h"
#include "sim/import/resource_path.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

constexpr std::uint64_t max_file = std::uint64_t{1} << 31;  // tinygltf counts bytes in int

/// tinygltf asks for files by a path it has joined itself, and falls back to the working folder: both end here.
struct Folder {
  std::string root;

  bool find(const std::string& path, std::string& real) const {
    if (path.compare(0, root.size() + 1, root + "/") != 0) return false;
    try {
      real = resource_path(root, path.substr(root.size() + 1), root);
      return true;
    } catch (const InputError&) {
      return false;
    }
  }
};

bool exists(const std::string& path, void* user) {
  std::string real;
  return static_cast<const Folder*>(user)->find(path, real);
}

bool read_whole(std::vector<unsigned char>* out, std::string* error, const std::string& path, void* user) {
  std::string real;
  if (!static_cast<const Folder*>(user)->find(path, real)) return false;
  try {
    *out = read_file(real, max_file);
    return true;
  } catch (const InputError& e) {
    if (error) *error += e.what();
    return false;
  }
}

/// Keeps the encoded bytes: only images that the unit uses are worth decoding.  Those in a buffer view are left
/// where they are, since tinygltf has not checked the view.
bool keep_bytes(tinygltf::Image* image, int index, std::string*, std::string*, int, int, const unsigned char* bytes,
                int size, void* user) {
  if (image->bufferView != -1) return true;
  auto& kept = *static_cast<std::vector<std::vector<unsigned char>>*>(user);
  if (index >= 0 && size >= 0) {
    if (kept.size() <= static_cast<std::size_t>(index)) kept.resize(static_cast<std::size_t>(index) + 1);
    kept[static_cast<std::size_t>(index)].assign(bytes, bytes + size);
  }
  return true;
}

std::string one_line(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text.substr(0, 300);
}

}  // namespace

GltfFile read_gltf(const std::string& path, std::vector<std::string>& log) {
  const std::vector<std::uint8_t> bytes = read_file(path, max_file);
  const GltfText text = find_gltf_text(bytes, path);
  check_gltf_json(text, path, log);

  GltfFile file;
  file.path = path;
  Folder folder{folder_of(path)};
  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks({exists, [](const std::string& p, void*) { return p; }, read_whole, nullptr, &folder});
  loader.SetImageLoader(keep_bytes, &file.image_bytes);
  std::string error, warning;
  bool good = false;
  try {
    good = text.binary ? loader.LoadBinaryFromMemory(&file.json, &error, &warning, bytes.data(),
                                                     static_cast<unsigned>(bytes.size()), folder.root)
                       : loader.LoadASCIIFromString(&file.json, &error, &warning, text.json,
                                                    static_cast<unsigned>(text.size), folder.root);
  } catch (const std::exception& e) {
    error += e.what();
  }
  if (!good) throw InputError(path, "not a valid glTF file: " + one_line(error));
  // What tinygltf complains about and yet reads: members of a wrong type, which then have their default value.
  if (!error.empty()) log.push_back(path + ": " + one_line(error));
  file.image_bytes.resize(file.json.images.size());
  return file;
}

}  // namespace artu::sim
