#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "sim/bench/report.h"
#include "sim/command/commands.h"
#include "sim/command/frame_source.h"
#include "sim/command/progress.h"
#include "sim/config/configuration.h"
#include "sim/config/dump.h"
#include "sim/report/file.h"
#include "sim/report/run_folder.h"
#include "traces/error.h"

namespace artu::sim {
namespace fs = std::filesystem;
namespace {

constexpr const char* default_scenes[] = {"scripts/scenes/default.stage.toml", "/usr/share/glmark2/models/bunny.obj",
                                          "scripts/scenes/adversarial.gltf"};

bool is_scene(const fs::path& path) {
  const std::string name = path.filename().string();
  for (const std::string ending : {".glb", ".gltf", ".obj", ".stage.toml", ".artu"}) {
    if (name.size() > ending.size() && name.compare(name.size() - ending.size(), ending.size(), ending) == 0)
      return true;
  }
  return false;
}

/// The words as they are, a folder as the scenes in it by name; without words the default scenes that are there.
std::vector<std::string> scenes_of(const BenchOptions& options, std::vector<std::string>& notes) {
  std::vector<std::string> scenes;
  for (const std::string& word : options.scenes) {
    std::error_code error;
    if (!fs::is_directory(word, error)) {
      require_file(word);
      scenes.push_back(word);
      continue;
    }
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(word, error)) {
      if (is_scene(entry.path())) found.push_back(entry.path().string());
    }
    if (found.empty()) throw InputError(word, "holds no scene; a folder with .glb, .gltf or .obj files would be right");
    std::sort(found.begin(), found.end());
    scenes.insert(scenes.end(), found.begin(), found.end());
  }
  if (!options.scenes.empty()) return scenes;
  for (const char* scene : default_scenes) {
    if (fs::exists(scene)) {
      scenes.emplace_back(scene);
    } else {
      notes.push_back(fmt::format("{} is not here and was left out", scene));
    }
  }
  if (scenes.empty()) {
    throw InputError("command line",
                     "none of the sample scenes is here; to name scenes or a folder of them, or to "
                     "start in the project's folder, would be right");
  }
  return scenes;
}

/// Golden model first, then the fidelities that simulate one frame, in their order.
std::vector<std::string> all_modes() {
  std::vector<std::string> all{golden_mode};
  for (std::size_t i = 0; i < fidelity_count; ++i) {
    const auto fidelity = static_cast<Fidelity>(i);
    if (fidelity != Fidelity::sampled) all.emplace_back(fidelity_name(fidelity));
  }
  return all;
}

/// Those of a list, in the order of all.
std::vector<std::string> modes_of(const std::string& list) {
  std::vector<std::string> all = all_modes();
  if (list.empty()) return all;
  const std::string right = fmt::format("{}", fmt::join(all, ", "));
  std::vector<std::string> asked;
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t end = std::min(list.find(',', at), list.size());
    const std::string name = list.substr(at, end - at);
    if (name == fidelity_name(Fidelity::sampled)) {
      throw InputError("--fidelity",
                       "\"sampled\" is of a sequence, and what is measured here is one frame; artu sampling would be "
                       "right");
    }
    if (std::find(all.begin(), all.end(), name) == all.end()) {
      throw InputError("--fidelity", fmt::format("\"{}\" is none; {} would be right", name, right));
    }
    asked.push_back(name);
    at = end + 1;
  }
  const auto is_left_out = [&](const std::string& mode) {
    return std::find(asked.begin(), asked.end(), mode) == asked.end();
  };
  all.erase(std::remove_if(all.begin(), all.end(), is_left_out), all.end());
  return all;
}

SourceOptions source_of(const BenchOptions& options, const std::string& path, const std::string& size) {
  SourceOptions source;
  source.path = path;
  if (options.frame) source.frames = std::to_string(*options.frame);
  if (!traces::is_trace(path)) source.size = size;
  return source;
}

