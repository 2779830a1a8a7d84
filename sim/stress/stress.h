// The whole stress campaign: all cases with all subjects of the product.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/stress/result.h"

namespace artu::sim {

struct StressOptions {
  std::uint64_t rays = 200000;  // over all cases
  std::uint64_t seed = 1;
  std::string only;
  hw::PrecisionConfig precision;  // of box and triangle test; shading plays no part
  bool leaks_only = false;        // closed meshes, rays from inside through vertices and edges
};

struct StressReport {
  StressOptions options;
  std::vector<CaseResult> cases;
  std::vector<std::string> skipped;
};

using CaseDone = std::function<void()>;

/// `done` is called after each case of stress_cases(options.only).  Throws InputError for an unknown name.
StressReport run_stress(const StressOptions& options, const CaseDone& done);

/// One case of `rays` rays.
CaseResult run_case(const StressCase& name, std::uint64_t rays, const StressOptions& options);

}  // namespace artu::sim
