#include "sim/command/line/lines.h"
#include "sim/command/line/shared.h"

namespace artu::sim {
namespace {

void declare(CLI::App& command, RunOptions& run) {
  add_source(command, run.source, "640x360", false, false);
  add_configuration(command, run);
  add_jobs(command, run.jobs);
  command.add_flag("--dump-config", run.dump_config, "Print the resolved configuration as TOML and end")
      ->group("Configuration");
  command.add_flag("--list-params", run.list_params, "Print all parameters with default, unit and range, and end")
      ->group("Configuration");

  command.add_option("-o,--output", run.output, "Folder of the report")->option_text("DIR")->group("Output");
  add_pictures(command, "frame,decision,class", [&run](const PictureSet& pictures) { run.pictures = pictures; });
  command
      .add_flag("--timeline", run.simulation.timeline,
                "Record what happens when, and how many nodes rays visit, in timeline.json (docs/report.md)")
      ->group("Output");
  command.add_option("--dump-pixels", run.pixel_csv, "Write one row a pixel and frame (docs/selective-rendering.md)")
      ->option_text("FILE.csv")
      ->group("Output");
  auto* trace = command.add_option("--memory-trace", run.memory_trace,
                                   "Write every request that reaches the DRAM (docs/memory_trace.md)");
  trace->option_text("FILE")->group("Output");
  command
      .add_option_function<std::string>(
          "--memory-trace-format",
          [&run](const std::string& name) { run.memory_trace_format = parse_memory_trace_format(name); },
          "Whose format: dramsim3 (default), ramulator, ramulator2")
      ->option_text("NAME")
      ->needs(trace)
      ->group("Output");
  auto* viewers = command.add_option_function<std::vector<std::string>>(
      "--trace",
      [&run](const std::vector<std::string>& requests) {
        for (const std::string& request : requests) run.trace.requests.push_back(parse_trace(request));
      },
      "Write what every block does in a frame, for a viewer: perfetto, konata or vcd; without FILE into the run's "
      "folder; may be repeated (docs/viewers.md)");
  viewers->option_text("KIND[=FILE]")->allow_extra_args(false)->group("Output");
  command
      .add_option_function<std::string>(
          "--trace-from",
          [&run](const std::string& cycle) { run.trace.window.from = parse_cycle("--trace-from", cycle); },
          "The first cycle of the trace; default 0")
      ->option_text("CYCLE")
      ->needs(viewers)
      ->group("Output");
  command
      .add_option_function<std::string>(
          "--trace-to", [&run](const std::string& cycle) { run.trace.window.to = parse_cycle("--trace-to", cycle); },
          "The cycle before which it ends; default: the end of the frame")
      ->option_text("CYCLE")
      ->needs(viewers)
      ->group("Output");
  command.add_flag("--force", run.force, "Replace an earlier run's folder, or an existing FILE")->group("Output");
  command.add_flag("--quiet", run.quiet, "No summary, no notes, no progress bar")->group("Output");
  command.add_flag("--list-stats", run.list_stats, "Print the names of all reported numbers, and end")->group("Output");
  command.add_flag("--dry-run", run.dry_run, "Check all input, write nothing and end")->group("Output");

  command
      .add_option_function<std::string>(
          "--fidelity", [&run](const std::string& mode) { run.simulation.fidelity = parse_fidelity(mode); },
          "functional: pixels and counts, no cycles; analytic: the same, cycles estimated; sampled: event for some of "
          "the frames, the figures of all estimated; event (default): only blocks that are awake; clocked: every block "
          "in every cycle, same result")
      ->option_text("MODE")
      ->group("Simulation");
  add_sample_size(command, run.sample, [&run](const char* option) { run.sample_given = option; });
  command
      .add_flag("--random-stall", run.simulation.random_stall,
                "Random extra latency on every channel: changes "
                "cycles, never a pixel")
      ->group("Simulation");
  command.add_flag("--shuffle", run.simulation.shuffle_ticks, "Random order of blocks within a cycle: changes nothing")
      ->group("Simulation");
  command
      .add_option_function<std::string>(
          "--seed",
          [&run](const std::string& seed) {
            run.simulation.seed = parse_seed(seed);
            run.seed_given = true;
          },
          "Of the two above, and of the frames that sampled draws; default 1")
      ->option_text("N")
      ->group("Simulation");
  command
      .add_option_function<std::vector<std::string>>(
          "--log",
          [&run](const std::vector<std::string>& rules) {
            for (const std::string& rule : rules) run.simulation.log.push_back(parse_log_rule(rule));
          },
          "What a block does, on stderr: off, info (phases of the frame), debug (every change of its state); "
          "BLOCK is a path, or its beginning, or *; may be repeated")
      ->option_text("BLOCK=LEVEL")
      ->allow_extra_args(false)
      ->group("Simulation");
  command
      .add_option_function<std::string>(
          "--inject-fault", [&run](const std::string& fault) { run.simulation.fault = parse_fault(fault); },
          "Invert a bit of every result of a datapath (box, triangle, shading, interpolation, threshold), or "
          "lose an answer of the dram, to see that it is found")
      ->option_text("DATAPATH[:BIT]")
      ->group("Simulation");
}

}  // namespace

void add_run(CommandLine& line) {
  const auto options = std::make_shared<RunOptions>();
  options->command = line.words;
  CLI::App& command = add_command(line, "run", "Simulate frames and write a report", options, run_command);
  declare(command, *options);
  command.add_flag("--check", options->check, "Compare every pixel with the golden model; exit code 1 on a mismatch")
      ->group("Output");
  add_examples(command,
               {{"artu run scripts/scenes/default.stage.toml", "one frame of the sample stage into runs/default-1"},
                {"artu run scene.glb --frames 0:30 --size 320x180 --jobs 2", "30 frames of a glTF animation"},
                {"artu run scene.glb -c phone.toml --set core.count=4", "another unit"},
                {"artu run scene.glb --fidelity analytic", "an estimate of the cycles, to screen with"},
                {"artu run scene.glb --pictures all -o report", "with every picture, into report"},
                {"artu run --list-params", "what can be configured"},
                {"artu run --dump-config --set memory.dram.preset=lpddr5-6400", "a configuration as a file"}});
}

void add_check(CommandLine& line) {
  const auto options = std::make_shared<RunOptions>();
  options->command = line.words;
  options->check = true;
  options->folder_by_default = false;
  CLI::App& command =
      add_command(line, "check", "Simulate frames and compare every pixel with the golden model", options, run_command);
  declare(command, *options);
  add_examples(command, {{"artu check scene.glb --frames 12", "frame 12 against the golden model"},
                         {"artu check scene.glb --frames all --jobs 2 -o report", "every frame, with a report"},
                         {"artu check scene.glb --inject-fault box:3", "a fault that must be found: exit code 1"}});
}

}  // namespace artu::sim
