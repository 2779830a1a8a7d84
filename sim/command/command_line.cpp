#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>

#include "sim/command/commands.h"
#include "sim/command/ranges.h"
#include "sim/jobs/processes.h"
#include "sim/quality/policies.h"
#include "sim/report/interruption.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

constexpr const char* examples = R"(Examples:
  artu run scripts/scenes/default.stage.toml             one frame of the sample stage into runs/default-1
  artu run scene.glb --frames 0:30 --size 320x180        30 frames of a glTF animation
  artu run scene.glb -c phone.toml --set core.count=4    another unit
  artu check scene.glb --frames 12                       frame 12 against the golden model
  artu import scene.glb --frames all -o scene.artu       all frames as a trace, to run without the scene
  artu precision scene.glb --bits 8-12,23                what narrow datapaths cost and save
  artu scaling scene.glb --vary core.count=1,2,4,8       what more cores gain, and what limits them
  artu quality scene.glb --references 4,8,16,32          what selective rendering saves, and what the picture loses
  artu sampling scene.glb --frames 0:60                  how right sampled is
  artu bench                                             how fast every mode is, and how far off
  artu diff a.png b.png                                  how far two pictures are apart
  artu stress                                            rays that are hard to get right, against every kind of tree
  artu run --list-params                                 what can be configured

Exit codes: 0 fine, 1 mismatch with the golden model, 2 usage or input, 3 dead-lock, 4 internal.)";

void add_source(CLI::App& command, SourceOptions& source, const char* size, bool scene_only, bool required) {
  const char* what = scene_only ? "A scene: .glb, .gltf, .obj or .stage.toml"
                                : "A scene (.glb, .gltf, .obj, .stage.toml) or a trace of `artu import`";
  auto* path = command.add_option(scene_only ? "SCENE" : "SCENE|TRACE", source.path, what);
  path->option_text(" ");
  if (required) path->required();
  command
      .add_option("--frames", source.frames, "Frames A to B - 1, or only A, or all; default 0:1, of a trace its first")
      ->option_text("A:B")
      ->group("Input");
  command.add_option("--size", source.size, fmt::format("Picture of a scene, 1x1 ... 16384x16384; default {}", size))
      ->option_text("WxH")
      ->group("Input");
  command.add_option("--fps", source.fps, "Frames per second of a scene's animation; default 30")
      ->option_text("F")
      ->group("Input");
}

template <class Options>
void add_configuration(CLI::App& command, Options& options) {
  command.add_option("-c,--config", options.config_files, "Configuration, TOML; may be repeated, the last one wins")
      ->option_text("FILE")
      ->allow_extra_args(false)
      ->group("Configuration");
  command.add_option("--set", options.assignments, "Set one parameter, after all files; may be repeated")
      ->option_text("path=value")
      ->allow_extra_args(false)
      ->group("Configuration");
}

void add_jobs(CLI::App& command, std::uint32_t& jobs) {
  command.add_option("--jobs", jobs, "Processes that the frames are shared out to; changes no result; default 1")
      ->option_text("N")
      ->check(CLI::Range(1u, maximum_jobs))
      ->group("Simulation");
}

template <class Take>
void add_pictures(CLI::App& command, const char* by_default, Take take) {
  std::string names;
  for (const char* name : picture_names) names += std::string(name) + ", ";
  command
      .add_option_function<std::string>(
          "--pictures", [take](const std::string& list) { take(parse_pictures(list)); },
          fmt::format("Pictures of the report: {}all or none; default {}", names, by_default))
      ->option_text("LIST")
      ->group("Output");
}

/// `given` is told of the option that was.
void add_sample_size(CLI::App& command, SampleSize& size, const std::function<void(const char*)>& given) {
  const auto percent = [&size, given](const char* option, double SampleSize::*value) {
    return [&size, given, option, value](const std::string& text) {
      size.*value = parse_percent(option, text);
      given(option);
    };
  };
  auto* share =
      command.add_option_function<std::string>("--sample-share", percent("--sample-share", &SampleSize::share),
                                               "Of the frames that sampled simulates, at least");
  share->option_text("P%")->group("Simulation");
  command
      .add_option_function<std::string>(
          "--target-error", percent("--target-error", &SampleSize::target_error),
          "sampled simulates frames until half the 95 % interval of the cycles is no more; "
          "default 1%")
      ->option_text("P%")
      ->excludes(share)
      ->group("Simulation");
}

