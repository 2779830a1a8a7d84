// What a point's folder says of it, as columns of the sweep's table.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "sim/driver/fidelity.h"

namespace artu::sim {

/// A value as --dump-config writes it.
nlohmann::ordered_json json_of_toml(const std::string& value);

using Figures = std::vector<std::pair<std::string, nlohmann::ordered_json>>;  // column and number, or text

/// From stats.json: every total and derived figure under its own name, `energy.` and `demand.` before theirs, the
/// `bottleneck`; of an estimate its interval as NAME.low and NAME.high.
Figures figures_of(const nlohmann::ordered_json& stats);

/// The columns of numbers that a run with this fidelity has, without intervals.
std::vector<std::string> figure_names(Fidelity fidelity);

}  // namespace artu::sim
