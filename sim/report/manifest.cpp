#include "sim/report/manifest.h"

#include <nlohmann/json.hpp>

namespace artu::sim {

std::string to_json(const Manifest& m) {
  nlohmann::ordered_json json = {
      {"program", "artu"},
      {"version", m.version},
      {"command", m.command},
      {"input", {{"file", m.input}, {"sha256", m.input_sha256}, {"kind", m.input_is_trace ? "trace" : "scene"}}},
      {"frames", {{"first", m.first_frame}, {"last", m.last_frame}}},
      {"size", {{"width", m.width}, {"height", m.height}}},
      {"fps", m.fps},
      {"checked", m.checked},
      {"fidelity", fidelity_name(m.simulation.fidelity)},
      {"random_stall", m.simulation.random_stall},
      {"shuffle", m.simulation.shuffle_ticks},
      {"seed", m.simulation.seed},
      // A run with an injected fault is not one of the unit, and must not pass for it.
      {"falsified", m.simulation.fault.datapath != hw::Datapath::none},
  };
  if (m.simulation.fidelity == Fidelity::sampled) {
    json["simulated_frames"] = m.simulated_frames;
    json["different_frames"] = m.different_frames;
  }
  // A file name need not be UTF-8; JSON must be.
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

nlohmann::ordered_json scene_json(const Manifest& m) {
  return {{"file", m.input},
          {"sha256", m.input_sha256},
          {"kind", m.input_is_trace ? "trace" : "scene"},
          {"first_frame", m.first_frame},
          {"last_frame", m.last_frame},
          {"width", m.width},
          {"height", m.height},
          {"fps", m.fps}};
}

}  // namespace artu::sim
