// Where every node is at a time.
#pragma once

#include <vector>

#include "sim/import/model.h"

namespace artu::sim {

struct Pose {
  std::vector<glm::dmat4> world;             // one a node: node space to world space
  std::vector<std::vector<double>> weights;  // one a node: of the morph targets of its shape, if it has any
};

Pose pose_at(const Model& model, double time);

}  // namespace artu::sim
