#include "sim/import/gltf_import.h"

#include "traces/error.h"

namespace artu::sim {

Model import_gltf(const std::string& path, std::vector<std::string>& log) {
  const GltfFile file = read_gltf(path, log);
  GltfAccessors accessors(file);
  Model model;
  const std::vector<GltfTexcoords> texcoords = import_gltf_materials(file, accessors, model, log);
  import_gltf_meshes(file, accessors, texcoords, model, log);
  import_gltf_cameras_and_lights(file, model, log);
  const std::vector<int> node_of = import_gltf_nodes(file, model);
  import_gltf_skins(file, accessors, node_of, model);
  import_gltf_clips(file, accessors, node_of, model, log);
  return model;
}

}  // namespace artu::sim
