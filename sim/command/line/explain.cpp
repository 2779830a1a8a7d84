#include "sim/command/line/lines.h"
#include "sim/command/line/shared.h"

namespace artu::sim {
namespace {

void declare(CLI::App& command, ExplainOptions& explain) {
  command
      .add_option("DIR|SCENE|TRACE", explain.source.path,
                  "A folder of `artu run`; or a scene or a trace, which is simulated first")
      ->option_text(" ")
      ->required();
  add_frames(command, explain.source, "640x360");
  add_configuration(command, explain);
  add_jobs(command, explain.jobs);
  command
      .add_flag("--verify", explain.verify,
                "Simulate the frames again with each parameter turned as advised: what it gains really")
      ->group("Simulation");
  command.add_flag("--json", explain.json, "Print JSON, with all numbers (docs/explain.md)")->group("Output");
  command.add_flag("--quiet", explain.quiet, "No notes, no progress bar")->group("Output");
}

}  // namespace

void add_explain(CommandLine& line) {
  const auto options = std::make_shared<ExplainOptions>();
  CLI::App& command =
      add_command(line, "explain", "What binds a run, and which parameter to turn next", options, explain_command);
  declare(command, *options);
  add_examples(command, {{"artu explain runs/default-1", "of a run"},
                         {"artu explain runs/default-1 --verify", "and what the advice gains really"},
                         {"artu explain scene.glb --set core.count=4", "of a scene, which is simulated first"}});
}

}  // namespace artu::sim
