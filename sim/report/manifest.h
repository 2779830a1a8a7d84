// manifest.json: what was run, so that it can be run again.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "sim/driver/frame_simulator.h"

namespace artu::sim {

struct Manifest {
  std::vector<std::string> command;  // the words of the command line
  std::string version;
  std::string input, input_sha256;
  bool input_is_trace = false;
  std::uint32_t first_frame = 0, last_frame = 0;  // half-open
  std::uint32_t width = 0, height = 0;
  double fps = 0;  // of the animation
  bool checked = false;
  SimulationOptions simulation;
  std::vector<std::uint32_t> simulated_frames;  // with `sampled`
  std::uint32_t different_frames = 0;           // the same: of all, equal ones once
};

std::string to_json(const Manifest& manifest);

/// What was rendered: file, checksum, kind, frames, size, rate.
nlohmann::ordered_json scene_json(const Manifest& manifest);

}  // namespace artu::sim
