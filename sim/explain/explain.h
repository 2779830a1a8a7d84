// The bottleneck of a run, with the numbers behind it, and which parameter to turn next: docs/explain.md.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/explain/advice.h"
#include "sim/explain/finding.h"

namespace artu::sim {

struct Explanation {
  std::uint64_t frames = 1;
  Accounting account;
  std::vector<Finding> found;           // what binds; more than one: they tie
  std::vector<Advice> advice;           // the first of each finding, then the others
  std::vector<std::uint64_t> measured;  // cycles with each advice taken, where that was simulated
};

/// Throws InputError for a fidelity that has not counted what every cycle went for; `where` has the totals from.
void require_exact(Fidelity fidelity, const std::string& where);

/// Of totals that are exact; throws InputError for others.
Explanation explain(const Totals& totals, const hw::UnitConfig& unit);

/// Five lines, and one for each advice that was measured.
std::string format_explanation(const Explanation& explanation);
std::string explanation_json(const Explanation& explanation);

}  // namespace artu::sim
