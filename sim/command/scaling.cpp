#include <fmt/format.h>

#include <algorithm>

#include "sim/command/commands.h"
#include "sim/command/frame_source.h"
#include "sim/command/progress.h"
#include "sim/command/run_report.h"
#include "sim/command/unit_totals.h"
#include "sim/config/configuration.h"
#include "sim/config/dump.h"
#include "sim/config/parameter_list.h"
#include "sim/report/file.h"
#include "sim/report/gnuplot.h"
#include "sim/report/run_folder.h"
#include "sim/scaling/scaling.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

/// The value that a unit has, however it was written: "64KiB" and 65536 are one.
std::string value_of(const std::string& parameter, const hw::UnitConfig& unit) {
  const std::vector<std::string> values = parameter_values(unit);
  const std::vector<ParameterInfo> all = parameter_list();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].path == parameter) return values[i];
  }
  return "";  // never: the configuration knows it
}

std::vector<hw::UnitConfig> units_of(const ScalingOptions& options, const Variation& variation) {
  std::vector<hw::UnitConfig> units;
  std::vector<std::string> values;
  for (const std::string& value : variation.values) {
    Configuration configuration;
    for (const std::string& file : options.config_files) configuration.load(file);
    for (const std::string& assignment : options.assignments) configuration.set(assignment);
    configuration.set(variation.parameter + "=" + value, "--vary");
    configuration.check();
    units.push_back(configuration.unit());
    values.push_back(value_of(variation.parameter, units.back()));
    if (std::count(values.begin(), values.end(), values.back()) > 1) {
      throw InputError(
          "--vary", fmt::format("{} has the value {} twice; once would be right", variation.parameter, values.back()));
    }
  }
  return units;
}

}  // namespace

int scaling_command(const ScalingOptions& options) {
  std::vector<std::string> log;
  require_file(options.source.path);
  const Variation variation = parse_variation(options.variation);
  if (options.fidelity != Fidelity::analytic && !is_exact(options.fidelity)) {
    throw InputError("--fidelity", fmt::format("{} does not have what every resource is asked for; analytic, event or "
                                               "clocked would be right",
                                               fidelity_name(options.fidelity)));
  }
  const std::vector<hw::UnitConfig> units = units_of(options, variation);
  RunFolder folder =
      options.output.empty() ? RunFolder::next_free(options.source.path) : RunFolder(options.output, options.force);
  const FrameSource source(options.source, log);
  const std::uint32_t frames = source.range().count();

  std::vector<ScalingRow> rows;
  {
    Progress progress(std::uint64_t{frames} * units.size(), "frames", options.quiet);
    const std::vector<Totals> sums = totals_by_unit(source, units, options.fidelity, options.jobs, progress);
    for (std::size_t i = 0; i < units.size(); ++i) {
      rows.push_back(scaling_row(variation.values[i], sums[i], units[i], microseconds(sums[0], units[0])));
    }
  }
  std::string title = heading(options.source.path, source);
  if (!is_exact(options.fidelity)) title += fmt::format(", cycles estimated ({})", fidelity_name(options.fidelity));
  Manifest manifest = manifest_of(options.command, options.source.path, source);
  manifest.simulation.fidelity = options.fidelity;
  write_file(folder.file("scaling.csv"), scaling_csv(variation, rows));
  write_file(folder.file("config.toml"), dump_config(units[0]));
  write_file(folder.file("manifest.json"), to_json(manifest));
  const std::string no_plot =
      draw_plot(folder.partial(), {scaling_plot, scaling_data(rows), scaling_script(variation, rows, title)});
  folder.commit();

  if (!no_plot.empty()) log.push_back("no plot: " + no_plot);
  print_notes(log, options.quiet);
  if (!options.quiet) {
    fmt::print("{}\n\n{}\n{:<12}{}\n", title, format_scaling(variation, rows, frames), "report", folder.name());
  }
  return exit_fine;
}

}  // namespace artu::sim
