#include <algorithm>

#include "sim/command/line/lines.h"
#include "sim/command/line/shared.h"
#include "sim/report/interruption.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

/// A command, and under which heading `artu --help` has it; headings come in the order of their first commands.
struct Command {
  const char* group;
  void (*add)(CommandLine&);
};

constexpr const char* simulate = "Simulate";
constexpr const char* look = "Look at a run";
constexpr const char* explore = "Explore a design";
constexpr const char* check = "Check the model";
constexpr const char* input = "Prepare input";
constexpr const char* shell = "Set up a shell";

// A line each.
// clang-format off
constexpr Command commands[] = {
    {simulate, add_run},
    {look, add_report_page},
    {look, add_explain},
    {explore, add_scaling},
    {explore, add_sweep},
    {explore, add_reuse},
    {explore, add_quality},
    {explore, add_precision},
    {check, add_check},
    {check, add_diff},
    {check, add_stress},
    {check, add_torture},
    {check, add_sampling},
    {check, add_bench},
    {input, add_import},
    {shell, add_completion},
    {shell, add_man},
};
// clang-format on

/// One or two of a group; each command has its own.
const std::vector<Example> examples{
    {"artu run scripts/scenes/default.stage.toml", "one frame of the sample stage into runs/default-1"},
    {"artu run scene.glb -c phone.toml --set core.count=4", "another unit"},
    {"artu run --list-params", "what can be configured"},
    {"artu report runs/default-1", "a page of it, to open in a browser"},
    {"artu explain runs/default-1", "what binds it, and which parameter to turn next"},
    {"artu scaling scene.glb --vary core.count=1,2,4,8", "what more cores gain, and what limits them"},
    {"artu reuse scene.glb", "what caches of all sizes would miss, from one run"},
    {"artu sweep grid.toml -o caches --jobs 2", "any parameters and scenes: a folder a point, and one table"},
    {"artu check scene.glb --frames 12", "frame 12 against the golden model"},
    {"artu import scene.glb --frames all -o scene.artu", "all frames as a trace, to run without the scene"},
};

constexpr const char* ending = R"(

artu COMMAND --help has the options of a command and more examples.
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

/// An empty word is no value, and to most options it would look as if they were not given.
void refuse_empty_values(const CLI::App& app) {
  for (const CLI::App* command : app.get_subcommands()) {
    for (const CLI::Option* option : command->get_options()) {
      for (const std::string& value : option->results()) {
        if (value.empty()) throw InputError(option->get_name(), "is empty; a value would be right");
      }
    }
  }
}

int parse_and_run(int argc, const char* const* argv) {
  CLI::App app("ARTU: a cycle-approximate model of a mobile ray-tracing unit, exact to the bit in every pixel", "artu");
  app.set_version_flag("--version", std::string("artu ") + ARTU_VERSION, "Print the version and end");
  app.require_subcommand(1);
  CommandLine line{app, {}, {argv, argv + argc}};
  for (const Command& command : commands) {
    command.add(line);
    app.get_subcommands([](const CLI::App*) { return true; }).back()->group(command.group);
  }
  app.footer(format_examples(examples) + ending);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    refuse_unknown_command(app, argc, argv);
    // The first word is a command, or an option of none.
    const std::string help = argc > 1 && argv[1][0] != '-' ? fmt::format("artu {} --help", argv[1]) : "artu --help";
    throw InputError("command line", fmt::format("{}; {} shows what would be right", one_line(error.what()), help));
  }
  refuse_empty_values(app);
  return line.chosen();
}

}  // namespace

int main_command(int argc, const char* const* argv) {
  return exit_code_of([&] {
    handle_interruptions();
    return parse_and_run(argc, argv);
  });
}

}  // namespace artu::sim
