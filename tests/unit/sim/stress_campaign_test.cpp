// The campaign passes what is sound and finds what is not: each rule of the contract, taken away, is seen.
#include <gtest/gtest.h>

#include "sim/stress/stress.h"
#include "unit/sim/stress_support.h"

namespace artu::sim {
namespace {

using testing::RuledBruteForce;
using testing::RuledWalker;
using testing::Rules;

struct Trial {
  Trial(StressGeometry what, std::uint64_t rays) : geometry(std::move(what)), triangles(corners_of(geometry)) {
    plan.rays = rays;
    laid = lay_down(geometry, hw::TreeKind::bvh2);
  }
  CaseResult run(const Subject& truth, const Subject& subject) const {
    Contest contest;
    contest.truth = &truth;
    contest.fast = {&subject};
    return Campaign({"sphere", placements()[0]}, geometry, triangles, contest, plan).run();
  }
  /// A walker by `rules` against the unit's brute force.
  CaseResult run(const Rules& rules) const { return run(*brute_force(triangles), RuledWalker(laid, rules)); }
  /// A walker by `rules` against brute force by the same: only the tree can make a difference.
  CaseResult run_against_itself(const Rules& rules) const {
    return run(RuledBruteForce(triangles, rules), RuledWalker(laid, rules));
  }

  StressGeometry geometry;
  std::vector<Corners> triangles;
  std::shared_ptr<const LaidDown> laid;
  CampaignPlan plan;
};

const Trial& sphere() {
  static const Trial trial(sphere_mesh(3), 20000);
  return trial;
}
const Trial& soup() {
  static const Trial trial(soup_mesh(600, 7), 20000);
  return trial;
}

TEST(StressCampaign, PassesASoundWalker) {
  for (const Trial* trial : {&sphere(), &soup()}) {
    const CaseResult result = trial->run(Rules{});
    EXPECT_EQ(result.mismatches(), 0u);
    EXPECT_EQ(result.leaks.happened, 0u);
    EXPECT_FALSE(result.first);
    EXPECT_GT(result.hits, result.rays / 4);
  }
  EXPECT_GT(sphere().run(Rules{}).leaks.tried, 1000u);
}

TEST(StressCampaign, SeesTheClampMissing) {
  Rules rules;
  rules.clamp = false;
  const CaseResult result = sphere().run(rules);
  EXPECT_GT(result.mismatches(), 0u);
  ASSERT_TRUE(result.first);
  EXPECT_NE(result.first->expected, result.first->found);
  EXPECT_GT(soup().run(rules).mismatches(), 0u);
}

TEST(StressCampaign, SeesThatWithoutTheClampTheTreeMatters) {
  Rules rules;
  rules.clamp = false;
  EXPECT_GT(sphere().run_against_itself(rules).mismatches() + soup().run_against_itself(rules).mismatches(), 0u);
}

TEST(StressCampaign, SeesThePaddingMissing) {
  Rules rules;
  rules.padding = rules.clamp_padding = 1;
  const CaseResult result = sphere().run(rules);
  EXPECT_GT(result.mismatches(), 0u);
}

TEST(StressCampaign, SeesThatWithoutPaddingAClosedMeshLeaks) {
  Rules rules;
  rules.padding = rules.clamp_padding = 1;
  const Trial box(box_mesh(8), 40000);
  EXPECT_GT(sphere().run_against_itself(rules).leaks.happened + box.run_against_itself(rules).leaks.happened, 0u);
}

TEST(StressCampaign, SeesThePaddingMissingInTheBoxesAlone) {
  Rules rules;
  rules.padding = 1;
  EXPECT_GT(sphere().run(rules).mismatches() + soup().run(rules).mismatches(), 0u);
}

TEST(StressCampaign, SeesRoundedProducts) {
  Rules rules;
  rules.exact_products = false;
  const CaseResult result = sphere().run(rules);
  EXPECT_GT(result.mismatches(), 0u);
}

TEST(StressCampaign, IsTheSameForTheSameSeed) {
  const StressCase one{"coincident", placements()[1]};
  StressOptions options;
  const CaseResult a = run_case(one, 500, options), b = run_case(one, 500, options);
  EXPECT_EQ(a.hits, b.hits);
  EXPECT_EQ(a.accuracy.t_ulps.quantile(1), b.accuracy.t_ulps.quantile(1));
  options.seed = 2;
  EXPECT_NE(run_case(one, 500, options).hits, a.hits);
}

TEST(StressCampaign, EveryMeshPassesInEveryPlacement) {
  for (const StressCase& one : stress_cases("")) {
    if (one.mesh == "bunny" || one.mesh == "sphere") continue;  // too slow with sanitizers
    const CaseResult result = run_case(one, 200, {});
    EXPECT_EQ(result.mismatches(), 0u) << one.name();
    EXPECT_EQ(result.leaks.happened, 0u) << one.name();
    if (one.mesh == "empty") {
      EXPECT_EQ(result.hits, 0u);
    } else {
      EXPECT_GT(result.hits, 0u) << one.name();
    }
  }
}

}  // namespace
}  // namespace artu::sim
