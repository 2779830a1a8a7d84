#include "sim/html/report_data.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/html/run_data.h"
#include "sim/html/sweep_data.h"
#include "traces/error.h"

namespace artu::sim {

nlohmann::ordered_json report_data(const std::vector<std::string>& folders, std::uint64_t picture_bytes,
                                   std::vector<std::string>& notes) {
  for (const std::string& folder : folders) {
    if (!is_sweep_folder(folder)) continue;
    if (folders.size() > 1)
      throw InputError(folder, "is a sweep, which has a page of its own; it alone would be right");
    return {{"version", ARTU_VERSION}, {"kind", "sweep"}, {"sweep", sweep_data(folder)}};
  }
  nlohmann::ordered_json data = {{"version", ARTU_VERSION},
                                 {"kind", folders.size() == 1   ? "run"
                                          : folders.size() == 2 ? "comparison"
                                                                : "table"},
                                 {"runs", nlohmann::ordered_json::array()}};
  for (const std::string& folder : folders) {
    nlohmann::ordered_json run = run_data(folder);
    if (const std::size_t left_out = add_pictures(run, folder, picture_bytes / folders.size())) {
      notes.push_back(
          fmt::format("{}: the pictures of {} frames are left out; --picture-megabytes has more", folder, left_out));
    }
    data["runs"].push_back(std::move(run));
  }
  return data;
}

std::string report_title(const nlohmann::ordered_json& data) {
  if (data["kind"] == "sweep") return fmt::format("{} - ARTU", data["sweep"]["name"].get<std::string>());
  const nlohmann::ordered_json& runs = data["runs"];
  if (runs.size() > 2) return fmt::format("{} runs - ARTU", runs.size());
  const auto name = [](const nlohmann::ordered_json& run) { return run["name"].get<std::string>(); };
  if (runs.size() == 2) return fmt::format("{} and {} - ARTU", name(runs[0]), name(runs[1]));
  return fmt::format("{} - ARTU", runs[0]["manifest"]["input"]["file"].get<std::string>());
}

}  // namespace artu::sim
