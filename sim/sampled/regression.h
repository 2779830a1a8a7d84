// The total of a figure over all members of a population, from a sample of them and a cost that is known of all
// (regression estimator: Cochran, Sampling Techniques, 3rd edition, chapter 7).
#pragma once

#include <cstdint>
#include <vector>

namespace artu::sim {

class RegressionEstimator {
 public:
  static constexpr std::size_t fewest = 4;

  /// The costs of all, and which of them, each once, are in the sample: at least `fewest`, or all.
  RegressionEstimator(const std::vector<double>& costs, const std::vector<std::uint32_t>& sample);

  struct Total {
    double value = 0, variance = 0;
  };
  /// `figures` of the sample, in its order.
  Total total(const std::vector<double>& figures) const;
  /// Degrees of freedom of the variance; not where all are in the sample.
  double freedom() const { return drawn_ - (sloped_ ? 2 : 1); }

 private:
  double count_, drawn_, mean_cost_ = 0, sample_cost_ = 0, spread_ = 0;
  bool sloped_ = false;        // the costs differ enough to have a slope
  std::vector<double> costs_;  // of the sample
};

}  // namespace artu::sim
