#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/config/dump.h"
#include "sim/report/digest.h"
#include "sim/sweep/figures.h"
#include "sim/sweep/plan.h"

namespace artu::sim {
namespace {

using Json = nlohmann::ordered_json;

Json design_json(const Grid& grid) {
  Json design = {{"kind", design_name(grid.design)}};
  if (grid.design == Design::grid || grid.design == Design::list) return design;
  design["samples"] = grid.samples;
  design["seed"] = grid.seed;
  if (grid.design == Design::search) design["batch"] = grid.batch;
  return design;
}

Json axis_json(const Axis& axis) {
  const ParameterInfo& parameter = axis.parameter;
  Json json = {{"path", parameter.path},         {"kind", kind_name(parameter.kind)},
               {"unit", parameter.unit},         {"range", parameter.range},
               {"text", parameter.text},         {"default", json_of_toml(parameter.default_value)},
               {"base", json_of_toml(axis.base)}};
  if (parameter.power_of_two) json["power_of_two"] = true;
  if (axis.is_interval()) {
    // Numbers of the same kind as the parameter: 4 and not 4.0.
    const bool integer = parameter.kind == ParameterKind::integer;
    const auto number = [&](double value) { return integer ? Json(static_cast<std::uint64_t>(value)) : Json(value); };
    json["low"] = number(axis.low);
    json["high"] = number(axis.high);
    json["scale"] = axis.logarithmic ? "log" : "linear";
  } else {
    json["values"] = Json::array();
    for (const std::string& value : axis.values) json["values"].push_back(json_of_toml(value));
  }
  return json;
}

}  // namespace

std::string to_json(const SweepPoints& plan) {
  const Grid& grid = plan.grid;
  Json json = {{"schema", 1}, {"program", "artu"}, {"version", ARTU_VERSION}, {"design", design_json(grid)}};
  json["fidelity"] = fidelity_name(grid.simulation.fidelity);
  if (grid.screen) {
    json["screen"] = {{"fidelity", fidelity_name(grid.screen->fidelity)}, {"margin", grid.screen->margin}};
  }
  json["sample"] = grid.sample_words;
  if (!grid.fault_words.empty()) json["inject_fault"] = grid.fault_words;
  json["pictures"] = grid.pictures ? Json(grid.picture_words) : Json();
  json["invalid"] = grid.skip_invalid ? "skip" : "refuse";
  json["scenes"] = Json::array();
  for (std::size_t i = 0; i < grid.scenes.size(); ++i) {
    const SourceOptions& scene = grid.scenes[i];
    json["scenes"].push_back({{"file", grid.scene_files[i]},
                              {"sha256", plan.scene_sha256[i]},
                              {"frames", scene.frames ? Json(*scene.frames) : Json()},
                              {"size", scene.size ? Json(*scene.size) : Json()},
                              {"fps", scene.fps ? Json(*scene.fps) : Json()}});
  }
  json["set"] = grid.assignments;
  json["configuration_sha256"] = sha256_of(dump_config(grid.base.unit()));
  json["parameters"] = Json::array();
  for (const Axis& axis : grid.axes) json["parameters"].push_back(axis_json(axis));
  json["objectives"] = Json::array();
  for (const Objective& objective : grid.objectives) {
    json["objectives"].push_back(
        {{"figure", objective.figure}, {"goal", objective.maximise ? "maximise" : "minimise"}});
  }
  if (grid.design != Design::search) {
    std::string names;
    for (const SweepPoint& point : plan.points) names += point.name + "\n";
    json["points"] = plan.points.size();
    json["points_sha256"] = sha256_of(names);
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace artu::sim
