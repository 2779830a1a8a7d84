#include "sim/command/line/lines.h"
#include "sim/command/line/shared.h"

namespace artu::sim {
namespace {

void declare(CLI::App& command, PrecisionOptions& precision) {
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
  add_report(command, precision, "No table, no notes, no progress bar");
}

}  // namespace

void add_precision(CommandLine& line) {
  const auto options = std::make_shared<PrecisionOptions>();
  options->command = line.words;
  declare(add_command(line, "precision",
                      "Simulate frames with datapaths of every width and with every kind of tree: cycles, node "
                      "visits, and how far the picture is from 23 bits' and from one in binary64.  Widths and "
                      "trees of the configuration do not count.  A frame of the sample stage takes one to "
                      "two minutes with the defaults",
                      options, precision_command),
          *options);
}

}  // namespace artu::sim
