// The box tests of a node with SSE2 against those of machines without it: the same source, compiled without.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#define ARTU_PORTABLE
#include "hw/datapath/node_visit.h"
#define node_visit portable_node_visit
#include "hw/datapath/node_visit.cpp"
#undef node_visit
#include "hw/datapath/hit_tests.h"

namespace artu::hw {

namespace {

class Random {
 public:
  /// Few values, so that ties are frequent, or such that are a few steps apart, for the padding; now and then one that
  /// is special.
  float coordinate() {
    static constexpr float special[] = {0.0f, -0.0f, 1e-40f, 1e30f, -1e30f, std::numeric_limits<float>::infinity()};
    if (below(40) == 0) return special[below(6)];
    const float x = 0.25f * static_cast<float>(static_cast<int>(below(17)) - 8);
    return x != 0 && below(2) == 0 ? float_of(bits_of(x) + below(8)) : x;
  }
  Vector vector() { return {coordinate(), coordinate(), coordinate()}; }
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }

 private:
  std::mt19937 random_{11};
};

Ray random_ray(Random& random) {
  Ray ray;
  ray.origin = random.vector();
  do {
    ray.direction = {0.5f * static_cast<float>(random.below(9)) - 2, 0.5f * static_cast<float>(random.below(9)) - 2,
                     0.5f * static_cast<float>(random.below(9)) - 2};
  } while (is_zero(ray.direction));
  set_up(ray);
  return ray;
}

/// The intervals' ends are only kept for a kd-tree.
void expect_same(TreeKind kind, const void* record, const Ray& ray, float limit) {
  Steps scalar, wide;
  portable_node_visit(most_fraction_bits)(kind, record, ray, {}, limit, box_padding(), 0, scalar);
  node_visit(most_fraction_bits)(kind, record, ray, {}, limit, box_padding(), 0, wide);
  ASSERT_EQ(scalar.tests, wide.tests);
  ASSERT_EQ(scalar.count, wide.count);
  for (std::uint32_t i = 0; i < scalar.count; ++i) {
    ASSERT_EQ(scalar.step[i].node, wide.step[i].node);
    ASSERT_EQ(bits_of(scalar.step[i].enter), bits_of(wide.step[i].enter));
  }
}

template <int Width>
WideNodeRecord<Width> random_wide(Random& random) {
  WideNodeRecord<Width> node{};
  node.count = static_cast<std::uint8_t>(2 + random.below(Width - 1));
  node.origin = random.vector();
  for (int axis = 0; axis < 3; ++axis) {
    node.exponent[axis] = static_cast<std::uint8_t>(118 + random.below(6));
    for (int i = 0; i < Width; ++i) {
      node.lo[axis][i] = static_cast<std::uint8_t>(random.below(256));
      node.hi[axis][i] = static_cast<std::uint8_t>(random.below(256));
    }
  }
  for (int i = 0; i < Width; ++i) node.child[i] = static_cast<std::uint32_t>(i);
  return node;
}

TEST(WideSteps, AreThoseOfTheScalarBoxTest) {
  Random random;
  std::uint64_t met = 0;
  for (int n = 0; n < 200000 && !testing::Test::HasFatalFailure(); ++n) {
    const Ray ray = random_ray(random);
    const float limit = random.below(4) == 0 ? 0.25f * static_cast<float>(random.below(16)) : two_pow_100;
    NodeRecord node{};
    for (int i = 0; i < 2; ++i) {
      node.lo[i] = random.vector();
      node.hi[i] = random.vector();
      node.child[i] = static_cast<std::uint32_t>(i);
    }
    expect_same(TreeKind::bvh2, &node, ray, limit);
    const WideNodeRecord<4> four = random_wide<4>(random);
    expect_same(TreeKind::bvh4, &four, ray, limit);
    const WideNodeRecord<8> eight = random_wide<8>(random);
    expect_same(TreeKind::bvh8, &eight, ray, limit);
    Steps steps;
    node_visit(most_fraction_bits)(TreeKind::bvh2, &node, ray, {}, limit, box_padding(), 0, steps);
    met += steps.count;
  }
  EXPECT_GT(met, 10000u);
}

}  // namespace
}  // namespace artu::hw
