// `sampled`: which frames are drawn, and whether what follows from them for all is right as often as it says.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "sim/sampled/frame_order.h"
#include "sim/sampled/sequence.h"

namespace artu::sim {
namespace {

using ::testing::Each;
using ::testing::IsEmpty;
using ::testing::SizeIs;

double total_of(const std::vector<double>& figures, const FrameSample& sample) {
  double sum = 0;
  for (const std::uint32_t frame : sample.sample()) sum += figures[frame];
  return sum;
}

TotalEstimate estimate(const std::vector<double>& figures, const FrameSample& sample) {
  std::vector<double> own;
  for (const std::uint32_t frame : sample.sample()) own.push_back(figures[frame]);
  return sample.total(own);
}

std::vector<FrameCost> built(const std::vector<double>& work) {
  std::vector<FrameCost> costs;
  for (const double w : work) costs.push_back({w, FrameKind::built});
  return costs;
}

TEST(FrameOrder, HasEachFrameOnceAndDependsOnTheSeedAlone) {
  for (const std::uint32_t count : {0u, 1u, 2u, 7u, 100u}) {
    const auto order = frame_order(count, 3);
    EXPECT_EQ(std::set<std::uint32_t>(order.begin(), order.end()).size(), count);
    EXPECT_THAT(order, SizeIs(count));
    EXPECT_THAT(order, Each(::testing::Lt(count)));
    EXPECT_EQ(order, frame_order(count, 3));
  }
  EXPECT_NE(frame_order(100, 1), frame_order(100, 2));
}

TEST(FrameOrder, ItsBeginningIsSpreadOverTheSequence) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const auto order = frame_order(640, seed);
    for (const std::uint32_t drawn : {2u, 4u, 8u, 16u}) {
      std::set<std::uint32_t> parts;
      for (std::uint32_t i = 0; i < drawn; ++i) parts.insert(order[i] * drawn / 640);
      EXPECT_EQ(parts.size(), drawn) << "seed " << seed;
    }
  }
}

TEST(FrameOrder, EveryFrameComesFirstAboutAsOften) {
  std::vector<int> first(16);
  for (std::uint64_t seed = 0; seed < 1600; ++seed) ++first[frame_order(16, seed)[0]];
  EXPECT_GT(*std::min_element(first.begin(), first.end()), 60);
  EXPECT_LT(*std::max_element(first.begin(), first.end()), 140);
}

TEST(Regression, WhatFollowsFromTheCostIsExact) {
  std::vector<double> work, figures;
  for (int i = 0; i < 50; ++i) {
    work.push_back(100 + i * i);
    figures.push_back(7 + 3 * work.back());
  }
  FrameSample sample(built(work), 1);
  sample.draw(8);
  const TotalEstimate e = estimate(figures, sample);
  double sum = 0;
  for (const double f : figures) sum += f;
  EXPECT_NEAR(e.value, sum, 1e-6 * sum);
  EXPECT_NEAR(e.high - e.low, 0, 1e-6 * sum);
}

TEST(Regression, OfEqualCostsItIsTheMean) {
  const std::vector<double> costs(10, 5.0);
  const RegressionEstimator estimator(costs, std::vector<double>(10, 1.0), {0, 1, 2, 3});
  const auto total = estimator.total({1, 2, 3, 4});
  EXPECT_DOUBLE_EQ(total.value, 25);
  // By hand: residuals 1.5 and 0.5, each over 1 - 1/4; N^2 / n (1 - n / N) of their squares' sum over 3.
  EXPECT_NEAR(total.variance, 100 / 4.0 * 0.6 * (5 * 16 / 9.0 / 3), 1e-9);
  EXPECT_EQ(estimator.freedom(), 3);
}

