#include <fmt/format.h>

#include <memory>

#include "sim/command/commands.h"
#include "sim/command/progress.h"
#include "sim/report/file.h"
#include "sim/stress/report.h"

namespace artu::sim {

int stress_command(const StressCommandOptions& options) {
  if (options.list) {
    fmt::print("{}", format_case_list());
    return exit_fine;
  }
  const std::uint64_t cases = stress_cases(options.stress.only, options.stress.leaks_only).size();
  std::unique_ptr<AtomicFile> json;  // refuses what exists before anything slow begins
  if (!options.json.empty()) json = std::make_unique<AtomicFile>(options.json, options.force);
  StressReports reports;
  {
    Progress progress(cases * options.formats.size(), "cases", options.quiet);
    for (const hw::PrecisionConfig& format : options.formats) {
      StressOptions one = options.stress;
      one.precision = format;
      reports.push_back(run_stress(one, [&] { progress.one_done(); }));
    }
  }
  const StressTotals totals = totals_of(reports);
  if (json) {
    json->write(format_json(reports));
    json->close();
  }
  if (!options.quiet) {
    fmt::print("{}", format_table(reports));
  } else if (totals.first != nullptr) {
    fmt::print("{}", format_failure(*totals.first));
  }
  return totals.passed() ? exit_fine : exit_mismatch;
}

}  // namespace artu::sim
