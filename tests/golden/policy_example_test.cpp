// The example of docs/selective-rendering.md, "Adding a policy": both halves are compiled from the page
// (tests/CMakeLists.txt), and give the same threshold.
#include <gtest/gtest.h>

#include <algorithm>

#include "hw/selective/policy.h"
#include "ref/policy.h"

namespace artu::hw::policies {
Policy edge();
}
namespace artu::ref::policies {
int edge(const Candidate& candidate, const Settings& settings);
}

namespace artu::golden_tests {
namespace {

TEST(PolicyExample, BothHalvesAgree) {
  hw::UnitConfig unit;
  ref::Settings golden;
  int lowered = 0;
  for (const auto& [reference, minimum, amount] : {std::array{16, 0, 12}, {16, 9, 12}, {16, 0, 200}, {40, 20, 0}}) {
    golden.reference = reference;
    golden.minimum = minimum;
    golden.policy_registers[0] = amount;
    unit.selective.reference = static_cast<std::uint32_t>(reference);
    unit.selective.minimum = static_cast<std::uint32_t>(minimum);
    unit.selective.policy_registers[0] = static_cast<std::uint32_t>(amount);
    for (int n_static = 0; n_static <= 8; ++n_static) {
      for (int n_dynamic = 0; n_static + n_dynamic <= 8; ++n_dynamic) {
        hw::Evidence evidence;
        evidence.counts = {static_cast<std::uint8_t>(n_static), static_cast<std::uint8_t>(n_dynamic)};
        ref::Candidate candidate;
        candidate.n_static = n_static;
        candidate.n_dynamic = n_dynamic;
        const int threshold = ref::policies::edge(candidate, golden);
        EXPECT_EQ(hw::policies::edge().threshold(evidence, unit.selective), threshold);
        const bool meet = n_static > 0 && n_dynamic > 0;
        EXPECT_EQ(threshold, meet ? std::max(minimum, reference - amount) : reference);
        lowered += threshold < reference;
      }
    }
  }
  EXPECT_GT(lowered, 0);
}

}  // namespace
}  // namespace artu::golden_tests
