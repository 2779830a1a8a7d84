// What the report of some folders draws.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace artu::sim {

/// Everything the page needs: {"version", "kind": "run", "comparison" of two or "table" of more, "runs": [...]},
/// or of a sweep {"version", "kind": "sweep", "sweep"}.
/// `picture_bytes`: of PNG files at most, shared out to the runs; a line of `notes` for each run of which
/// that leaves frames out.
nlohmann::ordered_json report_data(const std::vector<std::string>& folders, std::uint64_t picture_bytes,
                                   std::vector<std::string>& notes);

/// Of the page: the scene, or what is compared.
std::string report_title(const nlohmann::ordered_json& data);

}  // namespace artu::sim
