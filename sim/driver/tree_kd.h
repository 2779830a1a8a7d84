// kd-trees: space is divided by planes, and a triangle is referenced from every cell that its box touches.
#pragma once

#include <vector>

#include "sim/driver/tree.h"
#include "sim/driver/tree_box.h"

namespace artu::sim {

/// Fills root, nodes, order, stack and work; tree.lo and tree.hi hold the box of all `boxes`, which are at least one.
void lay_out_kd(const std::vector<Box>& boxes, const TreeRecipe& recipe, bool dynamic, Tree& tree);

}  // namespace artu::sim
