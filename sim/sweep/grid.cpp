#include "sim/sweep/grid.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "sim/import/import.h"
#include "sim/sweep/grid_axes.h"
#include "sim/sweep/toml_file.h"
#include "traces/error.h"
#include "traces/trace.h"

namespace artu::sim {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t maximum_samples = 100'000;
constexpr std::array<Design, 5> designs{Design::grid, Design::list, Design::latin_hypercube, Design::sobol,
                                        Design::search};

/// The name of its section.
std::string section_name(Design design) { return design == Design::list ? "point" : design_name(design); }

class Reader {
 public:
  explicit Reader(const std::string& name) : file_(name) { grid_.file = name; }

  Grid read() {
    file_.allow(
        file_.root(),
        {"scenes",       "frames",          "size",         "fps",      "config",     "set",     "fidelity", "seed",
         "sample_share", "target_error",    "inject_fault", "pictures", "objectives", "invalid", "screen",   "grid",
         "point",        "latin_hypercube", "sobol",        "search"});
    scenes();
    base();
    simulation();
    objectives();
    screen();
    sample();
    design();
    return std::move(grid_);
  }

 private:
  const toml::node* find(const char* key) const { return file_.root().get(key); }

  /// What a parser of the command line throws names the option; the line of the file is wanted as well.
  template <class Parse>
  auto at(const toml::node& node, Parse parse) const {
    try {
      return parse();
    } catch (const InputError& error) {
      throw InputError(file_.place(node), error.what());
    }
  }

  /// Names in the file are relative to it.
  std::string path(const std::string& name) const {
    const fs::path given(name);
    return given.is_absolute() ? name : (fs::path(grid_.file).parent_path() / given).lexically_normal().string();
  }

  void source(const toml::table& table, SourceOptions& source) const {
    if (const toml::node* frames = table.get("frames")) {
      source.frames = file_.text(*frames, "frames");
      at(*frames, [&] { return parse_frames(*source.frames); });
    }
    if (const toml::node* size = table.get("size")) {
      source.size = file_.text(*size, "size");
      at(*size, [&] { return parse_size(*source.size); });
    }
    if (const toml::node* fps = table.get("fps")) {
      source.fps = file_.real(*fps, "fps");
      at(*fps, [&] { check_fps(*source.fps); });
    }
  }

  /// A file with two ranges of frames is two scenes, whose points are not compared with each other.
  void name_scenes() {
    for (std::size_t i = 0; i < grid_.scenes.size(); ++i) {
      const SourceOptions& scene = grid_.scenes[i];
      bool frames = false, size = false, fps = false;
      for (const SourceOptions& other : grid_.scenes) {
        if (other.path != scene.path) continue;
        frames |= other.frames != scene.frames;
        size |= other.size != scene.size;
        fps |= other.fps != scene.fps;
      }
      std::vector<std::string> differs;
      if (frames) differs.push_back("frames " + scene.frames.value_or(traces::is_trace(scene.path) ? "first" : "0:1"));
      if (size) differs.push_back(scene.size.value_or("640x360"));
      if (fps) differs.push_back(fmt::format("{} fps", scene.fps.value_or(ImportOptions{}.fps)));
      const std::string more = fmt::format(" ({})", fmt::join(differs, "; "));
      grid_.scene_names.push_back(grid_.scene_files[i] + (differs.empty() ? "" : more));
    }
  }

  void scenes() {
    const toml::node* scenes = find("scenes");
    if (scenes == nullptr) throw InputError(grid_.file, "has no scenes; scenes = [\"scene.glb\"] would be right");
    for (const toml::node& item : file_.array(*scenes, "scenes")) {
      SourceOptions scene;
      std::string written;
      source(file_.root(), scene);
      if (const auto* table = item.as_table()) {
        file_.allow(*table, {"file", "frames", "size", "fps"});
        if (!table->contains("file")) file_.refuse(item, "the scene has no file; file = \"scene.glb\" would be right");
        written = file_.text(*table->get("file"), "file");
        source(*table, scene);
      } else {
        written = file_.text(item, "scene");
      }
      scene.path = path(written);
      at(item, [&] { require_file(scene.path); });
      for (const SourceOptions& other : grid_.scenes) {
        const bool same = other.path == scene.path && other.frames == scene.frames && other.size == scene.size &&
                          other.fps == scene.fps;
        if (same) file_.refuse(item, scene.path + " is there twice; once would be right");
      }
      grid_.scenes.push_back(scene);
      grid_.scene_files.push_back(written);
    }
    name_scenes();
    if (grid_.scenes.empty()) file_.refuse(*scenes, "scenes is empty; [\"scene.glb\"] would be right");
  }

