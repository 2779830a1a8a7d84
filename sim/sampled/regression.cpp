#include "sim/sampled/regression.h"

#include <numeric>
#include <stdexcept>

namespace artu::sim {

namespace {
double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }
}  // namespace

RegressionEstimator::RegressionEstimator(const std::vector<double>& costs, const std::vector<std::uint32_t>& sample)
    : count_(static_cast<double>(costs.size())), drawn_(static_cast<double>(sample.size())) {
  if (sample.empty() || (sample.size() < fewest && sample.size() < costs.size())) {
    throw std::invalid_argument("a sample of so few has no error");
  }
  for (const std::uint32_t member : sample) costs_.push_back(costs[member]);
  mean_cost_ = sum(costs) / count_;
  sample_cost_ = sum(costs_) / drawn_;
  for (const double cost : costs_) spread_ += (cost - sample_cost_) * (cost - sample_cost_);
  // Below this the slope would be one of rounding.
  sloped_ = spread_ > 1e-12 * drawn_ * sample_cost_ * sample_cost_;
}

RegressionEstimator::Total RegressionEstimator::total(const std::vector<double>& figures) const {
  const double seen = sum(figures), average = seen / drawn_;
  if (drawn_ == count_) return {seen, 0};
  double slope = 0;
  for (std::size_t i = 0; sloped_ && i < figures.size(); ++i)
    slope += (costs_[i] - sample_cost_) * figures[i] / spread_;
  double squares = 0;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const double away = costs_[i] - sample_cost_, residual = figures[i] - average - slope * away;
    // What the line would miss it by if it had not seen it (HC3: MacKinnon and White 1985); 0 / 0 where it alone
    // makes the slope, which is then said by the others.
    const double unseen = 1 - 1 / drawn_ - (sloped_ ? away * away / spread_ : 0);
    if (unseen > 1e-9) squares += residual * residual / (unseen * unseen);
  }
  const double distance = mean_cost_ - sample_cost_;
  const double spread = 1 / drawn_ + (sloped_ ? distance * distance / spread_ : 0);
  return {count_ * (average + slope * distance),
          count_ * count_ * squares / (drawn_ - 1) * spread * (1 - drawn_ / count_)};
}

}  // namespace artu::sim
