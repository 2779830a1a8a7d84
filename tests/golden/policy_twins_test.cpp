// Each policy of the unit and its twin in the golden model, on candidates that no scene may have: the same threshold.
#include <gtest/gtest.h>

#include <random>

#include "golden/drawn.h"
#include "hw/selective/policy.h"
#include "ref/selective.h"
#include "sim/compare/golden_settings.h"

namespace artu::golden_tests {
namespace {

hw::Rgb rgb(ref::Color color) { return {color.r, color.g, color.b}; }

hw::Evidence evidence_of(const ref::Candidate& from) {
  hw::Evidence to;
  to.x = static_cast<std::uint16_t>(from.x);
  to.y = static_cast<std::uint16_t>(from.y);
  to.h = static_cast<std::uint8_t>(from.place.h);
  to.kind = from.place.kind == ref::PassKind::horizontal ? hw::PassKind::horizontal
            : from.place.kind == ref::PassKind::vertical ? hw::PassKind::vertical
                                                         : hw::PassKind::centre;
  to.counts = {static_cast<std::uint8_t>(from.n_static), static_cast<std::uint8_t>(from.n_dynamic)};
  to.pairs.count = static_cast<std::uint8_t>(from.pairs);
  for (std::size_t i = 0; i < 2; ++i) to.pairs.color[i] = {rgb(from.pair[i].a), rgb(from.pair[i].b)};
  for (std::size_t i = 0; i < 8; ++i) {
    const ref::Neighbour& neighbour = from.ring[i];
    to.ring[i] = {neighbour.finished, static_cast<hw::HitClass>(neighbour.hit_class), rgb(neighbour.color)};
  }
  return to;
}

class PolicyTwins : public testing::TestWithParam<std::uint32_t> {};

TEST_P(PolicyTwins, AgreeOnAnyCandidate) {
  std::mt19937 random(GetParam() + 1);
  const auto draw = [&random](std::uint32_t count) { return static_cast<std::uint32_t>(random() % count); };
  const hw::Policy& unit_policy = hw::policy(GetParam());
  for (int round = 0; round < 300; ++round) {
    hw::UnitConfig unit;
    hw::SelectiveConfig& s = unit.selective;
    s.policy = GetParam();
    draw_comparison(s, draw);
    s.adaptive = draw(4) != 0;
    s.reference = draw(256);
    s.minimum = draw(256);
    s.maximum = s.minimum + draw(256 - s.minimum);
    s.step = draw(256);
    for (std::uint32_t& value : s.table) value = draw(256);
    for (std::uint32_t& value : s.policy_registers) value = draw(256);
    const ref::Settings golden = sim::golden_settings(unit);
    const ref::Policy twin = ref::policy_named(golden.policy);

    const std::uint32_t width = 1 + draw(12), height = 1 + draw(12);
    std::vector<ref::Pixel> pixels(std::size_t{width} * height);
    for (ref::Pixel& pixel : pixels) {
      pixel.r = static_cast<std::uint8_t>(draw(256));
      pixel.g = static_cast<std::uint8_t>(draw(256));
      pixel.b = static_cast<std::uint8_t>(draw(256));
      pixel.hit_class = static_cast<ref::HitClass>(draw(4));
    }
    const ref::Image image{width, height, pixels};
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        if (ref::place_of(golden, x, y).pass == 0) continue;
        const ref::Candidate candidate = ref::candidate_at(golden, image, x, y);
        const int threshold = twin(candidate, golden);
        ASSERT_EQ(unit_policy.threshold(evidence_of(candidate), s), threshold) << "round " << round;
        ASSERT_EQ(twin(candidate, golden), threshold) << "has a state";
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Policy, PolicyTwins, testing::Range(0u, static_cast<std::uint32_t>(hw::policy_names().size())),
                         [](const auto& of) { return hw::policy_names()[of.param]; });

}  // namespace
}  // namespace artu::golden_tests
