#include "sim/command/line/lines.h"
#include "sim/command/line/shared.h"

namespace artu::sim {
namespace {

void declare(CLI::App& command, ScalingOptions& scaling) {
  add_source(command, scaling.source, "640x360", false, true);
  add_configuration(command, scaling);
  add_jobs(command, scaling.jobs);
  command
      .add_option_function<std::string>(
          "--fidelity", [&scaling](const std::string& mode) { scaling.fidelity = parse_fidelity(mode); },
          "event (default), clocked, or analytic: estimates, much faster")
      ->option_text("MODE")
      ->group("Scaling");
  command
      .add_option("--vary", scaling.variation,
                  "Parameter and its values, the first of which the others are held against; default "
                  "core.count=1,2,4,8,16")
      ->option_text("PARAMETER=VALUE,...")
      ->group("Scaling");
  add_report(command, scaling, "No table, no notes, no progress bar");
}

}  // namespace

void add_scaling(CommandLine& line) {
  const auto options = std::make_shared<ScalingOptions>();
  options->command = line.words;
  options->variation = "core.count=1,2,4,8,16";
  CLI::App& command =
      add_command(line, "scaling", "What one parameter gains, and what limits it", options, scaling_command);
  declare(command, *options);
  add_examples(command,
               {{"artu scaling scene.glb", "1, 2, 4, 8 and 16 cores"},
                {"artu scaling scene.glb --vary memory.l2.size=64KiB,256KiB,1MiB", "any other parameter"},
                {"artu scaling scene.glb --vary core.contexts=8,16,32,64 --fidelity analytic", "estimates, fast"}});
}

}  // namespace artu::sim
