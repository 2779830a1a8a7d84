#include "sim/sweep/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "sim/config/text.h"

namespace artu::sim {
namespace {

/// From low to high, both as they are on the scale of the axis.
double between(const Axis& axis, double low, double high, double share) {
  if (!axis.logarithmic) return low + (high - low) * share;
  return std::exp(std::log(low) + (std::log(high) - std::log(low)) * share);
}

}  // namespace

std::string value_at(const Axis& axis, double share) {
  if (!axis.is_interval()) {
    const auto count = static_cast<double>(axis.values.size());
    return axis.values[std::min(axis.values.size() - 1, static_cast<std::size_t>(count * share))];
  }
  if (axis.parameter.kind == ParameterKind::real) {
    // Six digits are read by people, and hide the last bit of exp(), which differs from library to library.
    const std::string text = fmt::format("{:.6g}", between(axis, axis.low, axis.high, share));
    return real_text(static_cast<float>(std::clamp(std::strtod(text.c_str(), nullptr), axis.low, axis.high)));
  }
  if (axis.parameter.power_of_two) {
    const double low = std::log2(axis.low), count = std::log2(axis.high) - low + 1;
    return fmt::format("{:.0f}", std::exp2(std::min(low + std::floor(count * share), std::log2(axis.high))));
  }
  // The part of a step hides the last bit here.
  const double value = between(axis, axis.low, axis.high + 1, share) * (1 + 1e-12);
  return fmt::format("{:.0f}", std::min(axis.high, std::floor(value)));
}

}  // namespace artu::sim
