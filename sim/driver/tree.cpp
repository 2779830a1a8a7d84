#include "sim/driver/tree.h"

#include "sim/driver/tree_bvh2.h"
#include "sim/driver/tree_kd.h"
#include "sim/driver/tree_wide.h"
#include "traces/error.h"

namespace artu::sim {

Tree build_tree(const traces::Mesh& mesh, hw::TreeKind kind, bool dynamic, const std::string& where) {
  Tree tree;
  tree.kind = kind;
  const std::size_t count = mesh.triangle_count();
  if (count == 0) return tree;
  if (count > hw::NodeReference::maximum_triangles) {
    throw InputError(where, std::to_string(count) + " triangles; the unit can address " +
                                std::to_string(hw::NodeReference::maximum_triangles) + " of a class");
  }
  std::vector<Box> boxes;
  boxes.reserve(count);
  for (std::size_t i = 0; i < count; ++i) boxes.push_back(triangle_box(mesh, i));
  Box all = boxes[0];
  for (const Box& box : boxes) grow(all, box);
  tree.lo = all.lo;
  tree.hi = all.hi;
  tree.order.reserve(count);
  switch (kind) {
    case hw::TreeKind::bvh2:
      lay_out_bvh2(BinaryTree(boxes), dynamic, tree);
      break;
    case hw::TreeKind::bvh4:
      lay_out_wide<4>(BinaryTree(boxes), dynamic, tree);
      break;
    case hw::TreeKind::bvh8:
      lay_out_wide<8>(BinaryTree(boxes), dynamic, tree);
      break;
    case hw::TreeKind::kd:
      lay_out_kd(boxes, dynamic, tree);
      break;
  }
  return tree;
}

}  // namespace artu::sim
