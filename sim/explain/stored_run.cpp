#include "sim/explain/stored_run.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "sim/config/configuration.h"
#include "sim/report/file.h"
#include "sim/report/stats_json.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

using Json = nlohmann::json;

Json parse(const std::string& file) {
  if (!std::filesystem::exists(file)) {
    throw InputError(file, "is not there; a folder that `artu run` has written would be right");
  }
  Json json = Json::parse(read_file(file), nullptr, false);
  if (json.is_discarded()) throw InputError(file, "is not JSON; a folder that `artu run` has written would be right");
  return json;
}

hw::Statistics statistics_of(const Json& blocks) {
  hw::Statistics out;
  for (const auto& [block, counters] : blocks.items()) {
    for (const auto& [name, value] : counters.items()) out.push_back({block, name, value.get<std::uint64_t>(), "", ""});
  }
  return out;
}

void read_stats(const std::string& file, Totals& totals) {
  const Json json = parse(file);
  try {
    const int schema = json.at("schema").get<int>();
    if (schema != StatsJson::schema) {
      throw InputError(file, "has schema " + std::to_string(schema) + "; " + std::to_string(StatsJson::schema) +
                                 ", as this version writes it, would be right");
    }
    totals.fidelity = parse_fidelity(json.at("fidelity").at("mode").get<std::string>());
    const Json& sum = json.at("totals");
    totals.frames = sum.at("frames").get<std::uint64_t>();
    if (has_cycles(totals.fidelity)) totals.cycles = sum.at("cycles").get<std::uint64_t>();
    if (totals.frames == 0 || (is_exact(totals.fidelity) && totals.cycles == 0)) {
      throw InputError(file, "holds no frame; one that `artu run` has written would be right");
    }
    totals.dynamic_tree.leaves = sum.at("tree").at("leaves").get<std::uint64_t>();
    totals.statistics = statistics_of(sum.at("blocks"));
  } catch (const Json::exception&) {
    throw InputError(file, "lacks numbers of a run; one that `artu run` has written would be right");
  }
}

void read_manifest(const std::string& file, StoredRun& run) {
  const Json json = parse(file);
  Manifest& m = run.manifest;
  try {
    m.input = json.at("input").at("file").get<std::string>();
    m.input_sha256 = json.at("input").at("sha256").get<std::string>();
    m.input_is_trace = json.at("input").at("kind").get<std::string>() == "trace";
    m.first_frame = json.at("frames").at("first").get<std::uint32_t>();
    m.last_frame = json.at("frames").at("last").get<std::uint32_t>();
    m.width = json.at("size").at("width").get<std::uint32_t>();
    m.height = json.at("size").at("height").get<std::uint32_t>();
    m.fps = json.at("fps").get<double>();
    m.simulation.fidelity = parse_fidelity(json.at("fidelity").get<std::string>());
    m.simulation.random_stall = json.at("random_stall").get<bool>();
    run.falsified = json.at("falsified").get<bool>();
  } catch (const Json::exception&) {
    throw InputError(file, "lacks what was run; one that `artu run` has written would be right");
  }
}

}  // namespace

StoredRun read_run(const std::string& folder) {
  StoredRun run;
  read_stats(folder + "/stats.json", run.totals);
  read_manifest(folder + "/manifest.json", run);
  Configuration configuration;
  configuration.load(folder + "/config.toml");
  configuration.check();
  run.unit = configuration.unit();
  return run;
}

}  // namespace artu::sim
