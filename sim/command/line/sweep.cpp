#include "sim/command/line/lines.h"
#include "sim/command/line/shared.h"
#include "sim/jobs/processes.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

bool is_slurm(const std::string& name) {
  if (name == "slurm" || name == "local") return name == "slurm";
  throw InputError("--backend", fmt::format("\"{}\" is none; local or slurm would be right", name));
}

void declare(CLI::App& command, SweepOptions& sweep) {
  command.add_option("GRID", sweep.grid, "What is varied, on which scenes: TOML (docs/sweep.md)")
      ->option_text(" ")
      ->required();
  command.add_option("-o,--output", sweep.output, "Folder of the sweep")->option_text("DIR")->group("Output");
  command.add_flag("--resume", sweep.resume, "Go on where the sweep in DIR was; begin it if there is none")
      ->group("Output");
  command.add_flag("--force", sweep.force, "Replace the sweep in DIR")->group("Output");
  command
      .add_flag("--collect", sweep.collect,
                "Only write the table, of what is finished; may be done while others simulate")
      ->group("Output");
  command.add_flag("--dry-run", sweep.dry_run, "Check the grid, print what it varies, and end")->group("Output");
  command.add_flag("--quiet", sweep.quiet, "No summary, no notes, no progress bar")->group("Output");
  command
      .add_option(
          "--jobs", sweep.jobs,
          "Points that are simulated at the same time; changes no result; default 1, with slurm as many as there "
          "is room for")
      ->option_text("N")
      ->check(CLI::Range(1u, maximum_jobs))
      ->group("Simulation");
  command
      .add_option_function<std::string>(
          "--backend", [&sweep](const std::string& name) { sweep.slurm = is_slurm(name); },
          "local (default): processes on this machine; slurm: a job array (docs/sweep.md)")
      ->option_text("NAME")
      ->group("Simulation");
  command
      .add_option("--part", sweep.part,
                  "Only every T-th point from the K-th on (from 0), and no table: one of T processes "
                  "that share DIR, on any machines")
      ->option_text("K/T")
      ->group("Simulation");
}

}  // namespace

void add_sweep(CommandLine& line) {
  const auto options = std::make_shared<SweepOptions>();
  CLI::App& command = add_command(line, "sweep", "Any parameters on any scenes: a folder a point, and one table",
                                  options, sweep_command);
  declare(command, *options);
  add_examples(command, {{"artu sweep grid.toml --dry-run", "how many points, and what is varied"},
                         {"artu sweep grid.toml -o caches --jobs 2", "two points at a time"},
                         {"artu sweep grid.toml -o caches --jobs 2 --resume", "goes on after it was killed"}});
}

}  // namespace artu::sim
