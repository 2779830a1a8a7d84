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
  CLI::App& command = add_command(
      line, "precision", "What narrow datapaths cost, and what they do to the picture, with every kind of tree",
      options, precision_command);
  declare(command, *options);
  add_examples(command, {{"artu precision scene.glb", "all widths and trees: a minute or two"},
                         {"artu precision scene.glb --bits 8-12,23 --trees bvh2", "some of them"}});
}

}  // namespace artu::sim
