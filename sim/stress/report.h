// A campaign's outcome as text and as JSON.
#pragma once

#include <string>

#include "sim/stress/stress.h"

namespace artu::sim {

using StressReports = std::vector<StressReport>;  // one for each format that was tried

/// All meshes of a placement as one result, and all placements of a mesh; in the order of the table.
std::vector<CaseResult> by_placement(const StressReport& report);
std::vector<CaseResult> by_mesh(const StressReport& report);

struct StressTotals {
  std::uint64_t rays = 0, hits = 0, secondary = 0, mismatches = 0, leaks = 0;
  std::size_t cases = 0;
  const Failure* first = nullptr;
  bool passed() const { return mismatches == 0 && leaks == 0; }
};
StressTotals totals_of(const StressReports& reports);
/// All cases as one result.
CaseResult sum_of(const StressReport& report);

/// Of one format: a row a case, the envelope and the accuracy; of several: a row a format.  Then the totals.
std::string format_table(const StressReports& reports);
std::string format_failure(const Failure& failure);  // with every bit
std::string format_case_list();
std::string format_json(const StressReports& reports);

}  // namespace artu::sim
