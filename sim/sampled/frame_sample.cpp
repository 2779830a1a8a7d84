#include "sim/sampled/frame_sample.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>

#include "sim/sampled/frame_order.h"

namespace artu::sim {

double TotalEstimate::relative_error() const { return high == low ? 0 : (high - low) / 2 / value; }

FrameSample::FrameSample(const std::vector<FrameCost>& costs, std::uint64_t seed)
    : frames_(static_cast<std::uint32_t>(costs.size())) {
  std::array<std::vector<Member>, frame_kinds> kinds;
  std::array<std::map<FrameDigest, std::size_t>, frame_kinds> known;  // places among those of their kind
  for (std::uint32_t frame = 0; frame < frames_; ++frame) {
    const auto kind = static_cast<std::size_t>(costs[frame].kind);
    std::vector<Member>& members = kinds[kind];
    const FrameDigest& digest = costs[frame].digest;
    if (digest != FrameDigest{}) {
      const auto [place, is_new] = known[kind].try_emplace(digest, members.size());
      if (!is_new) {
        ++members[place->second].weight;
        continue;
      }
    }
    members.push_back({frame, costs[frame].work, 1});
    ++different_;
  }
  for (const std::vector<Member>& members : kinds) {
    double all = 0;
    for (const Member& member : members) all += member.weight;
    const auto is_heavy = [&](const Member& m) { return m.weight * RegressionEstimator::fewest >= all; };
    std::vector<Member> heavy, others;
    std::partition_copy(members.begin(), members.end(), std::back_inserter(heavy), std::back_inserter(others),
                        is_heavy);
    add_stratum(heavy, seed);
    add_stratum(others, seed);
  }
}

void FrameSample::add_stratum(const std::vector<Member>& members, std::uint64_t seed) {
  if (members.empty()) return;
  Stratum stratum;
  for (const std::uint32_t place : frame_order(static_cast<std::uint32_t>(members.size()), seed)) {
    stratum.order.push_back(members[place].frame);
    stratum.costs.push_back(members[place].work);
    stratum.weights.push_back(members[place].weight);
  }
  strata_.push_back(std::move(stratum));
}

std::vector<std::uint32_t> FrameSample::draw(std::uint32_t wanted) {
  const std::size_t before = sample_.size();
  estimators_.clear();
  for (Stratum& stratum : strata_) {
    const double part = static_cast<double>(stratum.order.size()) / different_;
    const auto share = static_cast<std::size_t>(std::lround(wanted * part));
    const std::size_t count = std::min(std::max(share, RegressionEstimator::fewest), stratum.order.size());
    for (; stratum.drawn < count; ++stratum.drawn) {
      stratum.places.push_back(sample_.size());
      sample_.push_back(stratum.order[stratum.drawn]);
      weights_.push_back(stratum.weights[stratum.drawn]);
    }
    std::vector<std::uint32_t> drawn(stratum.drawn);
    std::iota(drawn.begin(), drawn.end(), 0u);
    estimators_.emplace_back(stratum.costs, stratum.weights, drawn);
  }
  // Rounding may have left all strata as they were.
  if (sample_.size() == before && drawn() < std::min(wanted, different_)) return draw(wanted + 1);
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
  const double seen = std::inner_product(figures.begin(), figures.end(), weights_.begin(), 0.0);
  const double half = t * std::sqrt(variance);
  value = std::max(value, seen);
  return {value, std::max(value - half, seen), value + half};
}

}  // namespace artu::sim
