#include "sim/command/line/lines.h"
#include "sim/command/line/shared.h"

namespace artu::sim {
namespace {

void declare(CLI::App& command, BenchOptions& bench) {
  command
      .add_option(
          "SCENE|TRACE|FOLDER", bench.scenes,
          "Scenes, traces, or folders of them; default the sample stage, glmark2's bunny and the adversarial scene")
      ->option_text(" ");
  command.add_option("--frame", bench.frame, "Of every scene; default its first")->option_text("N")->group("Input");
  command.add_option("--size", bench.size, fmt::format("Picture of a scene; default {}", bench.size))
      ->option_text("WxH")
      ->group("Input");
  add_configuration(command, bench);
  command
      .add_option("--fidelity", bench.fidelity,
                  "Modes, between commas: golden (the golden model), functional, analytic, event, clocked; default all")
      ->option_text("LIST")
      ->group("Measurement");
  command.add_option("--repeats", bench.repeats, fmt::format("Rounds that are timed; default {}", bench.repeats))
      ->option_text("N")
      ->check(CLI::Range(1u, 1000u))
      ->group("Measurement");
  command
      .add_option_function<std::string>(
          "--seed", [&bench](const std::string& seed) { bench.seed = parse_seed(seed); },
          "Of the order in which modes take turns; default 1")
      ->option_text("N")
      ->group("Measurement");
  command
      .add_flag_callback(
          "--no-growth", [&bench] { bench.growth = false; },
          "Leave out how time and memory grow with pixels, triangles and cores")
      ->group("Measurement");
  add_report(command, bench, "No tables, no notes, no progress bar");
}

}  // namespace

void add_bench(CommandLine& line) {
  const auto options = std::make_shared<BenchOptions>();
  options->command = line.words;
  CLI::App& command = add_command(line, "bench", "How fast every mode of simulation is, and how far off its cycles are",
                                  options, bench_command);
  declare(command, *options);
  add_examples(command, {{"artu bench", "the samples, all modes, and how time and memory grow"},
                         {"artu bench scenes/ --fidelity event,analytic --no-growth", "every scene of a folder"}});
}

}  // namespace artu::sim
