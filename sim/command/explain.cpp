#include "sim/explain/explain.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "sim/command/commands.h"
#include "sim/command/frame_source.h"
#include "sim/command/progress.h"
#include "sim/command/unit_totals.h"
#include "sim/config/configuration.h"
#include "sim/explain/stored_run.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

/// Simulates the frames once more with each advice, one at a time.
void measure(Explanation& explanation, const FrameSource& source, const ExplainOptions& options) {
  std::vector<hw::UnitConfig> units;
  for (const Advice& advice : explanation.advice) units.push_back(advice.unit);
  Progress progress(std::uint64_t{source.range().count()} * units.size(), "frames", options.quiet);
  for (const Totals& totals : totals_by_unit(source, units, Fidelity::event, options.jobs, progress)) {
    explanation.measured.push_back(totals.cycles);
  }
}

/// The same frames of the same input as the folder's.
SourceOptions source_of(const StoredRun& run, const std::string& folder) {
  const Manifest& m = run.manifest;
  if (m.simulation.random_stall || run.falsified) {
    throw InputError("--verify", fmt::format("{} was run with {}, which changes cycles; a run without would be right",
                                             folder, run.falsified ? "an injected fault" : "--random-stall"));
  }
  require_file(m.input);
  if (sha256_of_input(m.input) != m.input_sha256) {
    throw InputError(m.input, fmt::format("is not what {} was run on; the same file would be right", folder));
  }
  SourceOptions source;
  source.path = m.input;
  source.frames = fmt::format("{}:{}", m.first_frame, m.last_frame);
  if (m.input_is_trace) return source;
  source.size = fmt::format("{}x{}", m.width, m.height);
  source.fps = m.fps;
  return source;
}

Explanation of_folder(const ExplainOptions& options, std::vector<std::string>& log) {
  const SourceOptions& source = options.source;
  const bool more =
      source.frames || source.size || source.fps || !options.config_files.empty() || !options.assignments.empty();
  if (more) {
    throw InputError(source.path,
                     "is a run's folder, which has its own frames, size and configuration; a scene, or no "
                     "such options, would be right");
  }
  const StoredRun run = read_run(source.path);
  require_exact(run.totals.fidelity, source.path);
  Explanation explanation;
  try {
    explanation = explain(run.totals, run.unit);
  } catch (const std::logic_error& error) {
    throw InputError(source.path + "/stats.json",
                     fmt::format("{}; one that this version has written would be right", error.what()));
  }
  if (options.verify) measure(explanation, FrameSource(source_of(run, source.path), log), options);
  return explanation;
}

Explanation of_scene(const ExplainOptions& options, std::vector<std::string>& log) {
  require_file(options.source.path);
  const hw::UnitConfig unit = Configuration::of(options.config_files, options.assignments).unit();
  const FrameSource source(options.source, log);
  Totals totals;
  {
    Progress progress(source.range().count(), "frames", options.quiet);
    totals = totals_by_unit(source, {unit}, Fidelity::event, options.jobs, progress)[0];
  }
  Explanation explanation = explain(totals, unit);
  if (options.verify) measure(explanation, source, options);
  return explanation;
}

}  // namespace

int explain_command(const ExplainOptions& options) {
  std::vector<std::string> log;
  const bool folder = std::filesystem::is_directory(options.source.path);
  const Explanation explanation = folder ? of_folder(options, log) : of_scene(options, log);
  print_notes(log, options.quiet);
  fmt::print("{}", options.json ? explanation_json(explanation) : format_explanation(explanation));
  return exit_fine;
}

}  // namespace artu::sim
