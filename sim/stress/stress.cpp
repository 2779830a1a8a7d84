#include "sim/stress/stress.h"

#include <algorithm>

#include "sim/report/names.h"
#include "sim/stress/campaign.h"
#include "sim/stress/random.h"
#include "sim/stress/subjects.h"

namespace artu::sim {
namespace {

/// Triangle tests of a case that brute force may spend, and for each ray where there are many; more where a ray costs
/// few.
constexpr std::uint64_t small_mesh = 1500, tests_of_small = 20000000, tests_of_large = 1000000, tests_a_ray = 100;
/// Below this width Embree's boxes are so wide for rays from far away that they are all met.
constexpr int narrow = 17;
/// Where every ray meets every triangle: tests that a subject may spend on a case.
constexpr std::uint64_t overlapping_tests = 20000000;

std::uint64_t stride(std::uint64_t rays, std::uint64_t triangles) {
  const std::uint64_t budget = triangles <= small_mesh ? tests_of_small : tests_of_large;
  const std::uint64_t sample = std::max(budget, rays * tests_a_ray) / std::max<std::uint64_t>(triangles, 1);
  if (sample >= rays) return 1;
  std::uint64_t every = rays / std::max<std::uint64_t>(sample, 1);
  // Prime to the number of kinds of rays (10), or only some kinds would be met.
  while (every % 2 == 0 || every % 5 == 0) ++every;
  return every;
}

ref::Extent extent_of(const Cube& cube) {
  ref::Extent box;
  const hw::Vector c = cube.center;
  const double half = cube.half;
  box.add({c.x - half, c.y - half, c.z - half});
  box.add({c.x + half, c.y + half, c.z + half});
  return box;
}

}  // namespace

CaseResult run_case(const StressCase& name, std::uint64_t rays, const StressOptions& options) {
  const StressGeometry geometry = placed(make_mesh(name.mesh, options.seed, !options.only.empty()), name.placement);
  const std::vector<Corners> triangles = corners_of(geometry);

  CampaignPlan plan;
  plan.seed = Random::mix(options.seed) ^ Random::hash(name.name());
  plan.rays = rays;
  if (name.mesh == "identical") {
    plan.rays = std::max<std::uint64_t>(std::min(rays, overlapping_tests / triangles.size()), 20);
  }
  plan.slow_every = stride(plan.rays, triangles.size());

  plan.precision = options.precision;
  plan.leaks_only = options.leaks_only;
  const hw::HitTests tests(plan.precision);
  const RaySource source(StressGeometry{}, triangles, plan.seed, plan.precision);
  const ref::Precision golden{static_cast<int>(plan.precision.box), static_cast<int>(plan.precision.triangle), 23};
  const ref::Extent near = extent_of(source.near_origins());
  const auto tracer = std::make_shared<const ref::Tracer>(geometry.fixed, geometry.dynamic, near, golden);
  const auto far =
      std::make_shared<const ref::Tracer>(geometry.fixed, geometry.dynamic, extent_of(source.origins()), golden);
  const SubjectPointer truth = brute_force(triangles, tests), reference = golden_brute_force(tracer);
  std::vector<SubjectPointer> fast;
  for (const hw::TreeKind kind : all_trees) {
    fast.push_back(walker(tree_name(kind), lay_down(geometry, kind), tests));
  }
  fast.push_back(golden_traversal(tracer, near, far, golden.narrower_test() < narrow));
  Contest contest;
  contest.truth = truth.get();
  contest.slow = {reference.get()};
  for (const SubjectPointer& subject : fast) contest.fast.push_back(subject.get());
  return Campaign(name, geometry, triangles, contest, plan).run();
}

StressReport run_stress(const StressOptions& options, const CaseDone& done) {
  StressReport report;
  report.options = options;
  const std::vector<StressCase> cases = stress_cases(options.only, options.leaks_only);
  std::uint64_t count = 0;
  for (const StressCase& one : cases) count += is_available(one.mesh) ? 1 : 0;
  for (const StressCase& one : cases) {
    if (is_available(one.mesh)) {
      report.cases.push_back(run_case(one, std::max<std::uint64_t>(options.rays / count, 1), options));
    } else {
      report.skipped.push_back(one.name());
    }
    done();
  }
  return report;
}

}  // namespace artu::sim
