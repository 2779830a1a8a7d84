// A parameter that a sweep varies: the values that it is given, or the interval that they are drawn from.
#pragma once

#include <string>
#include <vector>

#include "sim/config/parameter_list.h"

namespace artu::sim {

struct Axis {
  ParameterInfo parameter;
  std::string place;                // FILE:LINE
  std::string base;                 // the value outside of the sweep, as TOML
  std::vector<std::string> values;  // as TOML; none: an interval
  double low = 0, high = 0;         // inclusive; in the parameter's unit
  bool logarithmic = false;

  bool is_interval() const { return values.empty(); }
};

/// The value at `share`, 0 <= share < 1, of the axis: each of its values, integers or powers of two has an equal part;
/// of reals, and of logarithms, the share itself.  As TOML.  Reals are rounded to six digits.
std::string value_at(const Axis& axis, double share);

}  // namespace artu::sim
