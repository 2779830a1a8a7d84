#include "sim/import/stage.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "sim/import/compose.h"
#include "sim/import/resource_path.h"
#include "sim/import/stage_motion.h"
#include "sim/import/surface.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> root_keys = {"file", "camera", "light", "sky", "duration"};
const std::vector<std::string> file_keys = {"path",    "name",        "position", "rotation", "scale",
                                            "clip",    "speed",       "start",    "loop",     "static",
                                            "dynamic", "motion_loop", "key",      "node",     "material"};
const std::vector<std::string> node_keys = {"name", "position", "rotation", "scale", "motion_loop", "key"};
const std::vector<std::string> material_keys = {"name",         "diffuse", "specular", "specular_log2", "mirror",
                                                "transmission", "ior",     "emission", "tint",          "texture"};
const std::vector<std::string> camera_keys = {"fov", "position", "target", "up", "node", "loop", "key"};
const std::vector<std::string> light_keys = {"kind",      "position", "direction", "color",
                                             "intensity", "range",    "inner",     "outer"};

class StageReader {
 public:
  StageReader(const std::string& path, std::vector<std::string>& log)
      : path_(path), log_(log), toml_(parse_stage_file(path)), root_(path, "the stage", toml_, root_keys) {}

  LoadedScene read() {
    const auto files = root_.tables("file", file_keys);
    if (files.empty()) throw InputError(path_, "a stage needs at least one [[file]]");
    for (const StageTable& file : files) read_file_entry(file);
    read_camera();
    for (const StageTable& light : root_.tables("light", light_keys)) read_light(light);
    if (const auto sky = root_.table("sky", {"zenith", "nadir", "ambient"})) {
      scene_.sky = Sky{color(*sky, "zenith", {0.3, 0.45, 0.75}), color(*sky, "nadir", {0.4, 0.4, 0.4}),
                       color(*sky, "ambient", {0.15, 0.15, 0.17})};
    }
    if (root_.has("duration")) scene_.duration = root_.number("duration", 0, 1e-6, 1e9);
    return std::move(scene_);
  }

 private:
  traces::Vec3 color(const StageTable& t, const std::string& key, const glm::dvec3& otherwise) {
    const glm::dvec3 v = t.vector_or_number(key, otherwise);
    for (int i = 0; i < 3; ++i) {
      if (!(v[i] >= 0 && v[i] <= 1e9)) t.fail(key, "must not be negative");
    }
    return to_vec3(v);
  }

  /// The first candidate that exists; relative ones are beside the stage.
  std::string find_file(const StageTable& file) {
    const std::vector<std::string> candidates = file.texts("path");
    if (candidates.empty()) throw InputError(file.where(), "[[file]]: path is missing");
    std::string tried;
    for (const std::string& candidate : candidates) {
      const fs::path full =
          fs::path(candidate).is_absolute() ? fs::path(candidate) : fs::path(folder_of(path_)) / candidate;
      std::error_code error;
      if (fs::is_regular_file(full, error)) return full.string();
      tried += (tried.empty() ? "" : ", ") + full.string() + (fs::exists(full, error) ? " (no regular file)" : "");
    }
    throw InputError(file.where("path"), "[[file]]: no such file: " + tried);
  }

  const Model& model_of(const std::string& path, const StageTable& file) {
    if (path.size() > 5 && path.substr(path.size() - 5) == ".toml")
      file.fail("path", "is a stage; a stage cannot hold another");
    const auto known = models_.find(path);
    if (known != models_.end()) return known->second;
    std::vector<std::string> log;
    Model model = load_model(path, log);
    // Which clip plays is this stage's own choice, so the note on it is not news.
    for (const std::string& line : log) {
      if (line.find(choice_note) == std::string::npos) log_.push_back(line);
    }
    return models_.emplace(path, std::move(model)).first->second;
  }

  void read_file_entry(const StageTable& file) {
    const std::string path = find_file(file);
    Model part = model_of(path, file);  // a copy: geometry is shared, textures below
    choose_clip(file, part);
    Node root;
    root.name = file.text("name", fs::path(path).filename().string());
    root.local = read_placement(file, Trs{});
    // A file that is used again brings no second copy of its textures.
    const auto [first, is_new] = texture_base_.try_emplace(path, static_cast<int>(scene_.model.textures.size()));
    if (!is_new) part.textures.clear();
    const Appended added = append(scene_.model, part, root);
    if (!is_new) {
      for (std::size_t m = added.materials; m < scene_.model.materials.size(); ++m) {
        const int texture = part.materials[m - added.materials].texture;
        scene_.model.materials[m].texture = texture < 0 ? -1 : texture + first->second;
      }
    }
    nodes_ = {};
    for (std::size_t n = static_cast<std::size_t>(added.root) + 1; n < scene_.model.nodes.size(); ++n)
      nodes_.emplace(scene_.model.nodes[n].name, static_cast<int>(n));
    for (const auto& [name, n] : nodes_) all_nodes_.emplace(name, n);

    if (auto motion = read_motion(file, added.root, root.local, file.boolean("motion_loop", true)))
      scene_.model.players.push_back(std::move(*motion));
    for (const StageTable& node : file.tables("node", node_keys)) read_node(node);
    for (const char* key : {"static", "dynamic"}) {
      const auto motion = key[0] == 's' ? MotionOverride::force_static : MotionOverride::force_dynamic;
      for (const std::string& name : file.texts(key))
        scene_.model.nodes[static_cast<std::size_t>(name == "*" ? added.root : find_node(file, key, name))].motion =
            motion;
    }
    for (const StageTable& material : file.tables("material", material_keys)) read_material(material, added.materials);
  }

