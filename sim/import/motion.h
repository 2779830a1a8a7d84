// Which geometry goes into the static tree and which into the dynamic one.
#pragma once

#include <vector>

#include "sim/import/model.h"

namespace artu::sim {

/// One a node: whether an animation that plays can move the geometry of this node in world space.
std::vector<char> dynamic_nodes(const Model& model);

}  // namespace artu::sim
