// The folder of a run as the report's script takes it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace artu::sim {

/// Whether `artu run` or `artu check` made this folder.
bool is_run_folder(const std::string& folder);

/// "runs/a/" -> "a"
std::string folder_name(const std::string& folder);

/// manifest.json, stats.json, what each number means (stats.txt), the configuration beside the defaults, and without
/// `pictures` nothing more.  Throws InputError where the folder is no run's or a file of it is broken.
nlohmann::ordered_json run_data(const std::string& folder);

/// Adds the run's pictures as base64, of no more than `bytes` in PNG files: where there are more, of every second
/// frame, every third and so on, so that those that are left are spread evenly.  Returns how many frames are left out.
std::size_t add_pictures(nlohmann::ordered_json& run, const std::string& folder, std::uint64_t bytes);

}  // namespace artu::sim
