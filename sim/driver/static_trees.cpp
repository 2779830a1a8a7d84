#include "sim/driver/static_trees.h"

namespace artu::sim {

Tree build_static_tree(const traces::Scene& scene, const hw::AccelConfig& accel) {
  return build_tree(scene.static_geometry, {accel.static_kind, accel.leaf_size, {}}, false,
                    scene.name + ": static geometry");
}

const Tree& StaticTrees::of(const hw::AccelConfig& accel) {
  const std::pair key(accel.static_kind, accel.leaf_size);
  const auto known = trees_.find(key);
  return known != trees_.end() ? known->second : trees_.emplace(key, build_static_tree(scene_, accel)).first->second;
}

}  // namespace artu::sim
