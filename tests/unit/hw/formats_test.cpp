// The datapaths in narrow formats: at 23 bits the narrow path is the native one, and the promises hold at every width.
#include <gtest/gtest.h>

#include <random>

#include "hw/datapath/hit_tests.h"
#include "hw/datapath/shading.h"

namespace artu::hw::test {
namespace {

class Draw {
 public:
  float in(float lo, float hi) { return lo + (hi - lo) * static_cast<float>(random_() >> 40) * 0x1p-24f; }
  Vector vector(float half) {
    const float x = in(-half, half), y = in(-half, half), z = in(-half, half);
    return {x, y, z};
  }
  bool one_in(unsigned n) { return random_() % n == 0; }
  /// Aimed at `goal`, sometimes along an axis.
  Ray ray(Vector goal) {
    Ray ray;
    ray.origin = vector(3);
    ray.direction = one_in(2) ? unit(goal - ray.origin) : goal - ray.origin;
    if (one_in(8)) ray.direction.x = 0;
    if (one_in(8)) ray.direction.y = -0.0f;
    if (is_zero(ray.direction)) ray.direction = {0, 0, 1};
    return ray;
  }

 private:
  std::mt19937_64 random_{7};
};

PrecisionConfig widths(unsigned box, unsigned triangle) { return {box, triangle, 23}; }

TEST(Formats, TheNarrowHitTestsAt23BitsAreTheNativeOnes) {
  Draw draw;
  const auto native = [](const Ray& r, Vector lo, Vector hi) { return box_interval<float>(r, lo, hi, box_padding()); };
  const auto narrow = [](const Ray& r, Vector lo, Vector hi) {
    return box_interval<Narrow<23>>(r, lo, hi, box_padding());
  };
  int hits = 0;
  for (int i = 0; i < 100000; ++i) {
    const Vector a = draw.vector(1), b = draw.vector(1), c = draw.vector(1);
    Ray ray = draw.ray(draw.one_in(2) ? a : a * 0.25f + b * 0.5f + c * 0.25f);
    set_up(ray);
    const Vector lo{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
    const Vector hi{std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
    const Interval p = native(ray, lo, hi), q = narrow(ray, lo, hi);
    ASSERT_EQ(bits_of(p.enter), bits_of(q.enter));
    ASSERT_EQ(bits_of(p.exit), bits_of(q.exit));
    TriangleHit x, y;
    const bool hit = intersect<float>(ray, a, b, c, native, x);
    ASSERT_EQ(hit, intersect<Narrow<23>>(ray, a, b, c, narrow, y));
    hits += hit ? 1 : 0;
    ASSERT_EQ(bits_of(x.t), bits_of(y.t));
    ASSERT_EQ(bits_of(x.U), bits_of(y.U));
    ASSERT_EQ(bits_of(x.V), bits_of(y.V));
    ASSERT_EQ(bits_of(x.det), bits_of(y.det));
  }
  EXPECT_GT(hits, 30000);
}

void expect_same(Vector a, Vector b) {
  ASSERT_EQ(bits_of(a.x), bits_of(b.x));
  ASSERT_EQ(bits_of(a.y), bits_of(b.y));
  ASSERT_EQ(bits_of(a.z), bits_of(b.z));
}

struct Scenery {
  explicit Scenery(Draw& draw) {
    const auto positive = [&] { return draw.vector(0.5f) + Vector{0.5f, 0.5f, 0.5f}; };
    constants.ambient = positive();
    constants.sky_nadir = positive();
    constants.sky_zenith = positive();
    surface.geometric_normal = {0, 1, 0};
    surface.shading_normal = unit(Vector{0, 1, 0} + draw.vector(0.2f));
    surface.outside = draw.vector(2);
    surface.inside = draw.vector(2);
    surface.color = positive();
    surface.front = draw.one_in(2);
    material.diffuse = positive();
    material.specular = positive();
    material.mirror = positive();
    material.transmission = draw.one_in(3) ? Vector{} : positive();
    material.emission = positive();
    material.ior = draw.in(1, 2);
    material.specular_log2 = 5;
    material.tint = draw.one_in(2);
    direction = unit(Vector{0, -1, 0} + draw.vector(0.7f));
    weight = positive();
    light.type = static_cast<LightType>(draw.one_in(3) ? 0 : draw.one_in(2) ? 1 : 2);
    light.position = Vector{0, 5, 0} + draw.vector(2);
    light.direction = unit(Vector{0, -1, 0} + draw.vector(0.3f));
    light.color = positive();
    light.range = 100;
    light.cos_outer = draw.in(0.1f, 0.6f);
    light.cos_inner = 0.9f;
    footprint.a_u = draw.in(0, 1);
    footprint.a_v = draw.in(0, 1);
    for (auto& texel : texels) texel = static_cast<std::uint32_t>(draw.in(0, 16777215));
  }
  ShadingConstants constants;
  Surface surface;
  MaterialRecord material{};
  LightRecord light{};
  Vector direction, weight;
  TextureFootprint footprint{};
  std::array<std::uint32_t, 4> texels{};
};

/// All that shading computes for a hit, in order.
template <class R>
std::vector<Vector> shaded(const Scenery& s) {
  ShadedPoint point;
  const Vector texture = filter<R>(s.footprint, s.texels);
  const Vector base = begin_shading<R>(s.constants, s.surface, s.material, texture, s.direction, s.weight, point);
  ShadowRay shadow;
  const bool lit = light_contribution<R>(point, s.light, shadow);
  const NextRays next = next_rays<R>(s.constants, point);
  const Vector sum = add_weighted<R>(s.constants.ambient, s.weight, base);
  std::vector<Vector> all{texture, base, sum, add<R>(sum, texture), sky<R>(s.constants, s.direction)};
  all.insert(all.end(), {point.diffuse, point.specular, point.mirror, point.transmission, shadow.direction});
  all.insert(all.end(), {lit ? shadow.contribution : Vector{}, next.reflection_weight, next.reflection_direction,
                         next.refraction_weight, next.refraction_direction});
  all.push_back({lit ? 1.0f : 0.0f, next.reflection ? 1.0f : 0.0f, next.refraction ? 1.0f : 0.0f});
  return all;
}

TEST(Formats, TheNarrowShadingAt23BitsIsTheNativeOne) {
  Draw draw;
  for (int i = 0; i < 20000; ++i) {
    const Scenery scenery(draw);
    const std::vector<Vector> native = shaded<float>(scenery), narrow = shaded<Narrow<23>>(scenery);
    for (std::size_t j = 0; j < native.size(); ++j) expect_same(native[j], narrow[j]);
  }
}

TEST(Formats, ShadingRoundsColoursAndLeavesRaysAlone) {
  Draw draw;
  int other_colors = 0;
  for (int i = 0; i < 1000; ++i) {
    const Scenery scenery(draw);
    const std::vector<Vector> wide = shaded<float>(scenery), narrow = shaded<Narrow<7>>(scenery);
    expect_same(wide[9], narrow[9]);  // the shadow ray
    if (wide[15].y == narrow[15].y) expect_same(wide[12], narrow[12]);
    if (wide[15].z == narrow[15].z) expect_same(wide[14], narrow[14]);
    for (std::size_t j : {0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 11, 13})
      expect_same(narrow[j], from(to<Narrow<7>>(narrow[j])));
    other_colors += wide[2].x != narrow[2].x ? 1 : 0;
  }
  EXPECT_GT(other_colors, 900);
  const ShadingSteps& steps = shading_steps(7);
  EXPECT_EQ(steps.add({1, 1, 1}, {0x1p-9f, 0x1p-9f, 0x1p-9f}).x, 1.0f);
  EXPECT_EQ(shading_steps(23).add({1, 1, 1}, {0x1p-9f, 0, 0}).x, 1.0f + 0x1p-9f);
}

TEST(Formats, NestedBoxesHaveNestedIntervalsAtEveryWidth) {
  Draw draw;
  for (unsigned m = 7; m <= 23; ++m) {
    const HitTests tests(widths(m, m));
    for (int i = 0; i < 3000; ++i) {
      Ray ray = draw.ray(draw.vector(1));
      tests.set_up(ray);
      const Vector lo = draw.vector(1), hi = lo + Vector{draw.in(0, 1), draw.in(0, 0.01f), draw.in(0, 1)};
      const Vector more{draw.in(0, 0.01f), draw.in(0, 1e-6f), 0};
      const Interval inner = tests.box(ray, lo, hi), outer = tests.box(ray, lo - more, hi + more);
      ASSERT_LE(outer.enter, inner.enter) << m;
      ASSERT_GE(outer.exit, inner.exit) << m;
    }
  }
}

/// Rays that pass a triangle's corners and edges as closely as rounding lets them.
TEST(Formats, TheClampLosesNoTriangleThatItsSidesAccept) {
  Draw draw;
  const auto everything = [](const Ray&, Vector, Vector) { return Interval{-0x1p120f, 0x1p120f}; };
  int accepted = 0;
  for (const auto& [box, triangle] : {std::pair{7u, 7u}, {7u, 23u}, {23u, 7u}, {10u, 9u}, {23u, 23u}}) {
    const HitTests tests(widths(box, triangle));
    for (int i = 0; i < 60000; ++i) {
      const Vector a = draw.vector(1), b = a + draw.vector(0.1f), c = a + draw.vector(0.1f);
      const float s = draw.one_in(2) ? 0.0f : draw.in(0, 1);
      Ray ray = draw.ray(a + (b - a) * s + draw.vector(std::ldexp(1.0f, -static_cast<int>(triangle))));
      if (dot(a - ray.origin, a - ray.origin) < 1) continue;  // the promise is for origins at a distance
      tests.set_up(ray);
      TriangleHit free, hit;
      const bool sides = triangle == 7   ? intersect<Narrow<7>>(ray, a, b, c, everything, free)
                         : triangle == 9 ? intersect<Narrow<9>>(ray, a, b, c, everything, free)
                                         : intersect<float>(ray, a, b, c, everything, free);
      if (!sides) continue;
      ++accepted;
      ASSERT_TRUE(tests.triangle(ray, a, b, c, hit)) << box << ", " << triangle << ": ray " << i;
    }
  }
  EXPECT_GT(accepted, 20000);
}

TEST(Formats, TheOffsetFromTheSurfaceFollowsTheWidth) {
  Draw draw;
  for (unsigned m = 7; m <= 23; ++m) {
    const HitTests tests(widths(m, m));
    int rays = 0;
    for (int i = 0; i < 4000; ++i) {
      const Vector a = draw.vector(1), b = draw.vector(1), c = draw.vector(1);
      Ray ray = draw.ray(a * 0.3f + b * 0.3f + c * 0.4f);
      tests.set_up(ray);
      TriangleHit hit;
      if (!tests.triangle(ray, a, b, c, hit)) continue;
      TriangleRecord record{};
      record.a = a;
      record.b = b;
      record.c = c;
      const Surface surface = surface_at(ray, hit, record, AttributeRecord{}, static_cast<int>(m));
      for (const bool out : {true, false}) {
        Ray next;
        next.origin = out ? surface.outside : surface.inside;
        next.direction = unit(draw.vector(1));
        if ((dot(next.direction, surface.geometric_normal) > 0) != out) next.direction = -next.direction;
        tests.set_up(next);
        ASSERT_FALSE(tests.triangle(next, a, b, c, hit)) << m << ": ray " << i;
        ++rays;
      }
    }
    EXPECT_GT(rays, 1000) << m;
  }
}

TEST(Formats, SurfacesAtMoreDistanceWhereTheTestIsCoarser) {
  Ray ray;
  ray.origin = {1, 1, 3};
  ray.direction = {0, 0, -1};
  TriangleRecord record{};
  record.b = {4, 0, 0};
  record.c = {0, 4, 0};
  const TriangleHit hit{3, 0.5f, 0.25f, 1};
  // m and L are 4: 4 * 2^-19 + 4 * 2^(4-M).
  EXPECT_EQ(surface_at(ray, hit, record, AttributeRecord{}, 23).outside.z, 0x1p-17f + 0x1p-17f);
  EXPECT_EQ(surface_at(ray, hit, record, AttributeRecord{}, 10).outside.z, 0x1p-17f + 0x1p-4f);
  record.a = record.b = record.c = {4, 0, 0};
  record.b.x += 0.25f;
  record.c.y = 0.125f;
  EXPECT_EQ(surface_at(ray, {3, 0, 0, 1}, record, AttributeRecord{}, 10).outside.z, 4.25f * 0x1p-19f + 0x1p-8f);
}

}  // namespace
}  // namespace artu::hw::test