  void base() {
    if (const toml::node* files = find("config")) {
      for (const std::string& name : file_.texts(*files, "config")) {
        grid_.config_files.push_back(path(name));
        at(*files, [&] { grid_.base.load(grid_.config_files.back()); });
      }
    }
    if (const toml::node* set = find("set")) {
      for (const toml::node& item : file_.array(*set, "set")) {
        grid_.assignments.push_back(file_.text(item, "set"));
        grid_.base.set(grid_.assignments.back(), file_.place(item));
      }
    }
  }

  void simulation() {
    if (const toml::node* mode = find("fidelity")) {
      grid_.simulation.fidelity = at(*mode, [&] { return parse_fidelity(file_.text(*mode, "fidelity")); });
    }
    if (const toml::node* seed = find("seed")) {
      grid_.simulation.seed = file_.count(*seed, "seed", 0, ~0ull >> 1);
      grid_.sample_words.insert(grid_.sample_words.end(), {"--seed", fmt::format("{}", grid_.simulation.seed)});
    }
    const auto percent = [&](const char* key, const char* option, double SampleSize::*value) {
      const toml::node* node = find(key);
      if (node == nullptr) return;
      const std::string text = file_.text(*node, key);
      grid_.sample.*value = at(*node, [&] { return parse_percent(option, text); });
      grid_.sample_words.insert(grid_.sample_words.end(), {option, text});
    };
    percent("sample_share", "--sample-share", &SampleSize::share);
    percent("target_error", "--target-error", &SampleSize::target_error);
    if (find("sample_share") != nullptr && find("target_error") != nullptr) {
      file_.refuse(*find("target_error"), "target_error and sample_share exclude each other; one would be right");
    }
    if (const toml::node* fault = find("inject_fault")) {
      grid_.fault_words = file_.text(*fault, "inject_fault");
      grid_.simulation.fault = at(*fault, [&] { return parse_fault(grid_.fault_words); });
    }
    if (const toml::node* pictures = find("pictures")) {
      grid_.picture_words = file_.text(*pictures, "pictures");
      grid_.pictures = at(*pictures, [&] { return parse_pictures(grid_.picture_words); });
    }
    if (const toml::node* invalid = find("invalid")) {
      const std::string what = file_.text(*invalid, "invalid");
      grid_.skip_invalid = what == "skip";
      if (!grid_.skip_invalid && what != "refuse") {
        file_.refuse(*invalid, "invalid = \"" + what.substr(0, 80) + "\" is neither; refuse or skip would be right");
      }
    }
  }

  void objectives() {
    const toml::node* objectives = find("objectives");
    if (objectives == nullptr) return;
    for (const toml::node& item : file_.array(*objectives, "objectives")) {
      Objective objective;
      if (const auto* table = item.as_table()) {
        file_.allow(*table, {"figure", "goal"});
        if (!table->contains("figure"))
          file_.refuse(item, "the objective has no figure; figure = \"fps\" would be right");
        objective.figure = file_.text(*table->get("figure"), "figure");
        const std::string goal = table->contains("goal") ? file_.text(*table->get("goal"), "goal") : "minimise";
        objective.maximise = goal == "maximise";
        if (!objective.maximise && goal != "minimise") {
          file_.refuse(item, "goal = \"" + goal.substr(0, 80) + "\" is none; minimise or maximise would be right");
        }
      } else {
        objective.figure = file_.text(item, "objective");
      }
      grid_.objectives.push_back(objective);
    }
  }

