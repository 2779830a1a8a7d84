// The trees of a scene's static geometry, each built once for all simulators of the scene.
#pragma once

#include <map>
#include <utility>

#include "sim/driver/tree.h"
#include "traces/frame.h"

namespace artu::sim {

class StaticTrees {
 public:
  /// `scene` must outlive it.
  explicit StaticTrees(const traces::Scene& scene) : scene_(scene) {}
  /// Built when it is first asked for.  Throws as build_tree does.
  const Tree& of(const hw::AccelConfig& accel);

 private:
  const traces::Scene& scene_;
  std::map<std::pair<hw::TreeKind, std::uint32_t>, Tree> trees_;  // by kind and leaf size
};

/// Static geometry is built by the driver itself, so by SAH.
Tree build_static_tree(const traces::Scene& scene, const hw::AccelConfig& accel);

}  // namespace artu::sim
