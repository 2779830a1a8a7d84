// The rays that leave a hit: do they hit the triangle they begin on?
#pragma once

#include <array>

#include "hw/datapath/hit_point.h"
#include "sim/stress/geometry.h"
#include "sim/stress/random.h"

namespace artu::sim {

struct SecondaryRays {
  std::array<hw::Ray, 3> out;  // from Pout: twice into the hemisphere over the surface, and the mirror direction
  std::array<hw::Ray, 2> in;   // from Pin: into the hemisphere below, and straight on
  bool front = true;           // the ray came from where the winding's normal points
};

/// By a unit with these formats.
SecondaryRays secondary_rays(const hw::Ray& from, const hw::TriangleHit& hit, const Corners& triangle,
                             const hw::PrecisionConfig& precision, Random& random);

}  // namespace artu::sim
