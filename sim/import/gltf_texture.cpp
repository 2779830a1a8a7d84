#include "sim/import/gltf_texture.h"

#include "traces/error.h"

namespace artu::sim {
namespace {

constexpr std::uint64_t max_texture_bytes = std::uint64_t{1} << 30;

traces::Wrap wrap(int mode) {
  if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return traces::Wrap::clamp;
  return mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? traces::Wrap::mirror : traces::Wrap::repeat;
}

}  // namespace

const DecodedImage* GltfTextures::image(int texture, const std::string& where) {
  const int source = image_of(texture, where);
  if (source < 0) return nullptr;
  auto& slot = images_[source];
  if (!slot) {
    slot = decode(static_cast<std::size_t>(source));
    bytes_ += slot->rgba.size();
    if (bytes_ > max_texture_bytes) throw InputError(where, "the file's images are over 1 GiB when decoded");
  }
  return &*slot;
}

int GltfTextures::texture(int index, const std::string& where) {
  const DecodedImage* pixels = image(index, where);
  if (!pixels) return -1;
  const int sampler = file_.json.textures[static_cast<std::size_t>(index)].sampler;
  traces::Texture texture;
  if (sampler >= 0 && static_cast<std::size_t>(sampler) < file_.json.samplers.size()) {
    texture.wrap_u = wrap(file_.json.samplers[static_cast<std::size_t>(sampler)].wrapS);
    texture.wrap_v = wrap(file_.json.samplers[static_cast<std::size_t>(sampler)].wrapT);
  }
  const int source = image_of(index, where);
  const std::string key = std::to_string(source) + "/" + std::to_string(static_cast<int>(texture.wrap_u)) +
                          std::to_string(static_cast<int>(texture.wrap_v));
  const auto known = textures_.find(key);
  if (known != textures_.end()) return known->second;
  const tinygltf::Image& named = file_.json.images[static_cast<std::size_t>(source)];
  texture.name = !named.name.empty() ? named.name : "image " + std::to_string(source);
  texture.width = pixels->width;
  texture.height = pixels->height;
  texture.rgba = pixels->rgba;
  const int made = static_cast<int>(model_.textures.size());
  model_.textures.push_back(std::move(texture));
  return textures_[key] = made;
}

int GltfTextures::image_of(int texture, const std::string& where) {
  if (texture < 0) return -1;
  if (static_cast<std::size_t>(texture) >= file_.json.textures.size())
    throw InputError(where, "texture " + std::to_string(texture) + " does not exist; there are " +
                                std::to_string(file_.json.textures.size()));
  const int source = file_.json.textures[static_cast<std::size_t>(texture)].source;
  if (source < 0) {
    log_.push_back(where + ": texture " + std::to_string(texture) + " has no PNG or JPEG image and is left out");
    return -1;
  }
  if (static_cast<std::size_t>(source) >= file_.json.images.size())
    throw InputError(where, "image " + std::to_string(source) + " does not exist; there are " +
                                std::to_string(file_.json.images.size()));
  return source;
}

DecodedImage GltfTextures::decode(std::size_t index) {
  const tinygltf::Image& source = file_.json.images[index];
  const std::string where = file_.at("images[" + std::to_string(index) + "]");
  if (source.bufferView >= 0) {
    const GltfAccessors::Bytes bytes = accessors_.view(source.bufferView, where);
    return decode_image(bytes.data, bytes.size, where);
  }
  const auto& bytes = file_.image_bytes[index];
  return decode_image(bytes.data(), bytes.size(),
                      source.uri.empty() ? where : where + " (" + source.uri.substr(0, 200) + ")");
}

}  // namespace artu::sim
