// Wavefront OBJ with MTL into a Model of one node.
#pragma once

#include <string>
#include <vector>

#include "sim/import/model.h"

namespace artu::sim {

/// Throws InputError.
Model import_obj(const std::string& path, std::vector<std::string>& log);

/// Normals of triangle corners from the shape alone: at a vertex, the mean (by area) of the faces around it that
/// bend less than the crease angle of 60 degrees from the corner's own face.
std::vector<glm::vec3> crease_normals(const std::vector<glm::vec3>& positions,
                                      const std::vector<std::uint32_t>& indices);

}  // namespace artu::sim