void add_run_options(CLI::App& command, RunOptions& run) {
  add_source(command, run.source, "640x360", false, false);
  add_configuration(command, run);
  add_jobs(command, run.jobs);
  command.add_flag("--dump-config", run.dump_config, "Print the resolved configuration as TOML and end")
      ->group("Configuration");
  command.add_flag("--list-params", run.list_params, "Print all parameters with default, unit and range, and end")
      ->group("Configuration");

  command.add_option("-o,--output", run.output, "Folder of the report")->option_text("DIR")->group("Output");
  add_pictures(command, "frame,decision,class", [&run](const PictureSet& pictures) { run.pictures = pictures; });
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
          "--seed", [&run](const std::string& seed) { run.simulation.seed = parse_seed(seed); },
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

void add_stress_options(CLI::App& command, StressCommandOptions& stress) {
  command.add_option("--rays", stress.stress.rays, "Rays over all cases; default 200000")
      ->option_text("N")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 40))
      ->group("Campaign");
  command
      .add_option_function<std::string>(
          "--seed", [&stress](const std::string& seed) { stress.stress.seed = parse_seed(seed); },
          "Of meshes and rays; default 1")
      ->option_text("N")
      ->group("Campaign");
  command.add_option("--only", stress.stress.only, "One case, or one mesh in all its placements")
      ->option_text("CASE")
      ->group("Campaign");
  command
      .add_option_function<std::string>(
          "--bits", [&stress](const std::string& list) { stress.formats = parse_formats(list); },
          "Stored fraction bits of box and triangle test, each set a campaign of its own: 23 (default), 7-23, 10,15 or "
          "BOX/TRIANGLE (shading plays no part)")
      ->option_text("LIST")
      ->group("Campaign");
  command.add_flag("--leaks", stress.stress.leaks_only, "Closed meshes alone, from inside through vertices and edges")
      ->group("Campaign");
  command.add_flag("--list", stress.list, "Print the cases and end")->group("Campaign");
  command.add_option("--json", stress.json, "Write the report as JSON as well")->option_text("FILE")->group("Output");
  command.add_flag("--force", stress.force, "Replace an existing FILE")->group("Output");
  command.add_flag("--quiet", stress.quiet, "No table and no progress bar; a failure is still reported")
      ->group("Output");
}

void add_precision_options(CLI::App& command, PrecisionOptions& precision) {
  add_source(command, precision.source, "320x180", false, true);
  add_configuration(command, precision);
  add_jobs(command, precision.jobs);
  command
      .add_option_function<std::string>(
          "--bits", [&precision](const std::string& list) { precision.formats = parse_formats(list); },
          "Stored fraction bits: M of all three datapaths, M-N, BOX/TRIANGLE or BOX/TRIANGLE/SHADING; 23 is always "
          "among them; default 7-15,17,19,21,23")
      ->option_text("LIST")
      ->group("Sweep");
  command
      .add_option_function<std::string>(
          "--trees", [&precision](const std::string& list) { precision.trees = parse_trees(list); },
          "Trees of both classes of geometry; default bvh2,bvh4,bvh8,kd")
      ->option_text("LIST")
      ->group("Sweep");
  command.add_option("-o,--output", precision.output, "Folder of the report")->option_text("DIR")->group("Output");
  command.add_flag("--force", precision.force, "Replace an earlier run's folder")->group("Output");
  command.add_flag("--quiet", precision.quiet, "No table, no notes, no progress bar")->group("Output");
}

