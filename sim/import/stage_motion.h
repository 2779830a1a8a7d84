// The [[...key]] tables of a stage: rigid motion of a node.
#pragma once

#include <vector>

#include "sim/import/model.h"
#include "sim/import/stage_toml.h"

namespace artu::sim {

/// Rotation about x, then y, then z (fixed axes), in degrees.
glm::dquat euler(const glm::dvec3& degrees);

/// `position`, `rotation`, `scale` of a table, over `rest`.
Trs read_placement(const StageTable& table, const Trs& rest);

/// The table's [[key]]s as a player that moves `node`; nothing if there are none.  A key holds what it does not say
/// from the key before it, the first one from `rest`.
std::optional<Player> read_motion(const StageTable& table, int node, const Trs& rest, bool loop);

}  // namespace artu::sim
