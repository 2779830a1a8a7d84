#include "sim/compare/golden_settings.h"

namespace artu::sim {

ref::Settings golden_settings(const hw::UnitConfig& unit) {
  const hw::SelectiveConfig& from = unit.selective;
  ref::Settings to;
  to.selective = from.enabled;
  to.adaptive = from.adaptive;
  switch (from.magnitude) {
    case hw::Magnitude::fixed:
      to.magnitude = ref::Magnitude::fixed;
      break;
    case hw::Magnitude::proportional:
      to.magnitude = ref::Magnitude::proportional;
      break;
    case hw::Magnitude::progressive:
      to.magnitude = ref::Magnitude::progressive;
      break;
  }
  to.reference = static_cast<int>(from.reference);
  to.minimum = static_cast<int>(from.minimum);
  to.maximum = static_cast<int>(from.maximum);
  to.step = static_cast<int>(from.step);
  for (std::size_t i = 0; i < to.table.size(); ++i) to.table[i] = static_cast<int>(from.table[i]);
  to.max_depth = unit.shading.max_depth;
  to.min_weight = unit.shading.min_weight;
  to.precision = {static_cast<int>(unit.precision.box), static_cast<int>(unit.precision.triangle),
                  static_cast<int>(unit.precision.shading)};
  return to;
}

}  // namespace artu::sim
