// Every ray of the table, with every subject.
#include <gtest/gtest.h>

#include "unit/sim/stress_regressions.h"
#include "unit/sim/stress_support.h"

namespace artu::sim {
namespace {

StressGeometry geometry_of(const testing::Regression& regression) {
  StressGeometry geometry;
  const std::vector<std::uint32_t>& bits = regression.vertices;
  for (std::size_t i = 0; i < bits.size(); i += 9) {
    const auto vertex = [&](std::size_t at) -> hw::Vector {
      return {hw::float_of(bits[at]), hw::float_of(bits[at + 1]), hw::float_of(bits[at + 2])};
    };
    add_triangle(i / 9 % 3 == 2 ? geometry.dynamic : geometry.fixed, vertex(i), vertex(i + 3), vertex(i + 6));
  }
  return geometry;
}

hw::Vector vector(const std::uint32_t (&bits)[3]) {
  return {hw::float_of(bits[0]), hw::float_of(bits[1]), hw::float_of(bits[2])};
}

TEST(StressRegressions, EverySubjectAgrees) {
  for (const testing::Regression& regression : testing::regressions()) {
    SCOPED_TRACE(regression.name);
    const StressGeometry geometry = geometry_of(regression);
    const std::vector<Corners> triangles = corners_of(geometry);
    hw::Ray ray;
    ray.origin = vector(regression.origin);
    ray.direction = vector(regression.direction);
    ray.tmax = hw::float_of(regression.tmax);
    hw::set_up(ray);
    ref::Extent origins;
    origins.add({ray.origin.x, ray.origin.y, ray.origin.z});
    const auto tracer = std::make_shared<const ref::Tracer>(geometry.fixed, geometry.dynamic, origins);
    std::vector<SubjectPointer> subjects;
    subjects.push_back(golden_brute_force(tracer));
    subjects.push_back(golden_traversal(tracer));
    for (const hw::TreeKind kind : all_trees) {
      subjects.push_back(walker(tree_name(kind), lay_down(geometry, kind)));
    }
    const SubjectPointer truth = brute_force(triangles);
    const Answer expected = truth->closest(ray);
    EXPECT_EQ(expected.hit, regression.hit);
    for (const SubjectPointer& subject : subjects) {
      EXPECT_EQ(subject->closest(ray), expected) << subject->name();
      EXPECT_EQ(subject->occluded(ray), expected.hit) << subject->name();
    }
  }
}

}  // namespace
}  // namespace artu::sim
