#include "sim/command/line/lines.h"
#include "sim/command/line/shared.h"

namespace artu::sim {
namespace {

void declare(CLI::App& command, StressCommandOptions& stress) {
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

}  // namespace

void add_stress(CommandLine& line) {
  const auto options = std::make_shared<StressCommandOptions>();
  CLI::App& command = add_command(line, "stress", "Rays that are hard to get right, against every kind of tree",
                                  options, stress_command);
  declare(command, *options);
  add_examples(command, {{"artu stress", "exit code 1 where two answers differ, or a closed mesh leaks"},
                         {"artu stress --leaks --rays 5000000 --seed 7", "closed meshes alone, more rays"},
                         {"artu stress --list", "the cases"}});
}

}  // namespace artu::sim
