#include "sim/sweep/figures.h"

#include <algorithm>
#include <functional>

#include "sim/command/example_scene.h"
#include "sim/driver/frame_simulator.h"
#include "sim/energy/energy_report.h"
#include "sim/report/numbers.h"
#include "sim/scaling/demand.h"

namespace artu::sim {
namespace {

using Json = nlohmann::ordered_json;

/// "triangle caches" -> "triangle_caches": a column is one word.
std::string word(std::string name) {
  name.erase(std::remove(name.begin(), name.end(), ','), name.end());
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

void flatten(const Json& object, const std::string& prefix, const std::vector<std::string>& without, Figures& figures) {
  for (const auto& [key, value] : object.items()) {
    if (prefix.empty() && std::find(without.begin(), without.end(), key) != without.end()) continue;
    if (value.is_object()) {
      flatten(value, prefix + key + ".", {}, figures);
    } else if (value.is_number()) {
      figures.emplace_back(prefix + word(key), value);
    }
  }
}

}  // namespace

Json json_of_toml(const std::string& value) { return Json::parse(value); }  // a value of ours is JSON as well

Figures figures_of(const Json& stats) {
  Figures figures;
  const Json& totals = stats.at("totals");
  flatten(totals, "", {"frames", "blocks", "estimates"}, figures);
  flatten(stats.at("derived"), "", {}, figures);
  if (stats.contains("energy") && stats["energy"].is_object()) flatten(stats["energy"], "energy.", {}, figures);
  if (stats.contains("demand")) {
    flatten(stats["demand"].at("shares"), "demand.", {}, figures);
    figures.emplace_back("bottleneck", stats["demand"].at("bottleneck"));
  }
  if (!totals.contains("estimates")) return figures;
  Figures all;
  const auto interval = [&all](const std::string& name, const Json& estimate, double scale) {
    all.emplace_back(name + ".low", estimate.at("low").get<double>() * scale);
    all.emplace_back(name + ".high", estimate.at("high").get<double>() * scale);
  };
  const Json& estimates = totals["estimates"];
  for (const auto& [name, value] : figures) {
    all.emplace_back(name, value);
    if (name != "blocks" && estimates.contains(name)) interval(name, estimates[name], 1);
    if (name == "cycles_per_frame" && estimates.contains("cycles")) {
      interval(name, estimates["cycles"], 1 / totals.at("frames").get<double>());
    }
  }
  return all;
}

std::vector<std::string> figure_names(Fidelity fidelity) {
  SimulationOptions options;
  options.fidelity = fidelity == Fidelity::sampled ? Fidelity::event : fidelity;
  const traces::Scene scene = example_scene();
  const hw::UnitConfig unit;
  Totals totals = totals_of(make_simulator(scene, unit, options)->run(example_frame()));
  totals.fidelity = fidelity;
  std::vector<std::string> names;
  const auto append = [&names](const std::string& prefix, const std::vector<Number>& numbers) {
    for (const Number& number : numbers) names.push_back(prefix + number.name);
  };
  append("", frame_numbers(totals));
  append("", derived_numbers(totals, unit.clock_mhz));
  if (const auto energy = energy_if_known(totals, unit)) {
    append("energy.", energy_numbers(*energy));
    append("energy.blocks.", energy_blocks(*energy));
    append("energy.events.", energy_events(*energy));
  }
  for (const Demand& demand : demands_if_known(totals, unit)) names.push_back("demand." + word(demand.resource));
  return names;
}

}  // namespace artu::sim
