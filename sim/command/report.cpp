#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "sim/command/commands.h"
#include "sim/command/output_places.h"
#include "sim/html/page.h"
#include "sim/html/report_data.h"
#include "sim/report/file.h"
#include "traces/error.h"

namespace artu::sim {
namespace fs = std::filesystem;

int report_command(const ReportOptions& options) {
  std::set<std::string> seen;
  for (const std::string& folder : options.folders) {
    std::error_code error;
    if (!fs::is_directory(folder, error)) {
      throw InputError(folder, "is no folder; one that artu run or artu sweep made would be right");
    }
    if (!seen.insert(fs::canonical(folder, error).string()).second) {
      throw InputError(folder, "is named twice; once would be right");
    }
  }
  const std::string file =
      options.output.empty() ? (fs::path(options.folders.front()) / "report.html").string() : options.output;
  if (fs::path(file).extension() != ".html") {
    for (const std::string& folder : options.folders) refuse_within(file, folder, "a page (.html) there");
  }
  AtomicFile page(file, options.force);  // refuses what exists, before anything slow begins
  std::vector<std::string> notes;
  const auto data = report_data(options.folders, std::uint64_t{options.picture_megabytes} << 20, notes);
  const std::string text = html_page(report_title(data), data);
  page.write(text);
  page.close();
  print_notes(notes, options.quiet);
  if (!options.quiet) fmt::print("{:<12}{}, {:.1f} MB\n", "report", file, static_cast<double>(text.size()) / 1e6);
  return exit_fine;
}

}  // namespace artu::sim
