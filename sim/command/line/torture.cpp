#include "sim/command/line/lines.h"
#include "sim/command/line/shared.h"

namespace artu::sim {
namespace {

void declare(CLI::App& command, TortureOptions& torture) {
  command.add_option("--cases", torture.cases, "Units and scenes that are drawn; default 200")
      ->option_text("N")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 40))
      ->group("Campaign");
  command
      .add_option_function<std::string>(
          "--seed", [&torture](const std::string& seed) { torture.seed = parse_seed(seed); },
          "Of the first case; the next one has N + 1, and so on; default 1")
      ->option_text("N")
      ->group("Campaign");
  command.add_flag("--dry-run", torture.dry_run, "Print the cases, simulate nothing and end")->group("Campaign");
  command
      .add_option_function<std::string>(
          "--inject-fault", [&torture](const std::string& fault) { torture.fault = parse_fault(fault); },
          "As of `artu run`: in every case, to see that it is found")
      ->option_text("DATAPATH[:BIT]")
      ->group("Campaign");
  add_jobs(command, torture.jobs);
  command.add_option("-o,--output", torture.output, "Folder for unit and scene of the smallest case that fails")
      ->option_text("DIR")
      ->group("Output");
  command.add_flag("--quiet", torture.quiet, "No table and no progress bar; a failure is still reported")
      ->group("Output");
}

}  // namespace

void add_torture(CommandLine& line) {
  const auto options = std::make_shared<TortureOptions>();
  CLI::App& command =
      add_command(line, "torture", "Units and scenes drawn at random, against the golden model and the accounting laws",
                  options, torture_command);
  command.description(
      "Simulate units and scenes that are drawn at random, with random stalls, against the golden model and the "
      "accounting laws.  A failure is made as small as it goes; exit code 1");
  declare(command, *options);
  add_examples(command, {{"artu torture --cases 1000 --jobs 2", "a thousand units and scenes"},
                         {"artu torture --cases 1 --seed 17 -o bad", "one of them; what fails goes into a folder"}});
}

}  // namespace artu::sim
