#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/bench/report.h"

namespace artu::sim {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json optional(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

Json object_of(const ModeResult& r) {
  Json json = {{"mode", r.mode},
               {"seconds", r.median()},
               {"spread", r.spread()},
               {"rounds", r.seconds},
               {"cycles", optional(r.cycles)},
               {"interval", Json()},
               {"primary_rays", r.primary_rays},
               {"node_visits", r.node_visits},
               {"peak_bytes", r.peak_bytes}};
  if (r.interval) json["interval"] = {r.interval->low, r.interval->high};
  return json;
}

Json object_of(const BenchScene& scene) {
  Json json = {{"name", scene.name},     {"frame", scene.frame},         {"width", scene.width},
               {"height", scene.height}, {"triangles", scene.triangles}, {"modes", Json::array()}};
  for (const ModeResult& r : scene.results) {
    Json mode = object_of(r);
    mode["golden_ratio"] = optional(scene.ratio(r, golden_mode));
    mode["functional_ratio"] = optional(scene.ratio(r, fidelity_name(Fidelity::functional)));
    mode["error"] = optional(scene.error(r));
    mode["covered"] = optional(scene.covered(r));
    json["modes"].push_back(std::move(mode));
  }
  return json;
}

Json object_of(const ModeSummary& row) {
  return {{"mode", row.mode},
          {"scenes", row.scenes},
          {"golden_median", optional(row.golden_median)},
          {"golden_worst", optional(row.golden_worst)},
          {"functional_median", optional(row.functional_median)},
          {"functional_worst", optional(row.functional_worst)},
          {"event_median", optional(row.event_median)},
          {"mean_error", optional(row.mean_error)},
          {"worst_error", optional(row.worst_error)},
          {"covered", optional(row.covered)}};
}

Json object_of(const PowerLaw& law) {
  if (!std::isfinite(law.exponent)) return {};
  return {{"factor", law.factor}, {"exponent", law.exponent}};
}

Json object_of(const Growth& growth, const std::vector<std::string>& modes) {
  Json json = {{"what", growth.what}, {"of", growth.of}, {"points", Json::array()}, {"laws", Json::object()}};
  for (const GrowthPoint& point : growth.points) {
    Json results = Json::array();
    for (const ModeResult& r : point.results) results.push_back(object_of(r));
    json["points"].push_back({{"value", point.value}, {"modes", std::move(results)}});
  }
  for (const std::string& mode : modes) {
    if (find(growth.points.at(0).results, mode) == nullptr) continue;
    json["laws"][mode] = {{"time", object_of(growth.time(mode))}, {"memory", object_of(growth.memory(mode))}};
  }
  return json;
}

}  // namespace

std::string bench_json(const BenchReport& report, const std::vector<std::string>& command, const std::string& version) {
  Json json = {{"schema", bench_schema},         {"version", version},       {"command", command},
               {"repeats", report.plan.repeats}, {"seed", report.plan.seed}, {"scenes", Json::array()},
               {"summary", Json::array()},       {"growth", Json::array()}};
  for (const BenchScene& scene : report.scenes) json["scenes"].push_back(object_of(scene));
  for (const ModeSummary& row : summaries(report.scenes, report.plan.modes)) json["summary"].push_back(object_of(row));
  for (const Growth& growth : report.growth) json["growth"].push_back(object_of(growth, report.plan.modes));
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace artu::sim
