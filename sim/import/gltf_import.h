// glTF 2.0 into a Model.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/import/gltf_accessor.h"
#include "sim/import/model.h"

namespace artu::sim {

/// Throws InputError.
Model import_gltf(const std::string& path, std::vector<std::string>& log);

// The steps of it, in order; each fills its part of `model`.

/// What a mesh must know of its material: which texture coordinates to read, and how they are transformed.
struct GltfTexcoords {
  int set = 0;
  bool textured = false;
  double offset[2] = {0, 0}, scale[2] = {1, 1}, rotation = 0;
};

/// One a glTF material, plus the default material as the last one.
std::vector<GltfTexcoords> import_gltf_materials(const GltfFile& file, GltfAccessors& accessors, Model& model,
                                                 std::vector<std::string>& log);
void import_gltf_meshes(const GltfFile& file, GltfAccessors& accessors, const std::vector<GltfTexcoords>& texcoords,
                        Model& model, std::vector<std::string>& log);
/// Returns the Model's node for each of the file's.
std::vector<int> import_gltf_nodes(const GltfFile& file, Model& model);
void import_gltf_skins(const GltfFile& file, GltfAccessors& accessors, const std::vector<int>& node_of, Model& model);
void import_gltf_cameras_and_lights(const GltfFile& file, Model& model, std::vector<std::string>& log);
void import_gltf_clips(const GltfFile& file, GltfAccessors& accessors, const std::vector<int>& node_of, Model& model,
                       std::vector<std::string>& log);

}  // namespace artu::sim
