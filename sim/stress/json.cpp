#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/stress/report.h"

namespace artu::sim {
namespace {

using Json = nlohmann::ordered_json;

Json object_of(const Count& count) { return {{"tried", count.tried}, {"happened", count.happened}}; }

Json object_of(const Distribution& d) {
  if (d.count() == 0) return {{"count", 0}};
  // An infinite error has no number in JSON and becomes null.
  return {{"count", d.count()}, {"p50", d.quantile(0.5)}, {"p99", d.quantile(0.99)}, {"max", d.quantile(1)}};
}

Json bits(hw::Vector v) {
  const auto hex = [](float x) { return fmt::format("{:#010x}", hw::bits_of(x)); };
  return {hex(v.x), hex(v.y), hex(v.z)};
}

Json object_of(const Answer& answer, const std::optional<Corners>& triangle) {
  if (!answer.hit) return {{"hit", false}};
  Json object = {{"hit", true}, {"primitive", answer.primitive}};
  object["t_u_v_det"] = {
      fmt::format("{:#010x}", hw::bits_of(answer.at.t)), fmt::format("{:#010x}", hw::bits_of(answer.at.U)),
      fmt::format("{:#010x}", hw::bits_of(answer.at.V)), fmt::format("{:#010x}", hw::bits_of(answer.at.det))};
  if (triangle) object["triangle"] = {bits((*triangle)[0]), bits((*triangle)[1]), bits((*triangle)[2])};
  return object;
}

Json object_of(const Failure& f) {
  Json object = {{"what", f.what}, {"case", f.case_name}, {"ray", f.index}, {"kind", f.ray_kind}};
  object["origin"] = bits(f.ray.origin);
  object["direction"] = bits(f.ray.direction);
  object["tmax"] = fmt::format("{:#010x}", hw::bits_of(f.ray.tmax));
  object["expected"] = object_of(f.expected, f.expected_triangle);
  object["found"] = object_of(f.found, f.found_triangle);
  if (f.occlusion) object["found"]["any_hit"] = f.found_occluded;
  return object;
}

Json object_of(const CaseResult& r) {
  Json object = {{"mesh", r.name.mesh}, {"placement", r.name.placement.name}, {"triangles", r.triangles}};
  object["rays"] = r.rays;
  object["hits"] = r.hits;
  object["secondary_rays"] = r.secondary;
  for (const Tally& tally : r.tallies) {
    object["subjects"][tally.name] = {{"compared", tally.compared}, {"mismatches", tally.mismatches}};
  }
  object["leaks"] = object_of(r.leaks);
  object["self_hits_outside"] = object_of(r.self_out);
  object["self_hits_inside"] = object_of(r.self_in);
  object["convex_hits"] = object_of(r.convex);
  object["t_ulps"] = object_of(r.accuracy.t_ulps);
  object["t_ulps_all"] = object_of(r.accuracy.t_ulps_all);
  object["u_error"] = object_of(r.accuracy.u);
  object["v_error"] = object_of(r.accuracy.v);
  object["wrong_decisions"] = object_of(r.accuracy.decisions);
  object["wrong_decisions_explained"] = r.accuracy.explained;
  object["first"] = r.first ? object_of(*r.first) : Json();
  return object;
}

Json object_of(const StressReport& report) {
  const StressTotals totals = totals_of({report});
  Json json = {{"box_bits", report.options.precision.box}, {"triangle_bits", report.options.precision.triangle}};
  json["rays"] = totals.rays;
  json["hits"] = totals.hits;
  json["secondary_rays"] = totals.secondary;
  json["mismatches"] = totals.mismatches;
  json["leaks"] = totals.leaks;
  json["all"] = object_of(sum_of(report));
  json["cases"] = Json::array();
  for (const CaseResult& one : report.cases) json["cases"].push_back(object_of(one));
  json["placements"] = Json::array();
  for (const CaseResult& one : by_placement(report)) json["placements"].push_back(object_of(one));
  json["skipped"] = report.skipped;
  return json;
}

}  // namespace

std::string format_json(const StressReports& reports) {
  const StressTotals totals = totals_of(reports);
  const StressOptions& options = reports[0].options;
  Json json = {{"schema", 2}, {"seed", options.seed}, {"leaks_only", options.leaks_only}};
  json["rays"] = totals.rays;
  json["secondary_rays"] = totals.secondary;
  json["mismatches"] = totals.mismatches;
  json["leaks"] = totals.leaks;
  json["passed"] = totals.passed();
  json["formats"] = Json::array();
  for (const StressReport& report : reports) json["formats"].push_back(object_of(report));
  json["first"] = totals.first != nullptr ? object_of(*totals.first) : Json();
  return json.dump(1) + "\n";
}

}  // namespace artu::sim
