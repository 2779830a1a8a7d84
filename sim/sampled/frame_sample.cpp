#include "sim/sampled/frame_sample.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numeric>

#include "sim/sampled/frame_order.h"

namespace artu::sim {

double TotalEstimate::relative_error() const { return high == low ? 0 : (high - low) / 2 / value; }

FrameSample::FrameSample(std::vector<FrameCost> costs, std::uint64_t seed) : costs_(std::move(costs)) {
  for (std::size_t kind = 0; kind < frame_kinds; ++kind) {
    std::vector<std::uint32_t> members;
    for (std::uint32_t frame = 0; frame < frames(); ++frame) {
      if (costs_[frame].kind == static_cast<FrameKind>(kind)) members.push_back(frame);
    }
    if (members.empty()) continue;
    Stratum stratum;
    for (const std::uint32_t place : frame_order(static_cast<std::uint32_t>(members.size()), seed)) {
      stratum.order.push_back(members[place]);
      stratum.costs.push_back(costs_[members[place]].work);
    }
    strata_.push_back(std::move(stratum));
  }
}

std::vector<std::uint32_t> FrameSample::draw(std::uint32_t wanted) {
  const std::size_t before = sample_.size();
  estimators_.clear();
  for (Stratum& stratum : strata_) {
    const double part = static_cast<double>(stratum.order.size()) / frames();
    const auto share = static_cast<std::size_t>(std::lround(wanted * part));
    const std::size_t count = std::min(std::max(share, RegressionEstimator::fewest), stratum.order.size());
    for (; stratum.drawn < count; ++stratum.drawn) {
      stratum.places.push_back(sample_.size());
      sample_.push_back(stratum.order[stratum.drawn]);
    }
    std::vector<std::uint32_t> drawn(stratum.drawn);
    std::iota(drawn.begin(), drawn.end(), 0u);
    estimators_.emplace_back(stratum.costs, drawn);
  }
  // Rounding may have left all strata as they were.
  if (sample_.size() == before && drawn() < std::min(wanted, frames())) return draw(wanted + 1);
  return {sample_.begin() + static_cast<std::ptrdiff_t>(before), sample_.end()};
}

TotalEstimate FrameSample::total(const std::vector<double>& figures) const {
  double value = 0, variance = 0, squares = 0;
  for (std::size_t i = 0; i < strata_.size(); ++i) {
    std::vector<double> own;
    for (const std::size_t place : strata_[i].places) own.push_back(figures[place]);
    const RegressionEstimator::Total total = estimators_[i].total(own);
    value += total.value;
    variance += total.variance;
    if (total.variance > 0) squares += total.variance * total.variance / estimators_[i].freedom();
  }
  if (variance == 0) return {value, value, value};
  const double t = boost::math::quantile(boost::math::students_t(variance * variance / squares), 0.975);
  // What the sample has is there.
  const double seen = std::accumulate(figures.begin(), figures.end(), 0.0), half = t * std::sqrt(variance);
  value = std::max(value, seen);
  return {value, std::max(value - half, seen), value + half};
}

}  // namespace artu::sim
