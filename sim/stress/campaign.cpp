#include "sim/stress/campaign.h"

#include "sim/stress/secondary.h"

namespace artu::sim {

Campaign::Campaign(const StressCase& name, const StressGeometry& geometry, const std::vector<Corners>& triangles,
                   const Contest& contest, const CampaignPlan& plan)
    : geometry_(geometry),
      triangles_(triangles),
      contest_(contest),
      plan_(plan),
      tests_(plan.precision),
      source_(geometry, triangles, plan.seed, plan.precision),
      scale_{bounds_of(triangles).size, static_cast<int>(plan.precision.triangle)},
      answers_(contest.fast.size()),
      occluded_(contest.fast.size()) {
  result_.name = name;
  result_.triangles = triangles.size();
  for (const Subject* subject : contest.slow) result_.tallies.push_back({subject->name()});
  for (const Subject* subject : contest.fast) result_.tallies.push_back({subject->name()});
}

void Campaign::keep(const Failure& failure) {
  if (result_.first) return;
  result_.first = failure;
  Failure& first = *result_.first;
  first.case_name = result_.name.name();
  const auto triangle = [&](const Answer& answer, std::optional<Corners>& out) {
    if (answer.hit && answer.primitive < triangles_.size()) out = triangles_[answer.primitive];
  };
  triangle(first.expected, first.expected_triangle);
  triangle(first.found, first.found_triangle);
}

void Campaign::judge(std::size_t tally, const Subject& subject, const hw::Ray& ray, const Answer& truth,
                     const Answer& answer, bool occluded, const char* kind, std::uint64_t index) {
  ++result_.tallies[tally].compared;
  if (answer == truth && occluded == truth.hit) return;
  ++result_.tallies[tally].mismatches;
  Failure failure;
  failure.what = subject.name() + " against " + contest_.truth->name();
  failure.ray_kind = kind;
  failure.index = index;
  failure.ray = ray;
  failure.expected = truth;
  failure.found = answer;
  failure.occlusion = occluded != truth.hit;
  failure.found_occluded = occluded;
  keep(failure);
}

Answer Campaign::compare(const hw::Ray& ray, bool sampled, const char* kind, std::uint64_t index) {
  bool alike = true;
  const auto is_asked = [&](std::size_t i) { return i == 0 || sampled || !contest_.fast[i]->is_slow(ray); };
  for (std::size_t i = 0; i < contest_.fast.size(); ++i) {
    if (!is_asked(i)) continue;
    answers_[i] = contest_.fast[i]->closest(ray);
    occluded_[i] = contest_.fast[i]->occluded(ray);
    alike = alike && answers_[i] == answers_[0] && occluded_[i] == answers_[0].hit;
  }
  const bool ask = sampled || !alike || contest_.fast.empty();
  const Answer truth = ask ? contest_.truth->closest(ray) : answers_[0];
  std::size_t tally = 0;
  for (const Subject* subject : contest_.slow) {
    if (ask) judge(tally, *subject, ray, truth, subject->closest(ray), subject->occluded(ray), kind, index);
    ++tally;
  }
  for (std::size_t i = 0; i < contest_.fast.size(); ++i) {
    if (is_asked(i)) judge(tally, *contest_.fast[i], ray, truth, answers_[i], occluded_[i], kind, index);
    ++tally;
  }
  return contest_.fast.empty() ? truth : answers_[0];
}

void Campaign::leave_surface(const StressRay& from, const Answer& answer, std::uint64_t index) {
  const Corners& own = triangles_[answer.primitive];
  Random random(plan_.seed ^ 0x5ec0da27u, index);
  const SecondaryRays rays = secondary_rays(from.ray, answer.at, own, plan_.precision, random);
  hw::TriangleHit hit;
  for (std::size_t i = 0; i < rays.out.size(); ++i) {
    const hw::Ray& ray = rays.out[i];
    result_.self_out.add(tests_.triangle(ray, own[0], own[1], own[2], hit));
    if (!geometry_.convex || !rays.front || contest_.fast.empty()) continue;
    const Answer again = contest_.fast[0]->closest(ray);
    result_.convex.add(again.hit);
  }
  for (const hw::Ray& ray : rays.in) result_.self_in.add(tests_.triangle(ray, own[0], own[1], own[2], hit));
  compare(random.below(2) == 0 ? rays.out[0] : rays.in[1], index % plan_.slow_every == 0, "secondary", index);
  ++result_.secondary;
}

void Campaign::measure(const StressRay& ray, const Answer& answer) {
  if (answer.hit) measure_hit(ray, answer, triangles_[answer.primitive], scale_, result_.accuracy);
  if (answer.hit && answer.primitive == ray.target) return;
  if (!triangles_.empty()) measure_decision(tests_, ray.ray, triangles_[ray.target], scale_, result_.accuracy);
}

void Campaign::judge_leak(const StressRay& ray, const Answer& answer, std::uint64_t index) {
  if (!ray.must_hit) return;
  result_.leaks.add(!answer.hit);
  if (answer.hit || result_.first) return;
  Failure leak;
  leak.what = "leak";
  leak.ray_kind = kind_name(ray.kind);
  leak.index = index;
  leak.ray = ray.ray;
  keep(leak);
}

/// The first fast subject answers alone; where it says "miss", all are asked.
void Campaign::run_leaks() {
  if (!source_.has_inside()) return;
  for (std::uint64_t i = 0; i < plan_.rays; ++i) {
    const StressRay ray = source_.leaving_ray(i);
    Answer answer = contest_.fast[0]->closest(ray.ray);
    if (!answer.hit) answer = compare(ray.ray, true, kind_name(ray.kind), i);
    judge_leak(ray, answer, i);
    ++result_.rays;
    result_.hits += answer.hit ? 1 : 0;
  }
}

CaseResult Campaign::run() {
  if (plan_.leaks_only) {
    run_leaks();
    return std::move(result_);
  }
  std::uint64_t hits_seen = 0;
  for (std::uint64_t i = 0; i < plan_.rays; ++i) {
    const StressRay ray = source_.ray(i);
    const Answer answer = compare(ray.ray, i % plan_.slow_every == 0, kind_name(ray.kind), i);
    ++result_.rays;
    judge_leak(ray, answer, i);
    // Consecutive rays are of different kinds: a stride that is prime to their number meets them all.
    if ((i / ray_kinds) % plan_.exact_every == 0) measure(ray, answer);
    if (!answer.hit) continue;
    ++result_.hits;
    if (hits_seen++ % plan_.secondary_every == 0) leave_surface(ray, answer, i);
  }
  return std::move(result_);
}

}  // namespace artu::sim