  void screen() {
    const toml::node* node = find("screen");
    if (node == nullptr) return;
    const toml::table& table = file_.table(*node, "screen");
    file_.allow(table, {"fidelity", "margin"});
    Screen screen;
    if (const toml::node* mode = table.get("fidelity")) {
      screen.fidelity = at(*mode, [&] { return parse_fidelity(file_.text(*mode, "fidelity")); });
    }
    if (screen.fidelity != Fidelity::analytic && screen.fidelity != Fidelity::sampled) {
      file_.refuse(*node, fmt::format("screening is not done with {}; analytic or sampled would be right",
                                      fidelity_name(screen.fidelity)));
    }
    if (!is_exact(grid_.simulation.fidelity)) {
      file_.refuse(*node, fmt::format("{} does not confirm what was screened; fidelity = \"event\" would be right",
                                      fidelity_name(grid_.simulation.fidelity)));
    }
    if (const toml::node* margin = table.get("margin")) {
      screen.margin = file_.real(*margin, "margin");
      if (!(screen.margin >= 0 && screen.margin <= 10))
        file_.refuse(*margin, "margin is a share; 0 ... 10 would be right");
    }
    grid_.screen = screen;
  }

  /// What only a sample has is refused where none is drawn.
  void sample() const {
    const bool sampled =
        grid_.simulation.fidelity == Fidelity::sampled || (grid_.screen && grid_.screen->fidelity == Fidelity::sampled);
    if (sampled) return;
    for (const char* key : {"sample_share", "target_error", "seed"}) {
      if (const toml::node* node = find(key)) {
        file_.refuse(*node, std::string(key) + " is of fidelity = \"sampled\"; that as well would be right");
      }
    }
  }

  void design() {
    std::vector<Design> given;
    for (const Design design : designs) {
      if (find(section_name(design).c_str()) != nullptr) given.push_back(design);
    }
    if (given.size() != 1) {
      throw InputError(grid_.file,
                       fmt::format("has {} designs; one of [grid], [[point]], [latin_hypercube], [sobol] and "
                                   "[search] would be right",
                                   given.empty() ? "no" : "several"));
    }
    grid_.design = given[0];
    if (grid_.design == Design::search && grid_.screen) {
      file_.refuse(*find("screen"), "a search chooses by what it has seen; without [screen] would be right");
    }
    const toml::node& node = *find(section_name(grid_.design).c_str());
    const AxisReader reader(file_, grid_.base);
    if (grid_.design == Design::grid) {
      grid_.axes = reader.lists(file_.table(node, "grid"));
    } else if (grid_.design == Design::list) {
      reader.points(file_.array(node, "point"), grid_.axes, grid_.listed, grid_.listed_places);
    } else {
      const toml::table& table = file_.table(node, section_name(grid_.design));
      std::vector<std::string> keys{"samples", "seed"};
      if (grid_.design == Design::search) keys.emplace_back("batch");
      if (!table.contains("samples")) file_.refuse(node, "has no samples; samples = 64 would be right");
      grid_.samples = static_cast<std::uint32_t>(file_.count(*table.get("samples"), "samples", 1, maximum_samples));
      if (const toml::node* seed = table.get("seed")) grid_.seed = file_.count(*seed, "seed", 0, ~0ull >> 1);
      grid_.batch = 16;
      if (const toml::node* batch = table.get("batch")) {
        grid_.batch = static_cast<std::uint32_t>(file_.count(*batch, "batch", 1, maximum_samples));
      }
      grid_.axes = reader.intervals(table, keys);
    }
    if (grid_.axes.empty()) {
      file_.refuse(node, fmt::format("{} names no parameter; core.count = [1, 4], for example, would be right",
                                     section_name(grid_.design)));
    }
  }

  TomlFile file_;
  Grid grid_;
};

}  // namespace

const char* design_name(Design design) {
  switch (design) {
    case Design::grid:
      return "grid";
    case Design::list:
      return "list";
    case Design::latin_hypercube:
      return "latin_hypercube";
    case Design::sobol:
      return "sobol";
    default:
      return "search";
  }
}

Grid read_grid(const std::string& file) { return Reader(file).read(); }

std::vector<std::vector<std::string>> read_points(const std::string& name, const Grid& grid) {
  const TomlFile file(name);
  file.allow(file.root(), {"point"});
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> places;
  std::vector<Axis> axes = grid.axes;
  if (const toml::node* points = file.root().get("point")) {
    AxisReader(file, grid.base).points(file.array(*points, "point"), axes, rows, places);
  }
  return rows;
}

}  // namespace artu::sim