BenchScene measure_scene(const BenchOptions& options, const std::string& path, const BenchPlan& plan,
                         const hw::UnitConfig& unit, std::vector<std::string>& notes) {
  const FrameSource source(source_of(options, path, options.size), notes);
  const traces::Frame frame = source.frame(source.range().first);
  BenchScene scene;
  scene.name = fs::path(path).filename().string();
  scene.triangles = source.scene().static_geometry.triangle_count() + frame.dynamic.triangle_count();
  scene.width = source.scene().width;
  scene.height = source.scene().height;
  scene.frame = frame.index;
  scene.results = measure({source.scene(), frame, unit}, plan, notes);
  return scene;
}

GrowthPlan growth_plan(const BenchOptions& options, const std::string& path, const BenchPlan& plan,
                       const hw::UnitConfig& unit) {
  GrowthPlan growth;
  growth.bench = plan;
  // Ticks every block in every cycle: that grows with all there is, and takes as long as the others together.
  std::vector<std::string>& modes = growth.bench.modes;
  modes.erase(std::remove(modes.begin(), modes.end(), fidelity_name(Fidelity::clocked)), modes.end());
  growth.unit = unit;
  const PictureSize size = parse_size(options.size);
  growth.width = size.width;
  growth.height = size.height;
  growth.scene = fs::path(path).filename().string();
  growth.load = [&options, path](std::uint32_t width, std::uint32_t height) {
    std::vector<std::string> ignored;  // the notes are those of the first time
    const FrameSource source(source_of(options, path, fmt::format("{}x{}", width, height)), ignored);
    return GrowthPlan::Loaded{source.scene(), source.frame(source.range().first)};
  };
  return growth;
}

using Grow = Growth (*)(const GrowthPlan&, std::vector<std::string>&);
constexpr Grow all_growth[] = {grow_pixels, grow_triangles, grow_cores, grow_idle_cores};

}  // namespace

int bench_command(const BenchOptions& options) {
  std::vector<std::string> notes;
  const hw::UnitConfig unit = Configuration::of(options.config_files, options.assignments).unit();
  BenchReport report;
  report.plan.modes = modes_of(options.fidelity);
  report.plan.repeats = options.repeats;
  report.plan.seed = options.seed;
  parse_size(options.size);
  const std::vector<std::string> scenes = scenes_of(options, notes);
  const bool growth = options.growth && !traces::is_trace(scenes[0]);
  if (options.growth && !growth) notes.push_back(scenes[0] + ": a trace has one size, so growth is not measured of it");
  RunFolder folder = options.output.empty() ? RunFolder::next_free("bench") : RunFolder(options.output, options.force);
  {
    Progress progress(scenes.size() + (growth ? std::size(all_growth) : 0), "measurements", options.quiet);
    for (const std::string& scene : scenes) {
      report.scenes.push_back(measure_scene(options, scene, report.plan, unit, notes));
      progress.one_done();
    }
    const GrowthPlan plan = growth_plan(options, scenes[0], report.plan, unit);
    for (const Grow grow : all_growth) {
      if (!growth) break;
      report.growth.push_back(grow(plan, notes));
      progress.one_done();
    }
  }
  const std::string tables = format_bench(report);
  write_file(folder.file("bench.txt"), tables);
  write_file(folder.file("bench.csv"), bench_csv(report));
  write_file(folder.file("growth.csv"), growth_csv(report));
  write_file(folder.file("bench.json"), bench_json(report, options.command, ARTU_VERSION));
  write_file(folder.file("config.toml"), dump_config(unit));
  write_file(folder.file("manifest.json"), bench_json({report.plan, {}, {}}, options.command, ARTU_VERSION));
  const Plot plot = bench_plot(report);
  const std::string no_plot =
      plot.name.empty() ? "no mode with cycles was measured beside event" : draw_plot(folder.partial(), plot);
  folder.commit();

  if (!no_plot.empty()) notes.push_back("no plot: " + no_plot);
  std::vector<std::string> once;  // a mode is left out in every measurement for the same reason
  for (const std::string& note : notes) {
    if (std::find(once.begin(), once.end(), note) == once.end()) once.push_back(note);
  }
  print_notes(once, options.quiet);
  if (!options.quiet) fmt::print("{}{:<12}{}\n", tables, "report", folder.name());
  return exit_fine;
}

}  // namespace artu::sim