  void choose_clip(const StageTable& file, Model& part) {
    std::vector<std::string> names;
    for (const Clip& clip : part.clips) names.push_back(clip.name);
    if (!file.has("clip")) {
      for (Player& player : part.players) set_timing(file, player);
      return;
    }
    part.players.clear();
    std::size_t chosen = 0;
    if (file.node("clip") && file.node("clip")->is_integer()) {
      const double index = file.number("clip", 0);
      if (index == -1) return;
      if (!(index >= 0 && index < static_cast<double>(names.size())))
        file.fail("clip", "is " + std::to_string(static_cast<long long>(index)) + "; the file has " +
                              std::to_string(names.size()) + " clips (-1 plays none)");
      chosen = static_cast<std::size_t>(index);
    } else {
      const std::string name = file.text("clip", "");
      const auto it = std::find(names.begin(), names.end(), name);
      if (it == names.end()) {
        if (name == "none") return;
        const bool unnamed = std::all_of(names.begin(), names.end(), [](const std::string& n) { return n.empty(); });
        const std::string number =
            names.size() > 1 ? "; a number, 0 ... " + std::to_string(names.size() - 1) + "," : "; the number 0";
        file.fail("clip", "\"" + name + "\" is not a clip of this file" + suggest(name, names) +
                              (unnamed && !names.empty() ? number + " would be right" : ""));
      }
      chosen = static_cast<std::size_t>(it - names.begin());
    }
    Player player;
    player.clip = part.clips[chosen];
    set_timing(file, player);
    part.players.push_back(std::move(player));
  }

  static void set_timing(const StageTable& file, Player& player) {
    player.speed = file.number("speed", 1, -1e6, 1e6);
    player.start = file.number("start", 0, -1e9, 1e9);
    player.loop = file.boolean("loop", true);
  }

  int find_node(const StageTable& table, const std::string& key, const std::string& name) {
    const auto it = nodes_.find(name);
    if (it != nodes_.end()) return it->second;
    std::vector<std::string> names;
    for (const auto& [known, n] : nodes_) names.push_back(known);
    table.fail(key, "\"" + name + "\" is not a node of this file" + suggest(name, names));
  }

  void read_node(const StageTable& table) {
    if (!table.has("name")) throw InputError(table.where(), "[[file.node]]: name is missing");
    const int n = find_node(table, "name", table.text("name", ""));
    Node& node = scene_.model.nodes[static_cast<std::size_t>(n)];
    if (node.has_matrix && (table.has("position") || table.has("rotation") || table.has("scale") || table.has("key"))) {
      log_.push_back(table.where() + ": node \"" + node.name + "\" is placed by a matrix, which the stage replaces");
      node.has_matrix = false;
    }
    node.local = read_placement(table, node.local);
    if (auto motion = read_motion(table, n, node.local, table.boolean("motion_loop", true)))
      scene_.model.players.push_back(std::move(*motion));
  }

  void read_material(const StageTable& table, std::uint32_t first) {
    const std::string name = table.text("name", "*");
    bool found = false;
    std::vector<std::string> names;
    for (std::size_t m = first; m < scene_.model.materials.size(); ++m) {
      traces::Material& material = scene_.model.materials[m];
      names.push_back(material.name);
      if (name != "*" && material.name != name) continue;
      found = true;
      if (table.has("diffuse")) material.diffuse = color(table, "diffuse", {});
      if (table.has("specular")) material.specular = color(table, "specular", {});
      if (table.has("mirror")) material.mirror = color(table, "mirror", {});
      if (table.has("transmission")) material.transmission = color(table, "transmission", {});
      if (table.has("emission")) material.emission = color(table, "emission", {});
      material.specular_log2 = static_cast<std::uint32_t>(table.number("specular_log2", material.specular_log2, 0, 10));
      material.ior = static_cast<float>(table.number("ior", material.ior, 0.25, 4));
      material.tint = table.boolean("tint", material.tint);
      if (!table.boolean("texture", true)) material.texture = -1;
    }
    if (!found) table.fail("name", "\"" + name + "\" is not a material of this file" + suggest(name, names));
  }

  /// A camera needs somewhere to look; `table` is its section or a key of it.
  static void check_target(const StageTable& table, const glm::dvec3& position, const glm::dvec3& target) {
    if (position != target) return;
    if (table.has("target")) table.fail("target", "is the position; another point would be right");
    table.fail("position", "is the target, [0, 0, 0] unless it is given; another point would be right");
  }

