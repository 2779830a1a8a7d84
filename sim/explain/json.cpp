#include <nlohmann/json.hpp>

#include "sim/explain/explain.h"

namespace artu::sim {

/// docs/explain.md has what each key means.
std::string explanation_json(const Explanation& e) {
  using Json = nlohmann::ordered_json;
  const Accounting& a = e.account;
  Json json = {{"schema", 1}, {"frames", e.frames}, {"cycles", a.cycles}};
  for (const Finding& finding : e.found) {
    json["bottlenecks"].push_back({{"name", name_of(finding.bound)},
                                   {"kind", finding.throughput ? "throughput" : "other"},
                                   {"cycles", finding.cycles},
                                   {"evidence", finding.evidence}});
  }
  json["phases"] = {
      {"start", a.start}, {"build", a.build}, {"first", a.first}, {"selective", a.selective}, {"flush", a.flush}};
  for (std::size_t i = 0; i < resource_count; ++i) json["needs"][name_of(static_cast<Resource>(i))] = a.needs[i];
  for (std::size_t i = 0; i < place_count; ++i) json["taken"][name_of(static_cast<Place>(i))] = a.taken[i];
  json["resident"] = {
      {"cycles", a.resident}, {"in_pipelines", a.in_pipelines}, {"to_l2", a.to_l2}, {"to_dram", a.to_dram}};
  json["builder"] = {{"cycles", a.builder}, {"computes", a.builder_computes}, {"sweeps", a.builder_sweeps}};
  json["dram_read"] = {{"cycles", a.dram_read_cycles}, {"idle_cycles", a.dram_idle_cycles}, {"row_hits", a.row_hits}};
  json["advice"] = Json::array();
  for (std::size_t i = 0; i < e.advice.size(); ++i) {
    const Advice& advice = e.advice[i];
    Json item = {{"parameter", advice.parameter}, {"from", advice.from},     {"to", advice.to},
                 {"floor", advice.floor},         {"floor_far", advice.far}, {"then", advice.then}};
    if (i < e.measured.size()) item["measured"] = e.measured[i];
    json["advice"].push_back(item);
  }
  return json.dump(1) + "\n";
}

}  // namespace artu::sim
