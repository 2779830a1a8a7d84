#include <fmt/format.h>

#include <array>
#include <optional>

#include "sim/command/commands.h"
#include "sim/command/progress.h"
#include "sim/config/configuration.h"
#include "sim/config/dump.h"
#include "sim/jobs/processes.h"
#include "sim/report/file.h"
#include "sim/report/run_folder.h"
#include "sim/torture/torture.h"
#include "traces/trace.h"

namespace artu::sim {

template <class A>
void transfer(A& archive, TortureResult& result) {
  pass_all(archive, result.verdict, result.text, result.pixels, result.cycles);
}

namespace {

struct Verdicts {
  std::array<std::uint64_t, verdict_count> counts{};
  std::uint64_t pixels = 0, cycles = 0;
  std::string refusal;  // the first
  std::uint64_t first_failure = 0;
  TortureResult failure;

  void add(std::uint64_t seed, const TortureResult& result) {
    ++counts[static_cast<std::size_t>(result.verdict)];
    pixels += result.pixels;
    cycles += result.cycles;
    if (result.verdict == Verdict::refused && refusal.empty()) refusal = result.text;
    if (!is_failure(result.verdict) || is_failure(failure.verdict)) return;
    first_failure = seed;
    failure = result;
  }
};

void print_table(const Verdicts& verdicts) {
  for (std::size_t i = 0; i < verdict_count; ++i) {
    fmt::print("{:<12}{:>12}\n", verdict_name(static_cast<Verdict>(i)), verdicts.counts[i]);
  }
  fmt::print("{:<12}{:>12}\n{:<12}{:>12}\n", "pixels", verdicts.pixels, "cycles", verdicts.cycles);
  if (!verdicts.refusal.empty()) fmt::print("first refused: {}\n", verdicts.refusal);
}

/// What `artu check` needs to see the failure.
void write_case(const TortureCase& failing, const std::string& folder) {
  write_file(folder + "/unit.toml", dump_config(Configuration::of({}, failing.assignments).unit()));
  const DrawnScene drawn = make_scene(failing.scene);
  traces::Writer writer(folder + "/scene.artu", drawn.scene);
  for (const traces::Frame& frame : drawn.frames) writer.add(frame);
  writer.close();
}

TortureCase case_of(const TortureOptions& options, std::uint64_t seed) {
  TortureCase drawn = draw_case(seed);
  drawn.simulation.fault = options.fault;
  return drawn;
}

void print_case(const TortureCase& drawn) {
  for (const std::string& assignment : drawn.assignments) fmt::print("  --set '{}'\n", assignment);
}

void print_failure(const Verdicts& verdicts, const TortureOptions& options, std::optional<RunFolder>& folder) {
  const TortureCase failing = shrink(case_of(options, verdicts.first_failure), verdicts.failure.verdict);
  const TortureResult result = run_case(failing);
  fmt::print("seed {}: {}: {}\nsmallest case: {}\n", failing.seed, verdict_name(result.verdict), result.text,
             describe(failing.scene));
  print_case(failing);
  if (!folder) return;
  write_case(failing, folder->partial());
  folder->commit();
  const bool stalled = failing.simulation.random_stall, shuffled = failing.simulation.shuffle_ticks;
  fmt::print("to see it: artu check {0}/scene.artu -c {0}/unit.toml --frames all{1}{2}{3}\n", folder->name(),
             stalled ? " --random-stall" : "", shuffled ? " --shuffle" : "",
             stalled || shuffled ? fmt::format(" --seed {}", failing.simulation.seed) : "");
}

}  // namespace

int torture_command(const TortureOptions& options) {
  if (options.dry_run) {
    for (std::uint64_t seed = options.seed; seed < options.seed + options.cases; ++seed) {
      const TortureCase drawn = case_of(options, seed);
      fmt::print("seed {}: {}\n", seed, describe(drawn.scene));
      print_case(drawn);
    }
    return exit_fine;
  }
  std::optional<RunFolder> folder;  // refuses what exists before anything slow begins
  if (!options.output.empty()) folder.emplace(options.output, false);
  Verdicts verdicts;
  {
    Progress progress(options.cases, "cases", options.quiet);
    in_order<TortureResult>(
        options.cases, options.jobs,
        [&](std::uint64_t task) { return run_case(case_of(options, options.seed + task)); },
        [&](std::uint64_t task, const TortureResult& result) {
          verdicts.add(options.seed + task, result);
          progress.one_done();
        });
  }
  if (!options.quiet) print_table(verdicts);
  if (!is_failure(verdicts.failure.verdict)) return exit_fine;
  print_failure(verdicts, options, folder);
  return exit_mismatch;
}

}  // namespace artu::sim