void add_sampling_options(CLI::App& command, SamplingOptions& sampling) {
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

void add_scaling_options(CLI::App& command, ScalingOptions& scaling) {
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
  command.add_option("-o,--output", scaling.output, "Folder of the report")->option_text("DIR")->group("Output");
  command.add_flag("--force", scaling.force, "Replace an earlier run's folder")->group("Output");
  command.add_flag("--quiet", scaling.quiet, "No table, no notes, no progress bar")->group("Output");
}

void add_quality_options(CLI::App& command, QualityOptions& quality) {
  add_source(command, quality.source, "640x360", false, true);
  add_configuration(command, quality);
  add_jobs(command, quality.jobs);
  command
      .add_option("--references", quality.references,
                  fmt::format("Reference thresholds, 0 ... 255; default {}", quality.references))
      ->option_text("LIST")
      ->group("Sweep");
  std::string names;
  for (const Policy& policy : all_policies()) names += (names.empty() ? "" : ",") + policy.name;
  command.add_option("--policies", quality.policies, fmt::format("How thresholds are moved; default {}", names))
      ->option_text("LIST")
      ->group("Sweep");
  command
      .add_option("--shares", quality.shares,
                  fmt::format("Traced shares, in percent, at which policies are compared; default {}", quality.shares))
      ->option_text("LIST")
      ->group("Sweep");
  command.add_option("--worst", quality.worst, "Pixels of each point that are listed; default 20")
      ->option_text("N")
      ->check(CLI::Range(0u, 1000000u))
      ->group("Output");
  add_pictures(command, "strip", [&quality](const PictureSet& pictures) { quality.pictures = pictures; });
  command.add_option("-o,--output", quality.output, "Folder of the report")->option_text("DIR")->group("Output");
  command.add_flag("--force", quality.force, "Replace an earlier run's folder")->group("Output");
  command.add_flag("--quiet", quality.quiet, "No tables, no notes, no progress bar")->group("Output");
}

void add_bench_options(CLI::App& command, BenchOptions& bench) {
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
                  "Modes, between commas: golden (the golden model) and those of `artu run`; default all")
      ->option_text("LIST")
      ->group("Measurement");
  command.add_option("--repeats", bench.repeats, fmt::format("Rounds that are timed; default {}", bench.repeats))
      ->option_text("N")
      ->check(CLI::Range(1u, 1000u))
      ->group("Measurement");
  command
      .add_option_function<std::string>(
          "--seed", [&bench](const std::string& seed) { bench.seed = parse_seed(seed); },
          "Of the order in which modes take turns, and of sampled; default 1")
      ->option_text("N")
      ->group("Measurement");
  command
      .add_flag_callback(
          "--no-growth", [&bench] { bench.growth = false; },
          "Leave out how time and memory grow with pixels, triangles and cores")
      ->group("Measurement");
  command.add_option("-o,--output", bench.output, "Folder of the report")->option_text("DIR")->group("Output");
  command.add_flag("--force", bench.force, "Replace an earlier run's folder")->group("Output");
  command.add_flag("--quiet", bench.quiet, "No tables, no notes, no progress bar")->group("Output");
}

/// One line, without the full stop.
std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text;
}

/// CLI11 would only say that a command is missing.
void refuse_unknown_command(const CLI::App& app, int argc, const char* const* argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  const auto is_named = [&](const CLI::App* command) { return command->get_name() == argv[1]; };
  if (!app.get_subcommands(is_named).empty()) return;
  throw InputError("command line", fmt::format("unknown command \"{}\"; run, check, import, precision, scaling, "
                                               "quality, sampling, bench, diff or stress would be right",
                                               one_line(argv[1])));
}

