#include "sim/stress/report.h"

namespace artu::sim {
namespace {

void add(CaseResult& sum, const CaseResult& one) {
  sum.rays += one.rays;
  sum.hits += one.hits;
  sum.secondary += one.secondary;
  for (const Tally& tally : one.tallies) {
    const auto found = std::find_if(sum.tallies.begin(), sum.tallies.end(),
                                    [&](const Tally& other) { return other.name == tally.name; });
    Tally& place = found != sum.tallies.end() ? *found : sum.tallies.emplace_back(Tally{tally.name});
    place.compared += tally.compared;
    place.mismatches += tally.mismatches;
  }
  sum.leaks.add(one.leaks);
  sum.self_out.add(one.self_out);
  sum.self_in.add(one.self_in);
  sum.convex.add(one.convex);
  Accuracy& a = sum.accuracy;
  a.t_ulps.add(one.accuracy.t_ulps);
  a.t_ulps_all.add(one.accuracy.t_ulps_all);
  a.u.add(one.accuracy.u);
  a.v.add(one.accuracy.v);
  a.decisions.add(one.accuracy.decisions);
  a.explained += one.accuracy.explained;
}

}  // namespace

std::vector<CaseResult> by_placement(const StressReport& report) {
  std::vector<CaseResult> rows;
  for (const Placement& placement : placements()) {
    CaseResult sum;
    sum.name = {"all", placement};
    for (const CaseResult& one : report.cases) {
      if (std::string(one.name.placement.name) == placement.name) add(sum, one);
    }
    if (sum.rays > 0) rows.push_back(std::move(sum));
  }
  return rows;
}

std::vector<CaseResult> by_mesh(const StressReport& report) {
  std::vector<CaseResult> rows;
  for (const MeshEntry& mesh : mesh_entries()) {
    CaseResult sum;
    sum.name = {mesh.name, {"all", 1, 0}};
    for (const CaseResult& one : report.cases) {
      if (one.name.mesh == mesh.name) add(sum, one);
    }
    if (sum.hits > 0) rows.push_back(std::move(sum));
  }
  return rows;
}

CaseResult sum_of(const StressReport& report) {
  CaseResult sum;
  sum.name = {"all", {"all", 1, 0}};
  for (const CaseResult& one : report.cases) add(sum, one);
  return sum;
}

StressTotals totals_of(const StressReports& reports) {
  StressTotals totals;
  for (const StressReport& report : reports) {
    for (const CaseResult& one : report.cases) {
      ++totals.cases;
      totals.rays += one.rays;
      totals.hits += one.hits;
      totals.secondary += one.secondary;
      totals.mismatches += one.mismatches();
      totals.leaks += one.leaks.happened;
      if (totals.first == nullptr && one.first) totals.first = &*one.first;
    }
  }
  return totals;
}

}  // namespace artu::sim
