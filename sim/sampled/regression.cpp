#include "sim/sampled/regression.h"

#include <numeric>
#include <stdexcept>

namespace artu::sim {

namespace {

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }
double sum(const std::vector<double>& values, const std::vector<double>& weights) {
  return std::inner_product(values.begin(), values.end(), weights.begin(), 0.0);
}

}  // namespace

RegressionEstimator::RegressionEstimator(const std::vector<double>& costs, const std::vector<double>& weights,
                                         const std::vector<std::uint32_t>& sample)
    : count_(static_cast<double>(costs.size())), drawn_(static_cast<double>(sample.size())), all_(sum(weights)) {
  if (sample.empty() || (sample.size() < fewest && sample.size() < costs.size())) {
    throw std::invalid_argument("a sample of so few has no error");
  }
  for (const std::uint32_t member : sample) {
    costs_.push_back(costs[member]);
    weights_.push_back(weights[member]);
  }
  weight_ = sum(weights_) / drawn_;
  for (double& weight : weights_) weight /= weight_;
  mean_cost_ = sum(costs, weights) / all_;
  sample_cost_ = sum(costs_, weights_) / drawn_;
  for (std::size_t i = 0; i < costs_.size(); ++i) {
    spread_ += weights_[i] * (costs_[i] - sample_cost_) * (costs_[i] - sample_cost_);
  }
  // Below this the slope would be one of rounding.
  sloped_ = spread_ > 1e-12 * drawn_ * sample_cost_ * sample_cost_;
}

RegressionEstimator::Total RegressionEstimator::total(const std::vector<double>& figures) const {
  const double seen = sum(figures, weights_), average = seen / drawn_;
  if (drawn_ == count_) return {seen * weight_, 0};
  double slope = 0;
  for (std::size_t i = 0; sloped_ && i < figures.size(); ++i)
    slope += weights_[i] * (costs_[i] - sample_cost_) * figures[i] / spread_;
  double squares = 0;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const double away = costs_[i] - sample_cost_, residual = figures[i] - average - slope * away;
    // What the line would miss it by if it had not seen it (HC3: MacKinnon and White 1985); 0 / 0 where it alone
    // makes the slope, which is then said by the others.
    const double unseen = 1 - weights_[i] * (1 / drawn_ + (sloped_ ? away * away / spread_ : 0));
    const double missed = weights_[i] * residual / unseen;
    if (unseen > 1e-9) squares += missed * missed;
  }
  const double distance = mean_cost_ - sample_cost_;
  const double spread = 1 / drawn_ + (sloped_ ? distance * distance / spread_ : 0);
  return {all_ * (average + slope * distance), all_ * all_ * squares / (drawn_ - 1) * spread * (1 - drawn_ / count_)};
}

}  // namespace artu::sim
