#include "sim/precision/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace artu::sim {

PlotAxis::PlotAxis(const std::vector<double>& values) {
  const auto [lo, hi] = std::minmax_element(values.begin(), values.end());
  logarithmic_ = *hi > 4 * *lo;
  // Room for the points at either end and their labels.
  const double from = scaled(*lo), to = scaled(*hi);
  const double margin = to > from ? 0.08 * (to - from) : 0.2 * std::fabs(to);
  lo_ = logarithmic_ ? std::exp(from - margin) : from - margin;
  hi_ = logarithmic_ ? std::exp(to + margin) : to + margin;
}

double PlotAxis::scaled(double value) const { return logarithmic_ ? std::log(value) : value; }

double PlotAxis::position(double value) const { return (scaled(value) - scaled(lo_)) / (scaled(hi_) - scaled(lo_)); }

std::string PlotAxis::commands(char name) const {
  std::string text = fmt::format("set {}range [{:.6g}:{:.6g}]\n", name, lo_, hi_);
  if (!logarithmic_) return fmt::format("unset logscale {0}\nset {0}tics autofreq\n", name) + text;
  // 1, 2 and 5 of each decade where there are few of them, else 1 alone.
  const bool few = hi_ / lo_ < 300;
  std::string tics;
  for (int decade = static_cast<int>(std::floor(std::log10(lo_))); std::pow(10, decade) < hi_; ++decade) {
    for (const int step : {1, 2, 5}) {
      const double value = step * std::pow(10, decade);
      if (value < lo_ || value > hi_ || (step > 1 && !few)) continue;
      tics += fmt::format("{}{:.6g}", tics.empty() ? "" : ", ", value);
    }
  }
  return fmt::format("set logscale {0}\nset {0}tics ({1})\n", name, tics) + text;
}

}  // namespace artu::sim
