// The apparatus claims of KR 10-2537319 B1, a test each: which block does it.  The method's are in claims_test.cpp.
#include "golden/candidates.h"

namespace artu::golden_tests {
namespace {

constexpr std::uint64_t samples = 33 * 25, candidates = 65 * 49 - samples;

Rendered exact(const hw::UnitConfig& config = {}) {
  Rendered r = run(make_scene(attention_recipe()), config);
  expect_exact(r);
  return r;
}

// "A first rendering unit that determines for each sampling pixel whether its primary ray hits, while it renders a
// first image at a first resolution; and a second rendering unit that repeatedly performs, while it renders a second
// image at a second, higher resolution, for each of the candidate pixels between the sampling pixels, an adaptive
// threshold adjustment by the hit frequency of the surrounding pixels, and selective rendering by the adjusted
// threshold [...]"
TEST(Claim, C10_AFirstAndASecondRenderingUnit) {
  // With passes that overlap the second begins where the first has an image already, elsewhere it goes on.
  hw::UnitConfig one_by_one;
  one_by_one.selective.overlap = false;
  const Rendered r = exact(one_by_one);
  const sim::FrameOutcome& outcome = r.outcomes[0];
  EXPECT_EQ(counter(outcome, "first_rendering_unit", "pixels"), samples);
  EXPECT_EQ(counter(outcome, "candidate_pixel_extractor", "candidates"), candidates);
  // One after the other: the second has an image to start from, so neither works in the other's phase.
  const std::uint64_t first = counter(outcome, "control_unit", "cycles_first");
  const std::uint64_t second = counter(outcome, "control_unit", "cycles_selective");
  EXPECT_GT(first, 0u);
  EXPECT_GT(second, 0u);
  EXPECT_LE(counter(outcome, "first_rendering_unit", "busy"), first);
  for (const char* block :
       {"candidate_pixel_extractor", "collision_counter", "threshold_adjuster", "render_executor"}) {
    EXPECT_LE(counter(outcome, block, "busy"), second) << block;
  }
  // Without the second unit's work the first one renders all.
  hw::UnitConfig off;
  off.selective.enabled = false;
  const Rendered all = exact(off);
  EXPECT_EQ(counter(all.outcomes[0], "first_rendering_unit", "pixels"), samples + candidates);
  EXPECT_EQ(counter(all.outcomes[0], "candidate_pixel_extractor", "candidates"), 0u);
}

// "[...] a candidate pixel extraction module that determines the candidate pixels between the sampling pixels of the
// first image; a hit frequency detection module that detects the hit frequency of the pixels around a candidate; a
// threshold adjustment module that compares the hit frequencies of the static and the dynamic scene and adaptively
// adjusts the reference threshold; and a rendering execution module that performs the selective rendering by the
// adjusted threshold and determines the candidate's colour."
TEST(Claim, C11_FourModulesEachWithItsPart) {
  const Rendered r = exact();
  const sim::FrameOutcome& outcome = r.outcomes[0];
  std::uint64_t n_static = 0, n_dynamic = 0, moved = 0, interpolated = 0, traced = 0;
  for (const SeenCandidate& c : candidates_of(outcome)) {
    n_static += static_cast<std::uint64_t>(c.n_static);
    n_dynamic += static_cast<std::uint64_t>(c.n_dynamic);
    moved += c.n_static != c.n_dynamic;
    const bool close = channel_difference(*c.pairs.at(0).first, *c.pairs.at(0).second) <= c.record.threshold;
    ++(close ? interpolated : traced);
  }
  EXPECT_EQ(counter(outcome, "candidate_pixel_extractor", "candidates"), candidates);
  EXPECT_EQ(counter(outcome, "collision_counter", "static_hits"), n_static);
  EXPECT_EQ(counter(outcome, "collision_counter", "dynamic_hits"), n_dynamic);
  EXPECT_EQ(counter(outcome, "threshold_adjuster", "lowered") + counter(outcome, "threshold_adjuster", "raised"),
            moved);
  EXPECT_EQ(counter(outcome, "render_executor", "interpolated"), interpolated);
  EXPECT_EQ(counter(outcome, "render_executor", "traced"), traced);
  for (std::uint64_t count : {n_static, n_dynamic, moved, interpolated, traced}) EXPECT_GT(count, 0u);
}

// "[...] the threshold adjustment module lowers the reference threshold if the first hit frequency, that of the dynamic
// scene, is higher than the second, that of the static scene, and raises it if it is lower."
TEST(Claim, C12_TheThresholdAdjusterLowersAndRaises) {
  const Rendered r = exact();
  const sim::FrameOutcome& outcome = r.outcomes[0];
  std::uint64_t lowered = 0, raised = 0;
  for (const SeenCandidate& c : candidates_of(outcome)) {
    SCOPED_TRACE(at_text(c.x, c.y));
    EXPECT_EQ(c.record.threshold<16, c.n_dynamic> c.n_static);
    EXPECT_EQ(c.record.threshold > 16, c.n_dynamic < c.n_static);
    lowered += c.n_dynamic > c.n_static;
    raised += c.n_dynamic < c.n_static;
  }
  EXPECT_EQ(counter(outcome, "threshold_adjuster", "lowered"), lowered);
  EXPECT_EQ(counter(outcome, "threshold_adjuster", "raised"), raised);
  EXPECT_GT(lowered, 0u);
  EXPECT_GT(raised, 0u);
}

// "[...] the threshold adjustment module determines how much the reference threshold is lowered or raised by the
// difference of the first and the second hit frequency."
TEST(Claim, C13_TheThresholdAdjusterMovesByTheDifference) {
  const std::array<int, 9> table{0, 1, 2, 4, 7, 11, 16, 22, 29};
  for (hw::Magnitude magnitude : {hw::Magnitude::proportional, hw::Magnitude::progressive}) {
    hw::UnitConfig config;
    config.selective.magnitude = magnitude;
    config.selective.reference = 128;
    const Rendered r = exact(config);
    for (const SeenCandidate& c : candidates_of(r.outcomes[0])) {
      SCOPED_TRACE(at_text(c.x, c.y));
      const int difference = c.n_dynamic - c.n_static;
      const int size = magnitude == hw::Magnitude::proportional ? 2 * std::abs(difference)
                                                                : table[static_cast<std::size_t>(std::abs(difference))];
      EXPECT_EQ(c.record.threshold, difference > 0 ? 128 - size : 128 + size);
    }
  }
}

}  // namespace
}  // namespace artu::golden_tests