int parse_and_run(int argc, const char* const* argv) {
  CLI::App app("ARTU: a cycle-approximate model of a mobile ray-tracing unit, exact to the bit in every pixel", "artu");
  app.set_version_flag("--version", std::string("artu ") + ARTU_VERSION, "Print the version and end");
  app.footer(examples);
  app.require_subcommand(1);

  RunOptions run;
  ImportOptionsOfCommand import;
  std::string picture_a, picture_b;
  std::function<int()> chosen;

  CLI::App* command = app.add_subcommand("run", "Simulate frames and write a report");
  add_run_options(*command, run);
  command->add_flag("--check", run.check, "Compare every pixel with the golden model; exit code 1 on a mismatch")
      ->group("Output");
  command->callback([&] { chosen = [&] { return run_command(run); }; });

  command = app.add_subcommand("check",
                               "Simulate frames and compare every pixel with the golden model; a report only with -o");
  add_run_options(*command, run);
  command->callback([&] {
    run.check = true;
    run.folder_by_default = false;
    chosen = [&] { return run_command(run); };
  });

  command = app.add_subcommand("import", "Turn frames of a scene into a trace");
  add_source(*command, import.source, "640x360", true, true);
  command->add_option("-o,--output", import.output, "The trace")->option_text("FILE")->required()->group("Output");
  command->add_flag("--force", import.force, "Replace an existing FILE")->group("Output");
  command->add_flag("--quiet", import.quiet, "No summary, no notes, no progress bar")->group("Output");
  command->callback([&] { chosen = [&] { return import_command(import); }; });

  PrecisionOptions precision;
  command =
      app.add_subcommand("precision",
                         "Simulate frames with datapaths of every width and with every kind of tree: cycles, node "
                         "visits, and how far the picture is from 23 bits' and from one in binary64.  Widths and "
                         "trees of the configuration do not count.  A frame of the sample stage takes one to "
                         "two minutes with the defaults");
  add_precision_options(*command, precision);
  command->callback([&] { chosen = [&] { return precision_command(precision); }; });

  SamplingOptions sampling;
  command = app.add_subcommand("sampling", "How right sampled is: all frames simulated, and sampled with many seeds");
  add_sampling_options(*command, sampling);
  command->callback([&] { chosen = [&] { return sampling_command(sampling); }; });

  ScalingOptions scaling;
  scaling.variation = "core.count=1,2,4,8,16";
  command = app.add_subcommand("scaling",
                               "Simulate the same frames with several values of one parameter: cycles, speed-up, and "
                               "what limits it");
  add_scaling_options(*command, scaling);
  command->callback([&] { chosen = [&] { return scaling_command(scaling); }; });

  QualityOptions quality;
  command = app.add_subcommand("quality",
                               "Simulate the same frames with every policy and reference threshold: cycles, rays, DRAM "
                               "bytes and energy against the picture's distance from the full render");
  add_quality_options(*command, quality);
  command->callback([&] { chosen = [&] { return quality_command(quality); }; });

  BenchOptions bench;
  command = app.add_subcommand("bench",
                               "Time every mode of simulation and the golden model on the same frames, in turns: run "
                               "time, memory, error of the cycles, and how they grow");
  add_bench_options(*command, bench);
  command->callback([&] { chosen = [&] { return bench_command(bench); }; });

  command = app.add_subcommand("diff",
                               "How far two PNG pictures are apart: PSNR, SSIM, FLIP, largest difference, share of "
                               "pixels; exit code 0 whenever they could be compared");
  command->add_option("A.png", picture_a, "A picture")->option_text(" ")->required();
  command->add_option("B.png", picture_b, "Another, of the same size")->option_text(" ")->required();
  command->callback([&] { chosen = [&] { return diff_command(picture_a, picture_b); }; });

  StressCommandOptions stress;
  command = app.add_subcommand("stress",
                               "Trace rays that are hard to get right with every kind of tree, brute force and the "
                               "golden model; exit code 1 where any two answers differ, or a closed mesh leaks");
  add_stress_options(*command, stress);
  command->callback([&] { chosen = [&] { return stress_command(stress); }; });

  run.command.assign(argv, argv + argc);
  precision.command = scaling.command = quality.command = bench.command = run.command;
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    refuse_unknown_command(app, argc, argv);
    throw InputError("command line", one_line(error.what()) + "; artu --help shows what would be right");
  }
  return chosen();
}

}  // namespace

int main_command(int argc, const char* const* argv) {
  handle_interruptions();
  return exit_code_of([&] { return parse_and_run(argc, argv); });
}

}  // namespace artu::sim
