#include "sim/command/line/lines.h"
#include "sim/command/line/shared.h"

namespace artu::sim {

void add_report_page(CommandLine& line) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App& command = add_command(line, "report",
                                  "Make one HTML file of a run's folder that any browser opens, without a network; of "
                                  "two folders a comparison, of more a table, of a sweep its front",
                                  options, report_command);
  command.add_option("DIR", options->folders, "Folders of artu run, or one of artu sweep")
      ->option_text(" ")
      ->required();
  command.add_option("-o,--output", options->output, "The page; default report.html in the first folder")
      ->option_text("FILE.html")
      ->group("Output");
  command
      .add_option("--picture-megabytes", options->picture_megabytes,
                  fmt::format("Pictures of frames are left out, evenly, where they are more; default {}",
                              options->picture_megabytes))
      ->option_text("N")
      ->check(CLI::Range(0u, 1024u))
      ->group("Output");
  command.add_flag("--force", options->force, "Replace an existing FILE")->group("Output");
  command.add_flag("--quiet", options->quiet, "No summary, no notes")->group("Output");
  add_examples(command, {{"artu report runs/default-1", "into runs/default-1/report.html"}});
}

}  // namespace artu::sim
