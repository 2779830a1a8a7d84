// Several models made into one.
#pragma once

#include "sim/import/model.h"

namespace artu::sim {

/// Appends `part` to `whole`, its roots below a new node `root`; returns the index of that node.  The indices of
/// part's nodes are then `result + 1 + n`, of its materials `result.materials + m`.
struct Appended {
  int root = 0;
  std::uint32_t materials = 0;
};
Appended append(Model& whole, const Model& part, const Node& root);

}  // namespace artu::sim
