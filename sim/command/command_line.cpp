#include <algorithm>

#include "sim/command/line/lines.h"
#include "sim/command/line/shared.h"
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

/// One line, without the full stop.
std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text;
}

/// CLI11 would only say that a command is missing.
void refuse_unknown_command(const CLI::App& app, int argc, const char* const* argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::string names, last;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == argv[1]) return;
    if (!last.empty()) names += (names.empty() ? "" : ", ") + last;
    last = command->get_name();
  }
  throw InputError("command line",
                   fmt::format("unknown command \"{}\"; {} or {} would be right", one_line(argv[1]), names, last));
}

int parse_and_run(int argc, const char* const* argv) {
  CLI::App app("ARTU: a cycle-approximate model of a mobile ray-tracing unit, exact to the bit in every pixel", "artu");
  app.set_version_flag("--version", std::string("artu ") + ARTU_VERSION, "Print the version and end");
  app.footer(examples);
  app.require_subcommand(1);
  CommandLine line{app, {}, {argv, argv + argc}};
  for (const auto add : {add_run, add_check, add_import, add_precision, add_sampling, add_scaling, add_quality,
                         add_bench, add_diff, add_stress}) {
    add(line);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    refuse_unknown_command(app, argc, argv);
    throw InputError("command line", one_line(error.what()) + "; artu --help shows what would be right");
  }
  return line.chosen();
}

}  // namespace

int main_command(int argc, const char* const* argv) {
  handle_interruptions();
  return exit_code_of([&] { return parse_and_run(argc, argv); });
}

}  // namespace artu::sim
