#include "sim/report/stats_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/energy/energy_report.h"

namespace artu::sim {
namespace {

using Json = nlohmann::ordered_json;

void put(Json& object, const Number& number) {
  Json* place = &object;
  std::size_t start = 0;
  for (std::size_t dot; (dot = number.name.find('.', start)) != std::string::npos; start = dot + 1) {
    place = &(*place)[number.name.substr(start, dot - start)];
  }
  Json& value = (*place)[number.name.substr(start)];
  std::visit([&](auto v) { value = v; }, number.value);
}

Json object_of(const std::vector<Number>& numbers) {
  Json object = Json::object();
  for (const Number& number : numbers) put(object, number);
  return object;
}

/// Intervals of 95 % of those figures that are estimates, under the names that the figures have.
Json object_of(const std::vector<Estimate>& estimates) {
  Json object = Json::object();
  for (const Estimate& e : estimates) {
    const Json interval = {{"value", e.value}, {"low", e.low}, {"high", e.high}, {"unit", e.unit}};
    (e.block.empty() ? object[e.name] : object["blocks"][e.block][e.name]) = interval;
  }
  return object;
}

/// Numbers, and the counters of each block; a block's name, dots and all, is one key.
Json object_of(const Totals& totals) {
  Json object = object_of(frame_numbers(totals));
  Json& blocks = object["blocks"] = Json::object();
  for (const hw::Statistic& s : totals.statistics) blocks[s.block][s.name] = s.value;
  if (!is_exact(totals.fidelity)) object["estimates"] = object_of(totals.estimates);
  return object;
}

/// A block's or an event's name, dots and all, is one key.
Json object_of(const Energy* energy) {
  if (energy == nullptr) return {};
  Json object = object_of(energy_numbers(*energy));
  for (const Number& number : energy_blocks(*energy)) object["blocks"][number.name] = std::get<double>(number.value);
  for (const Number& number : energy_events(*energy)) object["events"][number.name] = std::get<double>(number.value);
  return object;
}

Json object_of(const std::vector<Demand>& demands) {
  Json object = {{"bottleneck", bottleneck(demands).resource}};
  for (const Demand& demand : demands) object["shares"][demand.resource] = demand.share;
  return object;
}

Json first_mismatch(const PixelMismatch& m) {
  Json object = {{"frame", m.frame}, {"x", m.x}, {"y", m.y}};
  const PixelFields fields = differing_fields(m.golden, m.unit);
  for (std::size_t f = 0; f < pixel_field_count; ++f) {
    const auto field = static_cast<PixelField>(f);
    object["fields"][field_name(field)] = {
        {"unit", field_text(field, m.unit)}, {"golden", field_text(field, m.golden)}, {"differs", bool(fields[f])}};
  }
  return object;
}

Json object_of(const CheckResult& check) {
  Json object = {{"passed", check.passed()}, {"pixels", check.pixels}, {"differing_pixels", check.differing_pixels}};
  for (std::size_t f = 0; f < pixel_field_count; ++f) {
    object["differing"][field_name(static_cast<PixelField>(f))] = check.differing_fields[f];
  }
  object["rays"] = Json::array();
  for (const RayMismatch& m : check.rays) {
    object["rays"].push_back({{"frame", m.frame}, {"kind", m.kind}, {"unit", m.unit}, {"golden", m.golden}});
  }
  object["first"] = check.first ? first_mismatch(*check.first) : Json();
  return object;
}

std::string indented(const Json& json, const std::string& by) {
  std::string text = json.dump(1), out;
  for (const char c : text) {
    out += c;
    if (c == '\n') out += by;
  }
  return out;
}

}  // namespace

StatsJson::StatsJson(const std::string& file) : file_(file) {
  file_.write(fmt::format("{{\n \"schema\": {},\n \"frames\": [", schema));
}

void StatsJson::add_frame(std::uint32_t index, const Totals& frame, const std::vector<std::string>& violations,
                          const Energy* energy) {
  Json object = {{"index", index}};
  object.update(object_of(frame));
  if (energy != nullptr || has_energy(frame.fidelity)) object["energy"] = object_of(energy);
  object["violations"] = violations;
  file_.write(first_ ? "\n  " : ",\n  ");
  file_.write(indented(object, "  "));
  first_ = false;
}

void StatsJson::finish(const Totals& sum, std::uint32_t clock_mhz, const CheckResult* check, const Energy* energy,
                       const std::vector<Demand>& demands) {
  const Json fidelity = {{"mode", fidelity_name(sum.fidelity)}, {"promise", promise_of(sum.fidelity)}};
  Json totals = {{"frames", sum.frames}};
  totals.update(object_of(sum));
  file_.write("\n ],\n");
  file_.write(" \"fidelity\": " + indented(fidelity, " ") + ",\n");
  file_.write(" \"totals\": " + indented(totals, " ") + ",\n");
  file_.write(" \"derived\": " + indented(object_of(derived_numbers(sum, clock_mhz)), " ") + ",\n");
  if (energy != nullptr || has_energy(sum.fidelity)) {
    file_.write(" \"energy\": " + indented(object_of(energy), " ") + ",\n");
  }
  if (!demands.empty()) file_.write(" \"demand\": " + indented(object_of(demands), " ") + ",\n");
  file_.write(" \"check\": " + (check ? indented(object_of(*check), " ") : "null") + ",\n");
  const auto simulation = simulation_numbers(sum, check ? check->golden_seconds : -1);
  file_.write(" \"simulation\": " + indented(object_of(simulation), " ") + "\n}\n");
  file_.close();
}

}  // namespace artu::sim
