#include "sim/command/line/lines.h"
#include "sim/command/line/shared.h"

namespace artu::sim {

void add_import(CommandLine& line) {
  const auto options = std::make_shared<ImportOptionsOfCommand>();
  CLI::App& command = add_command(line, "import", "Turn frames of a scene into a trace", options, import_command);
  add_source(command, options->source, "640x360", true, true);
  command.add_option("-o,--output", options->output, "The trace")->option_text("FILE")->required()->group("Output");
  command.add_flag("--force", options->force, "Replace an existing FILE")->group("Output");
  command.add_flag("--quiet", options->quiet, "No summary, no notes, no progress bar")->group("Output");
  add_examples(command,
               {{"artu import scene.glb --frames all -o scene.artu", "all frames of the animation"},
                {"artu import room.stage.toml --size 320x180 --frames 0:4 -o room.artu", "four frames of a stage"}});
}

}  // namespace artu::sim
