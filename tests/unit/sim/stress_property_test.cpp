// Properties over coordinates that are hard on arithmetic; a failure shrinks to a few triangles and a ray.
// RC_PARAMS="seed=... max_success=..." draws others.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstdlib>

#include "unit/sim/stress_support.h"

namespace artu::sim {

/// A coordinate from the nasty set; shrinks towards its beginning.
struct Nasty {
  int index = 0;
  float value() const {
    static constexpr float values[] = {
        0.0f,      1.0f,          -1.0f,          -0.0f,          2.0f,      0.5f,          -0.5f,     0x1p-23f,
        -0x1p-24f, 0x1.000002p0f, -0x1.000002p0f, 0x1.fffffep-1f, 0.1f,      1.0f / 3.0f,   3.0f,      -7.0f,
        1e3f,      1e7f,          -1e7f,          1e-6f,          0x1p-100f, -0x1p-101f,    0x1p-126f, -0x1p-127f,
        0x1p-149f, -0x1p-149f,    0x1p40f,        -0x1p60f,       0x1p60f,   0x1.fffffep61f};
    static_assert(sizeof values / sizeof *values == count);
    return values[index];
  }
  static constexpr int count = 30;
  static constexpr int moderate = 20;  // without what is beyond any scene
};
using NastyTriangle = std::array<Nasty, 9>;
using NastyVector = std::array<Nasty, 3>;

inline void showValue(const Nasty& nasty, std::ostream& os) {
  os << nasty.value() << " (0x" << std::hex << hw::bits_of(nasty.value()) << std::dec << ")";
}

namespace {

// Reproducible unless asked otherwise.
[[maybe_unused]] const int parameters = setenv("RC_PARAMS", "seed=20261122 max_success=400", 0);

rc::Gen<Nasty> nasty(int count) {
  return rc::gen::map(rc::gen::inRange(0, count), [](int index) { return Nasty{index}; });
}
rc::Gen<NastyVector> nasty_vector(int count) { return rc::gen::container<NastyVector>(nasty(count)); }
rc::Gen<std::vector<NastyTriangle>> nasty_soup(int count) {
  return rc::gen::resize(
      12, rc::gen::container<std::vector<NastyTriangle>>(rc::gen::container<NastyTriangle>(nasty(count))));
}

hw::Vector vector(const Nasty& x, const Nasty& y, const Nasty& z) { return {x.value(), y.value(), z.value()}; }

/// Every third triangle is dynamic.
StressGeometry geometry_of(const std::vector<NastyTriangle>& soup) {
  StressGeometry geometry;
  for (std::size_t i = 0; i < soup.size(); ++i) {
    const NastyTriangle& t = soup[i];
    add_triangle(i % 3 == 2 ? geometry.dynamic : geometry.fixed, vector(t[0], t[1], t[2]), vector(t[3], t[4], t[5]),
                 vector(t[6], t[7], t[8]));
  }
  return geometry;
}

/// No ray of a frame has a direction below 2^-51, and Embree takes a component below 1e-18 for that.  Beyond 1.844e18
/// Embree has no valid rays (and Debian's stops the program).
bool embree_can_take(const hw::Ray& ray) {
  constexpr float limit = 1.8e18f;
  for (int i = 0; i < 3; ++i) {
    if (!(std::fabs(ray.origin[i]) < limit && std::fabs(ray.direction[i]) < limit)) return false;
  }
  return std::fabs(ray.direction[ray.kz]) >= 0x1p-50f;
}

void expect_alike(const Subject& subject, const Subject& truth, const hw::Ray& ray) {
  const Answer expected = truth.closest(ray), found = subject.closest(ray);
  RC_LOG() << subject.name() << ": " << found.hit << " " << found.primitive << " t " << found.at.t << "; "
           << truth.name() << ": " << expected.hit << " " << expected.primitive << " t " << expected.at.t << "\n";
  RC_ASSERT(found == expected);
  RC_ASSERT(subject.occluded(ray) == expected.hit);
}

/// With a few rays for each soup, since its trees cost more than they do.
template <typename Check>
void with_rays(const std::vector<NastyTriangle>& soup, int count, const hw::PrecisionConfig& precision,
               const Check& check) {
  const hw::HitTests tests(precision);
  const auto rays = *rc::gen::container<std::vector<std::pair<NastyVector, NastyVector>>>(
      8, rc::gen::pair(nasty_vector(count), nasty_vector(count)));
  const auto limit = *rc::gen::element(hw::two_pow_100, 1.0f);
  for (const auto& [origin, direction] : rays) {
    hw::Ray ray;
    ray.origin = vector(origin[0], origin[1], origin[2]);
    ray.direction = vector(direction[0], direction[1], direction[2]);
    ray.tmax = limit;
    if (hw::is_zero(ray.direction)) continue;
    tests.set_up(ray);
    check(ray);
  }
}

/// Binary32, or any width for either test; shrinks towards 7.
hw::PrecisionConfig any_width() {
  const auto width = rc::gen::inRange<std::uint32_t>(7, 24);
  const std::uint32_t box = *width, triangle = *width;
  return {box, triangle, 23};
}

void walks_equal_brute_force(int count, const hw::PrecisionConfig& precision = {}) {
  const hw::HitTests tests(precision);
  const auto soup = *nasty_soup(count);
  const StressGeometry geometry = geometry_of(soup);
  const std::vector<Corners> triangles = corners_of(geometry);
  const SubjectPointer truth = brute_force(triangles, tests);
  std::vector<SubjectPointer> walkers;
  for (const hw::TreeKind kind : all_trees) {
    walkers.push_back(walker(tree_name(kind), lay_down(geometry, kind), tests));
  }
  with_rays(soup, count, precision, [&](const hw::Ray& ray) {
    for (const SubjectPointer& subject : walkers) expect_alike(*subject, *truth, ray);
  });
}

TEST(StressProperty, WalksEqualBruteForceOnNastyCoordinates) {
  EXPECT_TRUE(rc::check([] { walks_equal_brute_force(Nasty::count); }));
}

TEST(StressProperty, WalksEqualBruteForceOnModerateCoordinates) {
  EXPECT_TRUE(rc::check([] { walks_equal_brute_force(Nasty::moderate); }));
}

TEST(StressProperty, WalksEqualBruteForceInEveryFormat) {
  EXPECT_TRUE(rc::check([] { walks_equal_brute_force(Nasty::count, any_width()); }));
  EXPECT_TRUE(rc::check([] { walks_equal_brute_force(Nasty::moderate, any_width()); }));
}

void golden_model_equals_brute_force(const hw::PrecisionConfig& precision) {
  const auto soup = *nasty_soup(Nasty::count);
  const StressGeometry geometry = geometry_of(soup);
  const std::vector<Corners> triangles = corners_of(geometry);
  const SubjectPointer truth = brute_force(triangles, hw::HitTests(precision));
  ref::Extent origins;
  const double far = 0x1p62;
  origins.add({-far, -far, -far});
  origins.add({far, far, far});
  const ref::Precision golden{static_cast<int>(precision.box), static_cast<int>(precision.triangle), 23};
  const auto tracer = std::make_shared<const ref::Tracer>(geometry.fixed, geometry.dynamic, origins, golden);
  const SubjectPointer all = golden_brute_force(tracer), embree = golden_traversal(tracer);
  with_rays(soup, Nasty::count, precision, [&](const hw::Ray& ray) {
    expect_alike(*all, *truth, ray);
    if (embree_can_take(ray)) expect_alike(*embree, *truth, ray);
  });
}

TEST(StressProperty, TheGoldenModelEqualsBruteForce) {
  EXPECT_TRUE(rc::check([] { golden_model_equals_brute_force({}); }));
}

TEST(StressProperty, TheGoldenModelEqualsBruteForceInEveryFormat) {
  EXPECT_TRUE(rc::check([] { golden_model_equals_brute_force(any_width()); }));
}

}  // namespace
}  // namespace artu::sim
