// The two tests in narrow formats: nested boxes, the padding of intervals, and 23 bits against binary32.
#include <gtest/gtest.h>

#include "unit/ref/traversal.h"

namespace artu::ref {
namespace {

using testing::bits;
using testing::power_of_two;
using testing::Random;
using testing::random_triangle;

TEST(Box, NestedBoxesHaveNestedIntervals) {
  Random random(31);
  for (const int m : {7, 10, 15, 22, 23}) {
    for (const int triangle : {7, 23}) {
      Precision precision;
      precision.box = m;
      precision.triangle = triangle;
      const HitTests tests(precision);
      for (int i = 0; i < 40000; ++i) {
        const float scale = power_of_two(random, -140, 60);
        Box box{random.point(scale), random.point(scale)};
        if (random.below(4) == 0) box.hi.y = box.lo.y;
        const Vec3 lo = box.lo, hi = box.hi;
        box = {{min(lo.x, hi.x), min(lo.y, hi.y), min(lo.z, hi.z)},
               {max(lo.x, hi.x), max(lo.y, hi.y), max(lo.z, hi.z)}};
        const Vec3 direction = testing::random_direction(random);
        if (is_dead(direction)) continue;
        const Ray ray = tests.ray(random.below(4) == 0 ? box.lo : random.point(2 * scale), direction);
        Interval inner = tests.interval(ray, box);
        for (int grown = 0; grown < 4; ++grown) {  // by ulps first, then by more
          const float by = grown < 2 ? 0 : scale * random.uniform(0, 1);
          for (float* x : {&box.lo.x, &box.lo.y, &box.lo.z}) *x = std::nextafter(*x - by, -HUGE_VALF);
          for (float* x : {&box.hi.x, &box.hi.y, &box.hi.z}) *x = std::nextafter(*x + by, HUGE_VALF);
          const Interval outer = tests.interval(ray, box);
          ASSERT_LE(outer.enter, inner.enter) << m;
          ASSERT_GE(outer.exit, inner.exit) << m;
          inner = outer;
        }
      }
    }
  }
}

TEST(Box, NarrowNumbersByHand) {
  Precision precision;
  precision.box = 7;
  const HitTests tests(precision);
  const Ray ray = tests.ray({0, 0, 0}, {0, 0, 3});
  EXPECT_EQ(ray.inv.z, 0x1.56p-2f);                                          // 1/3 = 0x1.555...p-2
  const Interval i = tests.interval(ray, {{-1, -1, 3}, {1, 1, 4.015625f}});  // 4 + 1/64: a tie, to 4
  EXPECT_EQ(i.enter, 1.0f);                                                  // 0x1.56p-2 * 3 = 0x1.008p0
  EXPECT_EQ(i.exit, 0x1.6cp0f);                                              // 0x1.56p0 * (1 + 1/16) = 0x1.6b6p0
  EXPECT_EQ(interval_padding(7), 1.0625f);
  EXPECT_EQ(interval_padding(23), 1.0f + 0x1p-20f);
}

TEST(SetUp, RegistersAreOfTheirTestsFormats) {
  Precision precision;
  precision.box = 9;
  precision.triangle = 12;
  const Ray exact = make_ray({1, 2, 3}, {0.3f, -0.7f, 1e-35f}),
            ray = HitTests(precision).ray({1, 2, 3}, {0.3f, -0.7f, 1e-35f});
  EXPECT_EQ(ray.inv.x, static_cast<float>(Number<9>(exact.inv.x)));
  EXPECT_EQ(ray.inv.z, 0x1p100f);
  EXPECT_TRUE(ray.limited[2]);
  EXPECT_EQ(ray.sx, static_cast<float>(Number<12>(exact.sx)));
  EXPECT_EQ(ray.sy, static_cast<float>(Number<12>(exact.sy)));
  EXPECT_EQ(ray.sz, static_cast<float>(Number<12>(exact.sz)));
  EXPECT_NE(ray.inv.x, exact.inv.x);
  EXPECT_EQ(ray.direction.x, 0.3f);
}

// The same widths by two ways: 23 bits in binary32, or in binary64 with a rounding.
void expect_same_tests(const Precision& precision, unsigned seed) {
  const HitTests native(precision), emulated(precision, true);
  Random random(seed);
  int hits = 0;
  for (int i = 0; i < 200000; ++i) {
    const float size = power_of_two(random, random.below(2) == 0 ? -2 : -130, random.below(2) == 0 ? 2 : 60);
    const Triangle t = random_triangle(random, random.point(size * power_of_two(random, 0, 8)), size);
    const Vec3 goal = testing::target({t}, random), origin = goal + random.point(size * power_of_two(random, -4, 6));
    Vec3 direction = random.below(2) == 0 ? unit(goal - origin) : goal - origin;
    if (random.below(4) == 0) direction = testing::random_direction(random);
    if (is_dead(direction)) continue;
    const Ray a = native.ray(origin, direction), b = emulated.ray(origin, direction);
    const Interval ia = native.interval(a, triangle_box(t)), ib = emulated.interval(b, triangle_box(t));
    ASSERT_EQ(bits(ia.enter), bits(ib.enter));
    ASSERT_EQ(bits(ia.exit), bits(ib.exit));
    TriangleHit ha{}, hb{};
    const bool hit = native.intersect(a, t, ha);
    ASSERT_EQ(emulated.intersect(b, t, hb), hit);
    for (const auto& [x, y] : {std::pair{ha.t, hb.t}, {ha.u, hb.u}, {ha.v, hb.v}, {ha.det, hb.det}}) {
      ASSERT_EQ(bits(x), bits(y));
    }
    const bool possible = ia.enter <= ia.exit && ia.exit >= 0 && ia.enter <= a.tmax;  // stronger than a hit
    ASSERT_FALSE(possible && native.surely_misses(a, t));
    ASSERT_FALSE(possible && emulated.surely_misses(b, t));
    hits += hit;
  }
  EXPECT_GT(hits, 10000);
}

TEST(Formats, BothTestsAt23BitsAreBinary32) { expect_same_tests({}, 41); }
TEST(Formats, ABinary32BoxServesANarrowTriangle) { expect_same_tests({23, 9, 23}, 42); }
TEST(Formats, ANarrowBoxServesABinary32Triangle) { expect_same_tests({9, 23, 23}, 43); }
TEST(Formats, TheQuickTestLosesNoHitAtAnyWidth) {
  for (int m = narrowest; m < widest; ++m) expect_same_tests({m, 30 - m < narrowest ? narrowest : 30 - m, 23}, 44u);
}

TEST(Formats, OtherWidthsAreRefused) {
  EXPECT_THROW(HitTests({6, 23, 23}), std::invalid_argument);
  EXPECT_THROW(HitTests({23, 24, 23}), std::invalid_argument);
}

}  // namespace
}  // namespace artu::ref
