#include "sim/command/line/shared.h"

#include <algorithm>

#include "sim/jobs/processes.h"

namespace artu::sim {

std::string format_examples(const std::vector<Example>& examples) {
  std::size_t width = 0;
  for (const Example& example : examples) width = std::max(width, std::string(example.words).size());
  std::string out = "Examples:";
  for (const Example& example : examples) out += fmt::format("\n  {:<{}}  {}", example.words, width, example.what);
  return out;
}

void add_examples(CLI::App& command, const std::vector<Example>& examples) {
  command.footer(format_examples(examples));
}

void add_source(CLI::App& command, SourceOptions& source, const char* size, bool scene_only, bool required) {
  const char* what = scene_only ? "A scene: .glb, .gltf, .obj or .stage.toml"
                                : "A scene (.glb, .gltf, .obj, .stage.toml) or a trace of `artu import`";
  auto* path = command.add_option(scene_only ? "SCENE" : "SCENE|TRACE", source.path, what);
  path->option_text(" ");
  if (required) path->required();
  add_frames(command, source, size);
}

void add_frames(CLI::App& command, SourceOptions& source, const char* size) {
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

void add_jobs(CLI::App& command, std::uint32_t& jobs) {
  command.add_option("--jobs", jobs, "Processes that the frames are shared out to; changes no result; default 1")
      ->option_text("N")
      ->check(CLI::Range(1u, maximum_jobs))
      ->group("Simulation");
}

void add_pictures(CLI::App& command, const char* by_default, const std::function<void(const PictureSet&)>& take) {
  std::string names;
  for (const char* name : picture_names) names += std::string(name) + ", ";
  command
      .add_option_function<std::string>(
          "--pictures", [take](const std::string& list) { take(parse_pictures(list)); },
          fmt::format("Pictures of the report: {}all or none; default {}", names, by_default))
      ->option_text("LIST")
      ->group("Output");
}

void add_sample_size(CLI::App& command, SampleSize& size, const std::function<void(const char*)>& given) {
  const auto percent = [&size, given](const char* option, double SampleSize::*value) {
    return [&size, given, option, value](const std::string& text) {
      size.*value = parse_percent(option, text);
      given(option);
    };
  };
  auto* share = command.add_option_function<std::string>(
      "--sample-share", percent("--sample-share", &SampleSize::share),
      "Share of the different frames that sampled simulates, at least 4 of them, "
      "instead of a target error");
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

}  // namespace artu::sim