/// A member of weight 3 is as good as three that are equal and all in the sample.
TEST(Regression, AWeightIsANumberOfEqualMembers) {
  const std::vector<double> costs = {1, 2, 4, 5, 7, 9}, figures = {12, 17, 41, 48, 75};
  std::vector<double> weights = {3, 1, 2, 1, 1, 2}, many, values;
  std::vector<std::uint32_t> sample;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    for (int copy = 0; copy < weights[i]; ++copy) {
      if (i < figures.size()) {
        sample.push_back(static_cast<std::uint32_t>(many.size()));
        values.push_back(figures[i]);
      }
      many.push_back(costs[i]);
    }
  }
  const RegressionEstimator weighted(costs, weights, {0, 1, 2, 3, 4});
  const RegressionEstimator single(many, std::vector<double>(many.size(), 1.0), sample);
  EXPECT_NEAR(weighted.total(figures).value, single.total(values).value, 1e-9);
  EXPECT_GT(weighted.total(figures).variance, single.total(values).variance) << "copies are no more measurements";
  // Of all members: nothing is estimated.
  const RegressionEstimator all(costs, weights, {0, 1, 2, 3, 4, 5});
  EXPECT_DOUBLE_EQ(all.total({1, 1, 1, 1, 1, 10}).value, 28);
  EXPECT_EQ(all.total({1, 1, 1, 1, 1, 10}).variance, 0);
}

TEST(Regression, TooFewAreNoSample) {
  const std::vector<double> costs(10, 5.0);
  EXPECT_THROW(RegressionEstimator(costs, costs, {0, 1, 2}), std::invalid_argument);
  EXPECT_THROW(RegressionEstimator(costs, costs, {}), std::invalid_argument);
  EXPECT_NO_THROW(RegressionEstimator({1, 2}, {1, 1}, {0, 1}));
}

TEST(FrameSample, AllFramesAreNoEstimate) {
  std::vector<double> work, figures;
  for (int i = 0; i < 9; ++i) {
    work.push_back(i);
    figures.push_back((i * 37) % 11);
  }
  FrameSample sample(built(work), 1);
  sample.draw(9);
  const TotalEstimate e = estimate(figures, sample);
  EXPECT_EQ(e.value, total_of(figures, sample));
  EXPECT_EQ(e.low, e.value);
  EXPECT_EQ(e.high, e.value);
  EXPECT_EQ(e.relative_error(), 0);
}

TEST(FrameSample, FramesOfAnotherKindDoNotSpoilTheRest) {
  std::vector<FrameCost> costs = built(std::vector<double>(100, 50.0));
  std::vector<double> figures(100, 1000.0);
  costs[41].kind = FrameKind::nothing_built;
  figures[41] = 10;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    FrameSample sample(costs, seed);
    sample.draw(8);
    EXPECT_EQ(std::count(sample.sample().begin(), sample.sample().end(), 41u), 1);
    const TotalEstimate e = estimate(figures, sample);
    EXPECT_DOUBLE_EQ(e.value, 99010);
    EXPECT_EQ(e.high, e.low);
  }
}

TEST(FrameSample, GrowsByThoseThatWereNotThere) {
  std::vector<FrameCost> costs = built(std::vector<double>(40, 1.0));
  for (int i = 0; i < 13; ++i) costs[i * 3].kind = FrameKind::refitted;
  FrameSample sample(costs, 5);
  std::set<std::uint32_t> seen;
  for (std::uint32_t wanted = 8; sample.drawn() < 40; wanted = sample.drawn() + 1) {
    const auto next = sample.draw(wanted);
    EXPECT_GE(sample.drawn(), std::min(wanted, 40u));
    EXPECT_FALSE(next.empty());
    for (const std::uint32_t frame : next) EXPECT_TRUE(seen.insert(frame).second);
  }
  EXPECT_THAT(sample.draw(40), IsEmpty());
}

FrameDigest digest(int of) {
  FrameDigest d{};
  d[0] = static_cast<char>(1 + of);
  return d;
}

