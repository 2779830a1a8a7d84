#include "sim/driver/tree.h"

#include <stdexcept>

#include "sim/driver/tree_bvh2.h"
#include "sim/driver/tree_kd.h"
#include "sim/driver/tree_wide.h"
#include "traces/error.h"

namespace artu::sim {

namespace {

void lay_out(const BinaryTree& binary, bool dynamic, Tree& tree) {
  if (tree.kind == hw::TreeKind::bvh2) {
    lay_out_bvh2(binary, dynamic, tree);
  } else if (tree.kind == hw::TreeKind::bvh4) {
    lay_out_wide<4>(binary, dynamic, tree);
  } else {
    lay_out_wide<8>(binary, dynamic, tree);
  }
}

}  // namespace

Tree build_tree(const traces::Mesh& mesh, const TreeRecipe& recipe, bool dynamic, const std::string& where) {
  Tree tree;
  tree.kind = recipe.kind;
  const bool kd = recipe.kind == hw::TreeKind::kd;
  if (kd && recipe.builder.algorithm != hw::BuildAlgorithm::sah)
    throw std::invalid_argument("a kd-tree is built by SAH");
  const std::size_t count = mesh.triangle_count();
  if (count == 0) return tree;
  if (count > hw::NodeReference::maximum_triangles) {
    throw InputError(where, std::to_string(count) + " triangles; the unit can address " +
                                std::to_string(hw::NodeReference::maximum_triangles) + " of a class");
  }
  const std::vector<Box> boxes = triangle_boxes(mesh);
  Box all = boxes[0];
  for (const Box& box : boxes) grow(all, box);
  tree.lo = all.lo;
  tree.hi = all.hi;
  tree.order.reserve(count);
  if (kd) {
    lay_out_kd(boxes, recipe, dynamic, tree);
  } else {
    const BinaryTree binary(boxes, recipe);
    lay_out(binary, dynamic, tree);
    tree.work = work_of(binary.root(), recipe.builder.triangles_per_pass);
  }
  return tree;
}

}  // namespace artu::sim
