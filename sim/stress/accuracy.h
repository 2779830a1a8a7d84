// The unit's numbers and decisions against exact arithmetic.
#pragma once

#include "sim/stress/rays.h"
#include "sim/stress/result.h"

namespace artu::sim {

/// Nearer to an edge than this share of the triangle's height, no promise is measured.
inline constexpr double edge_margin = 1e-3;

/// A hit's t, u, v, and whether exact arithmetic has it as well; `size` is the model's.
void measure_hit(const StressRay& ray, const Answer& answer, const Corners& triangle, float size, Accuracy& out);
/// Whether hw::intersect decides as exact arithmetic does.
void measure_decision(const hw::Ray& ray, const Corners& triangle, float size, Accuracy& out);

}  // namespace artu::sim
