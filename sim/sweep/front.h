// Points that no other point is better than in every objective.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/sweep/plan.h"
#include "sim/sweep/table.h"

namespace artu::sim {

/// The places, in the table, of the points that are not dominated by a point of the same scene: none is as good in
/// every objective and better in one.  With a margin: none is better by more than that share in every objective; so
/// points that are nearly on the front are there too.  Points without the figures, and those that are not `ok`, are not
/// on it.
std::vector<std::size_t> front_of(const SweepTable& table, const std::vector<Objective>& objectives, double margin = 0);

}  // namespace artu::sim
