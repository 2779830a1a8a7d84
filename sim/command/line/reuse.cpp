#include "sim/command/line/lines.h"
#include "sim/command/line/shared.h"

namespace artu::sim {
namespace {

void declare(CLI::App& command, ReuseOptions& reuse) {
  add_source(command, reuse.source, "640x360", false, true);
  add_configuration(command, reuse);
  add_jobs(command, reuse.jobs);
  command.add_option("--window", reuse.window, "Cycles in which lines count for a working set; default 10000")
      ->option_text("CYCLES")
      ->check(CLI::Range(std::uint64_t{100}, std::uint64_t{1000000000}))
      ->group("Output");
  add_report(command, reuse, "No table, no notes, no progress bar");
}

}  // namespace

void add_reuse(CommandLine& line) {
  const auto options = std::make_shared<ReuseOptions>();
  options->command = line.words;
  CLI::App& command =
      add_command(line, "reuse", "What caches of all sizes would miss, from one run", options, reuse_command);
  declare(command, *options);
  add_examples(command, {{"artu reuse scene.glb", "misses of every cache by its size, and working sets"},
                         {"artu reuse scene.glb --frames 0:24 --jobs 2", "of a sequence, two frames at a time"},
                         {"artu reuse scene.glb --window 100000", "working sets of longer times"}});
}

}  // namespace artu::sim
