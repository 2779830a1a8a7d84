#include "sim/import/gltf_check.h"

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>

#include "sim/import/resource_path.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

using Json = nlohmann::json;

// What is read.
const std::set<std::string> supported = {
    "KHR_lights_punctual",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_unlit",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_transmission",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
};

// What changes only the fine look of a surface or nothing visible: left out with a log line even where required.
const std::set<std::string> harmless = {
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_dispersion",
    "KHR_materials_iridescence",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_variants",
    "KHR_materials_volume",
    "KHR_materials_diffuse_transmission",
    "KHR_xmp_json_ld",
    "KHR_xmp",
};

std::uint32_t word(const std::vector<std::uint8_t>& file, std::size_t at) {
  return std::uint32_t{file[at]} | std::uint32_t{file[at + 1]} << 8 | std::uint32_t{file[at + 2]} << 16 |
         std::uint32_t{file[at + 3]} << 24;
}

/// tinygltf walks `extras` and `extensions` recursively, so depth is stack.
void check_depth(const GltfText& text, const std::string& path) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size; ++i) {
    const char c = text.json[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      if (++depth > 128) throw InputError(path, "JSON is nested deeper than 128 levels");
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
}

Json parse(const GltfText& text, const std::string& path) {
  try {
    return Json::parse(text.json, text.json + text.size);
  } catch (const Json::parse_error& e) {
    const std::size_t at = std::min<std::size_t>(e.byte, text.size);
    const auto line = 1 + std::count(text.json, text.json + at, '\n');
    throw InputError(path + (text.binary ? "" : ":" + std::to_string(line)),
                     "not valid JSON at byte " + std::to_string(e.byte));
  } catch (const Json::exception& e) {
    throw InputError(path, std::string("not valid JSON: ") + e.what());  // a number that no binary64 can hold
  }
}

void check_types(const Json& root, const std::string& path) {
  if (!root.is_object()) throw InputError(path, "not a glTF file: the JSON is not an object");
  const char* arrays[] = {"accessors",      "animations", "bufferViews", "buffers", "cameras", "extensionsRequired",
                          "extensionsUsed", "images",     "materials",   "meshes",  "nodes",   "samplers",
                          "scenes",         "skins",      "textures"};
  for (const char* name : arrays) {
    if (!root.contains(name)) continue;
    if (!root[name].is_array()) throw InputError(path, std::string(name) + " is not an array");
    const bool strings = !std::strncmp(name, "extensions", 10);
    std::size_t i = 0;
    for (const Json& item : root[name]) {
      if (!(strings ? item.is_string() : item.is_object()))
        throw InputError(
            path, std::string(name) + "[" + std::to_string(i) + "] is not " + (strings ? "a string" : "an object"));
      ++i;
    }
  }
  if (!root.contains("asset") || !root["asset"].is_object() || !root["asset"].contains("version") ||
      !root["asset"]["version"].is_string())
    throw InputError(path, "not a glTF file: asset.version is missing");
  const std::string version = root["asset"]["version"];
  if (version.substr(0, 2) != "2.")
    throw InputError(path, "is glTF version " + version.substr(0, 16) + "; only 2.x can be read");
}

void check_extensions(const Json& root, const std::string& path, std::vector<std::string>& log) {
  if (root.contains("extensionsRequired")) {
    for (const Json& item : root["extensionsRequired"]) {
      const std::string name = item;
      if (!supported.count(name) && !harmless.count(name))
        throw InputError(path, "needs extension " + name + ", which is not supported");
    }
  }
  if (!root.contains("extensionsUsed")) return;
  for (const Json& item : root["extensionsUsed"]) {
    const std::string name = item;
    if (!supported.count(name)) log.push_back(path + ": extension " + name + " is ignored");
  }
}

void check_files(const Json& root, const std::string& path, bool binary) {
  for (const char* name : {"buffers", "images"}) {
    if (!root.contains(name)) continue;
    std::size_t i = 0;
    for (const Json& item : root[name]) {
      const std::string where = path + ": " + name + "[" + std::to_string(i) + "]";
      const bool buffer = !std::strcmp(name, "buffers");
      if (buffer && !(item.contains("byteLength") && item["byteLength"].is_number_unsigned() &&
                      item["byteLength"].get<std::uint64_t>() > 0))
        throw InputError(where, "byteLength must be a whole number above 0");
      if (item.contains("uri")) {
        if (!item["uri"].is_string()) throw InputError(where, "uri is not a string");
        const std::string uri = item["uri"];
        if (uri.substr(0, 5) != "data:") resource_path(folder_of(path), percent_decode(uri), where);
      } else if (buffer && !(binary && i == 0)) {
        throw InputError(where, "has no uri; only the first buffer of a .glb may do without");
      }
      ++i;
    }
  }
}

}  // namespace

GltfText find_gltf_text(const std::vector<std::uint8_t>& file, const std::string& path) {
  if (file.size() < 4 || std::memcmp(file.data(), "glTF", 4) != 0)
    return {reinterpret_cast<const char*>(file.data()), file.size(), false};
  if (file.size() < 20)
    throw InputError(path, "truncated .glb: " + std::to_string(file.size()) + " bytes, its header alone has 20");
  if (word(file, 4) != 2)
    throw InputError(path, "is .glb version " + std::to_string(word(file, 4)) + "; 2 can be read");
  const std::uint64_t length = word(file, 8);
  if (length > file.size())
    throw InputError(path,
                     "truncated .glb: " + std::to_string(file.size()) + " of " + std::to_string(length) + " bytes");
  std::uint64_t at = 12;
  GltfText text{nullptr, 0, true};
  for (int chunk = 0; at < length; ++chunk) {
    if (at + 8 > length)
      throw InputError(path, "broken .glb: no room for the header of chunk " + std::to_string(chunk));
    const std::uint64_t size = word(file, at);
    if (at + 8 + size > length)
      throw InputError(path, "broken .glb: chunk " + std::to_string(chunk) + " has " + std::to_string(size) +
                                 " bytes, the file ends before");
    if (chunk == 0) {
      if (word(file, at + 4) != 0x4E4F534Au) throw InputError(path, "broken .glb: its first chunk is not JSON");
      text.json = reinterpret_cast<const char*>(file.data() + at + 8);
      text.size = size;
    }
    at += 8 + size;
  }
  return text;
}

void check_gltf_json(const GltfText& text, const std::string& path, std::vector<std::string>& log) {
  check_depth(text, path);
  const Json root = parse(text, path);
  check_types(root, path);
  check_extensions(root, path, log);
  check_files(root, path, text.binary);
}

}  // namespace artu::sim
