#include "sim/command/line/lines.h"
#include "sim/command/line/shared.h"

namespace artu::sim {
namespace {

void declare(CLI::App& command, SamplingOptions& sampling) {
  add_source(command, sampling.source, "640x360", false, true);
  add_configuration(command, sampling);
  add_jobs(command, sampling.jobs);
  add_sample_size(command, sampling.sample, [](const char*) {});
  command.add_option("--trials", sampling.trials, "Samples that are drawn; default 200")
      ->option_text("N")
      ->check(CLI::Range(1u, 1000000u))
      ->group("Simulation");
  command
      .add_option_function<std::string>(
          "--seed", [&sampling](const std::string& seed) { sampling.seed = parse_seed(seed); },
          "Of the first trial; default 1")
      ->option_text("N")
      ->group("Simulation");
  command.add_flag("--quiet", sampling.quiet, "No notes, no progress bar")->group("Output");
}

}  // namespace

void add_sampling(CommandLine& line) {
  const auto options = std::make_shared<SamplingOptions>();
  CLI::App& command = add_command(line, "sampling", "How right `--fidelity sampled` is on a sequence of frames",
                                  options, sampling_command);
  declare(command, *options);
  add_examples(command, {{"artu sampling scene.glb --frames 0:60 --jobs 2", "200 samples of 60 frames"},
                         {"artu sampling scene.glb --frames 0:60 --sample-share 10%", "six frames each"}});
}

}  // namespace artu::sim
