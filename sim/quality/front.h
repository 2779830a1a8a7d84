// Policies at equal work: each one's points, interpolated at given traced shares.
#pragma once

#include <string>
#include <vector>

#include "sim/quality/sweep.h"

namespace artu::sim {

/// What a front says between its points.
struct FrontValue {
  std::array<double, area_count> psnr{};  // dB by Area; NaN where it cannot be said
  double flip = 0;                        // of the whole frame, the same
};

/// Of the policy's points, in the order of their traced share: linear between the two nearest.  NaN beyond the points,
/// and beside a point that has no error, or no pixel of the area.
FrontValue front_at(const std::vector<QualityRow>& rows, const std::string& policy, double traced_share);

/// The policies that have points, in their order.
std::vector<std::string> policies_of(const std::vector<QualityRow>& rows);

}  // namespace artu::sim
