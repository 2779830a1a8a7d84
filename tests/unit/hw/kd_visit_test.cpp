// One step through a kd-tree's node (docs/trees.md): which children, in which order, with which interval.
#include <gtest/gtest.h>

#include <cmath>

#include "hw/datapath/hit_tests.h"

namespace artu::hw::test {
namespace {

/// Split at x = 4; child 0 lies below the plane, child 1 above.
struct KdVisit : testing::Test {
  KdVisit() {
    node.axis = 0;
    node.split = 4;
    node.child[0] = NodeReference::leaf(0, 1, false);
    node.child[1] = NodeReference::leaf(1, 1, false);
  }
  Steps steps(float x, float dx, float limit = 100) const {
    Ray ray;
    ray.origin = {x, 0, 10};
    ray.direction = {dx, 0, -1};
    set_up(ray);
    Steps out;
    node_visit(most_fraction_bits)(TreeKind::kd, &node, ray, {0, 1, 20}, limit, box_padding(), 0, out);
    return out;
  }
  KdNodeRecord node{};
};

TEST_F(KdVisit, APlaneDividesTheInterval) {
  const Steps s = steps(0, 0.5f);
  ASSERT_EQ(s.count, 2u);
  EXPECT_EQ(s.tests, 1u);
  EXPECT_EQ(s.step[0].node, node.child[0]);
  EXPECT_EQ(s.step[0].enter, 1);
  EXPECT_EQ(s.step[0].exit, 8 * box_padding()) << "the near side is padded";
  EXPECT_EQ(s.step[1].node, node.child[1]);
  EXPECT_EQ(s.step[1].enter, 8);
  EXPECT_EQ(s.step[1].exit, 20);
}

TEST_F(KdVisit, TheOtherWayRoundTheUpperChildIsTheNearOne) {
  const Steps s = steps(8, -0.5f);
  ASSERT_EQ(s.count, 2u);
  EXPECT_EQ(s.step[0].node, node.child[1]);
  EXPECT_EQ(s.step[1].node, node.child[0]);
  EXPECT_EQ(s.step[1].enter, 8);
}

TEST_F(KdVisit, APlaneBehindTheLimitLeavesTheNearChild) {
  const Steps s = steps(0, 0.5f, 7.5f);
  ASSERT_EQ(s.count, 1u);
  EXPECT_EQ(s.step[0].node, node.child[0]);
}

TEST_F(KdVisit, ARayAlongThePlaneHasItsSideWhole) {
  for (const float zero : {0.0f, -0.0f}) {
    for (const float x : {3.0f, 5.0f}) {
      const Steps s = steps(x, zero);
      const std::uint32_t own = node.child[x < 4 ? 0 : 1];
      bool whole = false;
      for (std::uint32_t i = 0; i < s.count; ++i) {
        whole |= s.step[i].node == own && s.step[i].enter == 1 && s.step[i].exit == 20;
      }
      EXPECT_TRUE(whole) << x << ' ' << zero;
    }
  }
}

TEST_F(KdVisit, ARayInThePlaneIsWholeOnBothSides) {
  // Its inverse has either sign, and the plane's distance is 0: neither side may be cut off there.
  for (const float zero : {0.0f, -0.0f}) {
    const Steps s = steps(4, zero);
    ASSERT_EQ(s.count, 2u) << zero;
    for (int i = 0; i < 2; ++i) {
      EXPECT_EQ(s.step[i].enter, 1);
      EXPECT_EQ(s.step[i].exit, 20);
    }
  }
}

}  // namespace
}  // namespace artu::hw::test
