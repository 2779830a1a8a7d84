// The points of a sweep, each with its configuration, its scene and the name of its folder.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/sweep/grid.h"

namespace artu::sim {

struct SweepPoint {
  std::uint32_t number = 0;
  std::string name;  // of its folder: 0007-1a2b3c4d, the number and what identifies scene, configuration and fidelity
  std::size_t scene = 0;            // of grid.scenes
  std::vector<std::string> values;  // by axis, as TOML
  hw::UnitConfig unit;
  Fidelity fidelity = Fidelity::event;
  std::string refusal;                    // why the unit cannot be configured so; "" = it can
  std::optional<std::uint32_t> confirms;  // the number of the point that was screened
};

struct SweepPoints {
  Grid grid;
  std::vector<std::string> scene_sha256;
  std::vector<SweepPoint> points;  // a design's point after the other; of each, scene after scene
  std::uint32_t repeated = 0;      // samples that fell on an earlier one and were left out
};

/// `searched`: the points of a search so far.  Throws InputError for combinations that the unit refuses, unless they
/// are to be skipped, and for objectives that no point will have.
SweepPoints plan_of(Grid grid, const std::vector<std::vector<std::string>>& searched = {});

/// The same points with the grid's own fidelity, numbered after all others.
std::vector<SweepPoint> confirmations(const SweepPoints& plan, const std::vector<std::uint32_t>& numbers);

/// What `artu run` is to do for a point; `command` repeats it.
RunOptions run_of(const Grid& grid, const SweepPoint& point);

/// sweep.json.
std::string to_json(const SweepPoints& plan);

}  // namespace artu::sim
