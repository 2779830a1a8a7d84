// Images and textures of a glTF file, decoded when first used.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/import/gltf_accessor.h"
#include "sim/import/image.h"
#include "sim/import/model.h"

namespace artu::sim {

/// Decodes each image at most once and makes a Model texture of each (image, wrap) pair that is used.
class GltfTextures {
 public:
  GltfTextures(const GltfFile& file, GltfAccessors& accessors, Model& model, std::vector<std::string>& log)
      : file_(file), accessors_(accessors), model_(model), log_(log) {}

  /// The image of a texture; null without one (index -1, or a format that is not read, with a log line).
  const DecodedImage* image(int texture, const std::string& where);
  /// Index into Model::textures, or -1.
  int texture(int index, const std::string& where);

 private:
  int image_of(int texture, const std::string& where);
  DecodedImage decode(std::size_t index);

  const GltfFile& file_;
  GltfAccessors& accessors_;
  Model& model_;
  std::vector<std::string>& log_;
  std::map<int, std::optional<DecodedImage>> images_;
  std::map<std::string, int> textures_;
  std::uint64_t bytes_ = 0;
};

}  // namespace artu::sim
