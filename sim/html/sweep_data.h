// The folder of a sweep as the report's script takes it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace artu::sim {

/// Whether `artu sweep` made this folder.
bool is_sweep_folder(const std::string& folder);

/// {"name", "folder", "description": sweep.json, "columns", "rows"}: of points.csv, numbers as such, empty cells null.
/// Throws InputError where a file of it is broken.
nlohmann::ordered_json sweep_data(const std::string& folder);

}  // namespace artu::sim
