// The unit's numbers and decisions against exact arithmetic.
#pragma once

#include "sim/stress/rays.h"
#include "sim/stress/result.h"

namespace artu::sim {

/// Nearer to an edge than this share of the triangle's height, no promise is measured.
inline constexpr double edge_margin = 1e-3;

/// What errors are measured in: the model's size, and the stored fraction bits of the triangle test.
struct Scale {
  float size;
  int triangle_bits;
};

/// A hit's t, u, v, and whether exact arithmetic has it as well.
void measure_hit(const StressRay& ray, const Answer& answer, const Corners& triangle, Scale scale, Accuracy& out);
/// Whether the unit's triangle test decides as exact arithmetic does.
void measure_decision(const hw::HitTests& tests, const hw::Ray& ray, const Corners& triangle, Scale scale,
                      Accuracy& out);

}  // namespace artu::sim
