// Traces a case's rays with every subject and counts where they disagree.
#pragma once

#include <functional>

#include "sim/stress/accuracy.h"
#include "sim/stress/rays.h"
#include "sim/stress/result.h"

namespace artu::sim {

/// Who is compared.  `truth` decides who is wrong; it and `slow` answer a sample, and wherever `fast` ones disagree.
struct Contest {
  const Subject* truth = nullptr;
  std::vector<const Subject*> slow, fast;
};

struct CampaignPlan {
  std::uint64_t seed = 1, rays = 1000;
  std::uint64_t slow_every = 1;       // rays from one that `slow` subjects answer to the next
  std::uint64_t exact_every = 4;      // that are compared with exact arithmetic
  std::uint64_t secondary_every = 2;  // hits whose surface point is tested
  hw::PrecisionConfig precision;
  bool leaks_only = false;  // rays that leave a closed surface through its vertices and edges, and nothing else
};

class Campaign {
 public:
  /// All must outlive the campaign.
  Campaign(const StressCase& name, const StressGeometry& geometry, const std::vector<Corners>& triangles,
           const Contest& contest, const CampaignPlan& plan);
  CaseResult run();

 private:
  /// Counts disagreements; returns the first fast subject's answer, or the truth's.
  Answer compare(const hw::Ray& ray, bool sampled, const char* kind, std::uint64_t index);
  void judge(std::size_t tally, const Subject& subject, const hw::Ray& ray, const Answer& truth, const Answer& answer,
             bool occluded, const char* kind, std::uint64_t index);
  void leave_surface(const StressRay& from, const Answer& answer, std::uint64_t index);
  void measure(const StressRay& ray, const Answer& answer);
  void judge_leak(const StressRay& ray, const Answer& answer, std::uint64_t index);
  void run_leaks();
  void keep(const Failure& failure);

  const StressGeometry& geometry_;
  const std::vector<Corners>& triangles_;
  const Contest contest_;
  const CampaignPlan plan_;
  const hw::HitTests tests_;
  const RaySource source_;
  const Scale scale_;
  CaseResult result_;
  std::vector<Answer> answers_;
  std::vector<bool> occluded_;
};

}  // namespace artu::sim
