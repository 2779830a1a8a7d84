#include "sim/command/output_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "traces/error.h"

namespace artu::sim {
namespace fs = std::filesystem;
namespace {

fs::path place_of(const std::string& name) {
  std::error_code error;
  const fs::path place = fs::weakly_canonical(fs::absolute(name, error), error);
  return error ? fs::path(name) : place;
}

/// The folder itself as well.
bool is_within(const fs::path& place, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), place.begin(), place.end()).first == folder.end();
}

struct Written {
  const char* option;
  std::string file;
};

}  // namespace

bool is_same_place(const std::string& a, const std::string& b) { return place_of(a) == place_of(b); }

void refuse_input_as_output(const std::string& output, const std::string& input) {
  if (is_same_place(output, input)) throw InputError(output, "is the input; another name would be right");
}

void refuse_within(const std::string& output, const std::string& folder, const std::string& right) {
  if (!is_within(place_of(output), place_of(folder))) return;
  throw InputError(output,
                   fmt::format("is in {}, a run's own folder; {}, or another place, would be right", folder, right));
}

void check_output_places(const RunOptions& options) {
  std::vector<Written> files;
  if (!options.pixel_csv.empty()) files.push_back({"--dump-pixels", options.pixel_csv});
  if (!options.memory_trace.empty()) files.push_back({"--memory-trace", options.memory_trace});
  for (const TraceRequest& request : options.trace.requests) {
    if (!request.file.empty()) files.push_back({"--trace", request.file});
  }
  for (auto file = files.begin(); file != files.end(); ++file) {
    refuse_input_as_output(file->file, options.source.path);
    for (const std::string& config : options.config_files) refuse_input_as_output(file->file, config);
    const auto same =
        std::find_if(files.begin(), file, [&](const Written& w) { return is_same_place(w.file, file->file); });
    if (same != file) {
      throw InputError(file->option, fmt::format("{} is the file of {} as well; another name would be right",
                                                 file->file, same->option));
    }
    if (!options.output.empty() && is_within(place_of(file->file), place_of(options.output))) {
      throw InputError(
          file->option,
          fmt::format("{} is in the folder of -o, which is made anew; another place would be right", file->file));
    }
  }
}

}  // namespace artu::sim
