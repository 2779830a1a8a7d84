// The parameters that relieve what binds, each a step further.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "sim/explain/finding.h"
#include "sim/report/numbers.h"

namespace artu::sim {

struct Step {
  std::string parameter;
  std::string to;
  std::set<Resource> relieves = {};  // needs that can fall to nothing, since there are fewer requests
  double at_most = 2;                // the passes become this much faster at most; 0: no such limit
  double build_saved = 0;            // cycles of the tree's build that can go at most
  double build_saved_far = 0;        // the same, however far it is turned
  double flush_left = 1;             // share of the write-back that stays
  bool shortens_start = false;
};

/// The most direct first; some may not be possible.
std::vector<Step> steps_for(const Finding& finding, const Accounting& account, const Totals& totals,
                            const hw::UnitConfig& unit);

}  // namespace artu::sim
