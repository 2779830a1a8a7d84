// What `artu sweep` prints.
#pragma once

#include <string>
#include <vector>

#include "sim/sweep/plan.h"
#include "sim/sweep/table.h"

namespace artu::sim {

/// What will be done: the points, the scenes, and each parameter with its values.
std::string describe(const SweepPoints& plan);

/// How the points ended, and those that are not dominated, with their objectives.
std::string summary_of(const SweepPoints& plan, const SweepTable& table, const std::vector<SweepResult>& results);

}  // namespace artu::sim