  /// An up that was given is not along a view.  The default one may be: a view straight down has an up of its own.
  static void check_up(const StageTable& camera, const CameraTrack& track) {
    if (!camera.has("up")) return;
    if (!(glm::length(track.up) > 0)) camera.fail("up", "is zero; a direction such as [0, 1, 0] would be right");
    const glm::dvec3 up = glm::normalize(track.up);
    for (std::size_t i = 0; i < track.times.size(); ++i) {
      const glm::dvec3 view = glm::normalize(track.targets[i] - track.positions[i]);
      if (glm::length(glm::cross(view, up)) > 1e-6) continue;
      camera.fail("up", std::string("is along the view from position to target; a direction across it, such as ") +
                            (std::abs(up.y) > 0.5 ? "[0, 0, 1]" : "[0, 1, 0]") + ", would be right");
    }
  }

  void read_camera() {
    const auto table = root_.table("camera", camera_keys);
    if (!table) return;
    if (table->has("node")) {
      const std::string name = table->text("node", "");
      const auto it = all_nodes_.find(name);
      if (it == all_nodes_.end() || scene_.model.nodes[static_cast<std::size_t>(it->second)].camera < 0)
        table->fail("node", "\"" + name + "\" is not a node with a camera");
      scene_.camera_node = it->second;
      return;
    }
    CameraTrack track;
    track.lens.fov = glm::radians(table->number("fov", 45, 1, 170));
    track.up = table->vector("up", {0, 1, 0});
    track.loop = table->boolean("loop", true);
    glm::dvec3 position{0.0}, target{0.0};
    const auto keys = table->tables("key", {"time", "position", "target"});
    if (keys.empty() || table->has("position")) position = table->required_vector("position");
    target = table->vector("target", target);
    if (keys.empty()) check_target(*table, position, target);
    for (const StageTable& key : keys) {
      if (!key.has("time")) throw InputError(key.where(), "[[camera.key]]: time (seconds) is missing");
      const double time = key.number("time", 0, 0, 1e9);
      if (!track.times.empty() && time <= track.times.back())
        key.fail("time", "must be later than that of the key before");
      track.times.push_back(time);
      track.positions.push_back(position = key.vector("position", position));
      track.targets.push_back(target = key.vector("target", target));
      check_target(key, position, target);
    }
    if (keys.empty()) {
      track.times = {0};
      track.positions = {position};
      track.targets = {target};
    }
    check_up(*table, track);
    scene_.camera = track;
  }

  void read_light(const StageTable& table) {
    if (scene_.lights.size() == 64) throw InputError(table.where(), "[[light]]: more than 64 lights; the unit has 64");
    traces::Light light;
    const std::string kind = table.text("kind", "directional");
    const std::vector<std::string> kinds = {"point", "directional", "spot"};
    const auto it = std::find(kinds.begin(), kinds.end(), kind);
    if (it == kinds.end()) table.fail("kind", "\"" + kind + "\" is not a kind of light" + suggest(kind, kinds));
    light.kind = static_cast<traces::LightKind>(it - kinds.begin());
    if (light.kind != traces::LightKind::directional) light.position = to_vec3(table.required_vector("position"));
    if (light.kind != traces::LightKind::point) {
      const glm::dvec3 direction = table.required_vector("direction");
      if (!(glm::length(direction) > 0)) table.fail("direction", "must not be zero");
      light.direction = to_vec3(glm::normalize(direction));
    }
    const traces::Vec3 c = color(table, "color", {1, 1, 1});
    const auto intensity = static_cast<float>(table.number("intensity", 1, 0, 1e9));
    light.color = {c.x * intensity, c.y * intensity, c.z * intensity};
    light.range = static_cast<float>(table.number("range", 1e15, 1e-6, 1e15));
    const double outer = table.number("outer", 45, 0.1, 180), inner = table.number("inner", 0, 0, 179);
    if (inner > outer) table.fail("inner", "is over outer; inner is the angle of full light, outer that of none");
    light.cos_inner = static_cast<float>(std::cos(glm::radians(inner)));
    light.cos_outer =
        static_cast<float>(std::max(-1.0, std::min(std::cos(glm::radians(outer)), light.cos_inner - 1e-4)));
    scene_.lights.push_back(light);
  }

  std::string path_;
  std::vector<std::string>& log_;
  toml::table toml_;
  StageTable root_;
  LoadedScene scene_;
  std::map<std::string, Model> models_;      // by path: a file is read once
  std::map<std::string, int> texture_base_;  // by path
  std::map<std::string, int> nodes_;         // of the file at hand, by name; the first of equal names
  std::map<std::string, int> all_nodes_;
};

}  // namespace

LoadedScene load_stage(const std::string& path, std::vector<std::string>& log) { return StageReader(path, log).read(); }

}  // namespace artu::sim
