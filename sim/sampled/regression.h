// The total of a figure over all members of a population, from a sample of them and a cost that is known of all
// (regression estimator: Cochran, Sampling Techniques, 3rd edition, chapter 7).  A member may stand for several that
// are equal to it: its weight is their number, and the line is that of all of them.
#pragma once

#include <cstdint>
#include <vector>

namespace artu::sim {

class RegressionEstimator {
 public:
  static constexpr std::size_t fewest = 4;

  /// The costs and weights of all, and which of them, each once, are in the sample: at least `fewest`, or all.
  RegressionEstimator(const std::vector<double>& costs, const std::vector<double>& weights,
                      const std::vector<std::uint32_t>& sample);

  struct Total {
    double value = 0, variance = 0;
  };
  /// `figures` of the sample, in its order.
  Total total(const std::vector<double>& figures) const;
  /// Degrees of freedom of the variance; not where all are in the sample.
  double freedom() const { return drawn_ - (sloped_ ? 2 : 1); }

 private:
  double count_, drawn_, all_;                                        // members, those in the sample, the weights' sum
  double weight_ = 0, mean_cost_ = 0, sample_cost_ = 0, spread_ = 0;  // weight_: mean of the sample
  bool sloped_ = false;                                               // the costs differ enough to have a slope
  std::vector<double> costs_, weights_;                               // of the sample; weights with a mean of 1
};

}  // namespace artu::sim
