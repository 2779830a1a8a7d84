#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/config/json.h"
#include "sim/precision/report.h"
#include "sim/report/names.h"

namespace artu::sim {
namespace {

using Json = nlohmann::ordered_json;

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json object_of(const ImageError& e) {
  return {{"psnr", finite(e.psnr())},
          {"ssim", finite(e.ssim())},
          {"differing_share", e.differing_share()},
          {"differing_pixels", e.differing()},
          {"largest", e.largest()}};
}

Json object_of(const SweepRow& r) {
  return {{"tree", tree_name(r.tree)},
          {"box_bits", r.format.box},
          {"triangle_bits", r.format.triangle},
          {"shading_bits", r.format.shading},
          {"cycles", r.cycles},
          {"rays", r.rays},
          {"node_visits", r.node_visits},
          {"box_tests", r.box_tests},
          {"triangle_tests", r.triangle_tests},
          {"dram_bytes", r.dram_bytes},
          {"traced_share", r.traced_share},
          {"from_binary32", object_of(r.from_binary32)},
          {"from_binary64", object_of(r.from_binary64)},
          {"run_time_ratio", r.run_time}};
}

}  // namespace

std::string format_json(const std::vector<SweepRow>& rows, const SweepPlan& plan, const Manifest& m) {
  Json json = {{"schema", precision_schema}, {"version", m.version}};
  json["scene"] = scene_json(m);
  json["rows"] = Json::array();
  for (const SweepRow& row : rows) json["rows"].push_back(object_of(row));
  // Of the unit, but for what the rows themselves say.
  Json& configuration = json["configuration"] = json_of(plan.unit);
  configuration.erase("accel");
  configuration.erase("precision");
  // A file name need not be UTF-8; JSON must be.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace artu::sim
