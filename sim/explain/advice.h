// Which parameter to turn next, by one step, and how much that can help at most.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/explain/finding.h"
#include "sim/report/numbers.h"

namespace artu::sim {

struct Advice {
  std::string parameter;  // core.box_testers
  std::string from, to;   // as in a file
  hw::UnitConfig unit;    // with it turned
  double floor = 0;       // cycles below which the run cannot come with it, by the accounting
  double far = 0;         // the same, however far it is turned
  std::string then;       // what the run cannot come below then: "the L2 banks"
};

/// The parameter's value as in a file.  Throws std::logic_error for a path that is none.
std::string value_of(const hw::UnitConfig& unit, const std::string& parameter);

/// The unit with one parameter changed; nothing where its range or another parameter does not allow it.
std::optional<hw::UnitConfig> with(const hw::UnitConfig& unit, const std::string& parameter, const std::string& value);

/// What would relieve the finding, the most direct first; three at most, none where all that would is fixed, or at its
/// end, or cannot help.
std::vector<Advice> advice_on(const Finding& finding, const Totals& totals, const hw::UnitConfig& unit);

}  // namespace artu::sim
