// A BVH's boxes made anew for triangles that have moved; its nodes and the order of its triangles stay.
#pragma once

#include "sim/driver/tree.h"

namespace artu::sim {

/// `tree` is a BVH over a mesh of as many triangles.
void refit(const traces::Mesh& mesh, Tree& tree);

}  // namespace artu::sim