TEST(FrameSample, EqualFramesAreDrawnOnceAndWeighAsMany) {
  std::vector<FrameCost> costs;
  std::vector<double> figures;
  double sum = 0;
  for (int i = 0; i < 130; ++i) {  // 50 frames, of which the first 30 come three times, the others twice
    costs.push_back({100.0 + i % 50, FrameKind::built, digest(i % 50)});
    figures.push_back(7000 + 3 * costs.back().work + (i % 50) % 7);
    sum += figures.back();
  }
  FrameSample sample(costs, 3);
  EXPECT_EQ(sample.frames(), 130u);
  EXPECT_EQ(sample.different_frames(), 50u);
  sample.draw(8);
  EXPECT_EQ(sample.drawn(), 8u);
  for (const std::uint32_t frame : sample.sample()) EXPECT_LT(frame, 50u);
  const TotalEstimate e = estimate(figures, sample);
  EXPECT_LE(e.low, sum);
  EXPECT_GE(e.high, sum);
  sample.draw(130);
  EXPECT_EQ(sample.drawn(), 50u);
  EXPECT_NEAR(estimate(figures, sample).value, sum, 1e-9 * sum);
  EXPECT_EQ(estimate(figures, sample).relative_error(), 0);
}

TEST(FrameSample, AFrameThatIsAQuarterOfItsKindIsAlwaysDrawn) {
  std::vector<FrameCost> costs = built(std::vector<double>(60, 1.0));
  for (std::size_t i = 20; i < 40; ++i) costs[i].digest = digest(0);
  std::vector<double> figures(60, 500.0);
  for (std::size_t i = 20; i < 40; ++i) figures[i] = 90;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    FrameSample sample(costs, seed);
    sample.draw(8);
    EXPECT_EQ(std::count(sample.sample().begin(), sample.sample().end(), 20u), 1);
    EXPECT_DOUBLE_EQ(estimate(figures, sample).value, 40 * 500 + 20 * 90);
    EXPECT_EQ(estimate(figures, sample).relative_error(), 0);
  }
}

/// Costs that go with the figures more or less, and a figure that drifts.
TEST(FrameSample, TheIntervalHoldsTheValueAsOftenAsItSays) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> noise(0, 1);
  int covered = 0, trials = 0;
  double worst_mean = 0;
  for (int population = 0; population < 20; ++population) {
    std::vector<double> work, figures;
    double sum = 0;
    for (int i = 0; i < 200; ++i) {
      work.push_back(1000 + 300 * std::sin(i * 0.05 * (population + 1)) + 20 * noise(random));
      figures.push_back(5000 + 40 * work.back() + 800 * noise(random) + 10.0 * i);
      sum += figures.back();
    }
    double error = 0;
    for (std::uint64_t seed = 0; seed < 50; ++seed, ++trials) {
      FrameSample sample(built(work), seed);
      sample.draw(8);
      const TotalEstimate e = estimate(figures, sample);
      covered += e.low <= sum && sum <= e.high ? 1 : 0;
      error += std::abs(e.value / sum - 1) / 50;
    }
    worst_mean = std::max(worst_mean, error);
  }
  EXPECT_GE(covered, trials * 93 / 100);
  EXPECT_LE(covered, trials * 995 / 1000);  // and it is not simply wide
  EXPECT_LT(worst_mean, 0.02);
}

TEST(SampleSize, FollowsShareOrError) {
  SampleSize share;
  share.share = 0.1;
  EXPECT_EQ(share.first(300), 30u);
  EXPECT_EQ(share.first(10), 4u);
  EXPECT_EQ(share.first(3), 3u);
  EXPECT_EQ(share.needed(300, 30, 0.5), 30u);
  const SampleSize target;
  EXPECT_EQ(target.first(300), 8u);
  EXPECT_EQ(target.needed(300, 8, 0.01), 8u);
  EXPECT_EQ(target.needed(300, 8, 0.0101), 9u);
  EXPECT_EQ(target.needed(300, 8, 0.012), 12u);
  EXPECT_EQ(target.needed(300, 8, 5.0), 16u);
  EXPECT_EQ(target.needed(10, 8, 5.0), 10u);
}

}  // namespace
}  // namespace artu::sim
