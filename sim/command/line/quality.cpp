#include "sim/command/line/lines.h"
#include "sim/command/line/shared.h"
#include "sim/quality/policies.h"

namespace artu::sim {
namespace {

void declare(CLI::App& command, QualityOptions& quality) {
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
  add_report(command, quality, "No tables, no notes, no progress bar");
}

}  // namespace

void add_quality(CommandLine& line) {
  const auto options = std::make_shared<QualityOptions>();
  options->command = line.words;
  CLI::App& command = add_command(line, "quality", "What selective rendering saves, and what the picture loses",
                                  options, quality_command);
  declare(command, *options);
  add_examples(command, {{"artu quality scene.glb --frames 4 --size 320x180", "all policies and thresholds"},
                         {"artu quality scene.glb --references 4,8,16,32 --policies fixed,attention", "some"}});
}

}  // namespace artu::sim
