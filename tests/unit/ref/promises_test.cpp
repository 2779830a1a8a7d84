// What docs/arithmetic.md sections 10 and 11 promise of single triangles at every width.
#include <gtest/gtest.h>

#include "ref/hit_point.h"
#include "unit/ref/traversal.h"

namespace artu::ref {
namespace {

using testing::power_of_two;
using testing::Random;
using testing::random_triangle;
using testing::vertex;

// Section 10: where steps 1 to 4 accept in front of the ray, the interval of the triangle's box is not empty.
template <class N>
void expect_no_loss(int triangle_bits, int box_bits, unsigned seed) {
  const HitTests tests({box_bits, triangle_bits, 23});
  const auto all = [](const Ray&, const Box&) { return Interval{-HUGE_VALF, HUGE_VALF}; };
  Random random(seed);
  int accepted = 0;
  for (int i = 0; i < 150000; ++i) {
    const Triangle t = random_triangle(random, random.point(power_of_two(random, 0, 5)), 1);
    const Vec3 goal = testing::target({t}, random), origin = random.point(power_of_two(random, 0, 5));
    float farthest = 0;
    for (const int corner : {0, 1, 2}) farthest = max(farthest, largest_magnitude(vertex(t, corner) - origin));
    const float distance = largest_magnitude(goal - origin);
    // The promise is for origins off the triangle by 6 e of the distance; by its box is easily told.
    const Box box = triangle_box(t);
    const float off =
        2 * 6.0f / static_cast<float>(2 << (triangle_bits < box_bits ? triangle_bits : box_bits)) * farthest;
    const auto away = [off](float lo, float hi, float o) { return o < lo - off || o > hi + off; };
    if (!away(box.lo.x, box.hi.x, origin.x) && !away(box.lo.y, box.hi.y, origin.y) &&
        !away(box.lo.z, box.hi.z, origin.z)) {
      continue;
    }
    const Ray ray = tests.ray(origin, unit(goal - origin));
    TriangleHit hit;
    if (distance == 0 || !intersect_in<N>(ray, t, all, hit)) continue;
    ++accepted;
    const Interval interval = tests.interval(ray, box);
    ASSERT_LE(interval.enter, interval.exit) << triangle_bits << " " << box_bits << " " << i;
  }
  EXPECT_GT(accepted, 10000);
}

TEST(Padding, LosesNoAcceptedTriangle) {
  for (const int box : {7, 8, 12, 23}) {
    expect_no_loss<Number<7>>(7, box, 51);
    expect_no_loss<Number<9>>(9, box, 52);
    expect_no_loss<Number<15>>(15, box, 53);
    expect_no_loss<float>(23, box, 54);
  }
}

// Section 11, for triangles that are no slivers; directions along the plane, as flat as binary32 lets them be.
TEST(HitPoint, RaysLeaveTheirTriangleAtAnyWidth) {
  Random random(61);
  for (int m = narrowest; m <= widest; ++m) {
    const HitTests tests({23, m, 23});
    int checked = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec3 center = random.point(power_of_two(random, 0, 10));
      traces::Mesh mesh;
      const Vec3 a = center + random.point(1), b = center + random.point(1), c = center + random.point(1);
      testing::add_triangle(mesh, a, b, c);
      const Vec3 ab = b - a, ac = c - a;
      const Vec3 n{ab.y * ac.z - ab.z * ac.y, ab.z * ac.x - ab.x * ac.z, ab.x * ac.y - ab.y * ac.x};
      if (dot(n, n) < 0.01f) continue;
      const Triangle t{{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z}};
      const Vec3 origin = center + random.point(4), goal = testing::target({t}, random);
      const Vec3 d = unit(goal - origin);
      TriangleHit hit;
      if (!tests.intersect(tests.ray(origin, d), t, hit)) continue;
      const HitPoint p = hit_point(mesh, 0, d, hit, m);
      const Vec3 along = unit(testing::target({t}, random) - p.outside + random.point(0x1p-6f));
      for (const float lift : {0.0f, 0x1p-22f, 0x1p-12f, 0.1f}) {
        for (const bool out : {true, false}) {
          const Vec3 normal = out ? p.ng : -p.ng;
          const Vec3 flat = unit((along - normal * dot(along, normal)) + normal * lift);
          if (!(dot(flat, normal) > 0)) continue;
          TriangleHit again;
          ASSERT_FALSE(tests.intersect(tests.ray(out ? p.outside : p.inside, flat), t, again)) << m << " " << i;
          ++checked;
        }
      }
    }
    EXPECT_GT(checked, 5000);
  }
}

}  // namespace
}  // namespace artu::ref
