#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/config/json.h"
#include "sim/quality/front.h"
#include "sim/quality/policies.h"
#include "sim/quality/report.h"

namespace artu::sim {
namespace {

using Json = nlohmann::ordered_json;

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(); }

template <class T>
Json optional(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

Json object_of(const AreaError& e) {
  return {{"pixels", e.pixels},
          {"squares", e.squares},
          {"psnr", finite(e.psnr())},
          {"ssim", finite(e.mean_ssim())},
          {"flip", finite(e.mean_flip())}};
}

Json object_of(const QualityRow& row) {
  Json json = {{"policy", row.policy},
               {"reference", optional(row.reference)},
               {"traced_share", row.traced_share()},
               {"rays", row.rays},
               {"cycles", optional(row.cycles)},
               {"dram_bytes", optional(row.dram_bytes)},
               {"energy_pj", optional(row.picojoules)}};
  for (std::size_t i = 0; i < area_count; ++i) json[area_names[i]] = object_of(row.errors.areas[i]);
  return json;
}

Json object_of(const FrontValue& value, const FrontValue& plain) {
  Json json;
  for (std::size_t i = 0; i < area_count; ++i) {
    json[area_names[i]] = {{"psnr", finite(value.psnr[i])}, {"gain", finite(value.psnr[i] - plain.psnr[i])}};
  }
  json["flip"] = finite(value.flip);
  json["flip_gain"] = finite(plain.flip - value.flip);
  return json;
}

}  // namespace

std::string quality_json(const std::vector<QualityRow>& rows, const std::vector<double>& shares,
                         const QualityPlan& plan, const Manifest& manifest) {
  Json json = {{"schema", quality_schema}, {"version", manifest.version}};
  json["scene"] = scene_json(manifest);
  json["rows"] = Json::array();
  for (const QualityRow& row : rows) json["rows"].push_back(object_of(row));
  json["equal_shares"] = Json::array();
  for (const double share : shares) {
    const FrontValue plain = front_at(rows, plain_policy, share);
    for (const std::string& policy : policies_of(rows)) {
      Json entry = {{"traced_share", share}, {"policy", policy}};
      entry.update(object_of(front_at(rows, policy, share), plain));
      json["equal_shares"].push_back(entry);
    }
  }
  json["configuration"] = json_of(plan.full);
  // Of the unit, but for what the rows themselves say.
  for (const char* name : {"enabled", "reference"}) json["configuration"]["selective"].erase(name);
  // A file name need not be UTF-8; JSON must be.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace artu::sim
