#include "sim/import/import.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "sim/import/load.h"
#include "sim/import/motion.h"
#include "sim/import/view.h"
#include "traces/error.h"
#include "traces/validate.h"

namespace artu::sim {
namespace {

constexpr std::size_t max_lights = 64;

template <typename T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same(const traces::Mesh& a, const traces::Mesh& b) {
  return same_bytes(a.positions, b.positions) && same_bytes(a.normals, b.normals) && same_bytes(a.indices, b.indices);
}

/// How many vertices and triangles the posed scene will have, before any is made.
void check_size(const Model& model, const std::string& path) {
  std::uint64_t vertices = 0, triangles = 0;
  for (const Node& node : model.nodes) {
    if (node.shape < 0 || !node.visible) continue;
    for (const Primitive& p : model.shapes[node.shape].primitives) {
      vertices += p.geometry->positions.size();
      triangles += p.geometry->triangle_count();
    }
    if (vertices > max_scene_elements || triangles > max_scene_elements)
      throw InputError(path, "has more than " + std::to_string(max_scene_elements) +
                                 " triangles or vertices once its instances are counted");
  }
}

}  // namespace

struct SceneSource::Impl {
  std::string path;
  ImportOptions options;
  LoadedScene loaded;
  traces::Scene scene;
  std::vector<char> dynamic;  // by node
  bool any_dynamic = false;
  CameraPlace default_place;
  int camera_node = -1;
  double exposure = 1;
  Surroundings surroundings;
  std::uint32_t natural_frames = 1;

  double time_of(std::uint32_t index) const { return index / options.fps; }

  traces::Mesh emit(const Pose& pose, bool want_dynamic) const {
    traces::Mesh mesh;
    const Model& model = loaded.model;
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
      if (model.nodes[n].shape < 0 || !model.nodes[n].visible || static_cast<bool>(dynamic[n]) != want_dynamic)
        continue;
      emit_node(model, pose, static_cast<int>(n), path, mesh);
    }
    return mesh;
  }

  /// What only stands still was emitted for good.
  void release_static_geometry() {
    Model& model = loaded.model;
    std::vector<char> needed(model.shapes.size(), 0);
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
      if (model.nodes[n].shape >= 0 && dynamic[n]) needed[static_cast<std::size_t>(model.nodes[n].shape)] = 1;
    }
    for (std::size_t s = 0; s < model.shapes.size(); ++s) {
      if (!needed[s]) model.shapes[s].primitives.clear();
    }
  }

  void count_frames() {
    double longest = loaded.duration;
    if (longest <= 0) {
      for (const Player& player : loaded.model.players) {
        if (player.speed != 0) longest = std::max(longest, player.clip.length / std::abs(player.speed));
      }
      if (loaded.camera) longest = std::max(longest, loaded.camera->length());
    }
    // A hair less, so that a length of exactly n frames in decimal notation is not n + 1.
    const double frames = std::ceil(longest * options.fps - 1e-3);
    natural_frames = static_cast<std::uint32_t>(std::clamp(frames, 1.0, 4.0e9));
  }

  WorldBox animated_extent(const WorldBox& at_rest) const {
    WorldBox box = at_rest;
    constexpr int samples = 12;
    for (int s = 1; any_dynamic && s < samples; ++s) {
      const double t = natural_frames * (s / static_cast<double>(samples)) / options.fps;
      grow(box, emit(pose_at(loaded.model, t), true));
    }
    return box;
  }

  void set_view(const Pose& pose, const WorldBox& rest, std::vector<std::string>& log) {
    const Model& model = loaded.model;
    bool lit = !loaded.lights.empty();
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
      if (!model.nodes[n].visible) continue;
      if (model.nodes[n].camera >= 0 && camera_node < 0) camera_node = static_cast<int>(n);
      if (model.nodes[n].light >= 0) lit = true;
    }
    if (loaded.camera_node >= 0) camera_node = loaded.camera_node;
    CameraPlace place;
    if (loaded.camera) {
      place = loaded.camera->at(0);
    } else if (camera_node >= 0) {
      place = camera_place(pose.world[camera_node]);
    } else {
      WorldBox box = animated_extent(rest);
      if (box.empty()) box.add({-1, -1, -1}), box.add({1, 1, 1});
      place = default_place = frame_box(box, CameraLens{}.fov, options.width, options.height);
      log.push_back(path + ": has no camera; one is placed that sees all of it");
    }
    exposure = light_exposure(model, pose, rest);
    if (exposure != 1)
      log.push_back(path + ": its lights are scaled by " + std::to_string(exposure) +
                    " so that the brightest gives an irradiance of 1 at the scene's centre");
    surroundings = default_surroundings(place, lit);
    if (!lit) log.push_back(path + ": has no light; a key light, a fill light and a sky are added");
    if (loaded.sky) {
      surroundings.ambient = loaded.sky->ambient;
      surroundings.sky_nadir = loaded.sky->nadir;
      surroundings.sky_zenith = loaded.sky->zenith;
    } else if (lit) {
      log.push_back(path + ": has lights and no sky; a dim sky is added");
    }
  }

  traces::Camera camera_at(const Pose& pose, double time) const {
    if (loaded.camera) return make_camera(loaded.camera->at(time), loaded.camera->lens, options.width, options.height);
    if (camera_node < 0) return make_camera(default_place, CameraLens{}, options.width, options.height);
    const CameraLens& lens = loaded.model.cameras[loaded.model.nodes[camera_node].camera];
    return make_camera(camera_place(pose.world[camera_node]), lens, options.width, options.height);
  }

  std::vector<traces::Light> lights_at(const Pose& pose) const {
    std::vector<traces::Light> lights = loaded.lights;
    lights.insert(lights.end(), surroundings.lights.begin(), surroundings.lights.end());
    for (std::size_t n = 0; n < loaded.model.nodes.size(); ++n) {
      const Node& node = loaded.model.nodes[n];
      if (node.light < 0 || !node.visible || lights.size() >= max_lights) continue;
      const auto light = make_light(loaded.model.lights[node.light], pose.world[n], exposure);
      if (light) lights.push_back(*light);
    }
    return lights;
  }

  void prepare(std::vector<std::string>& log) {
    Model& model = loaded.model;
    check_size(model, path);
    dynamic = dynamic_nodes(model);
    for (std::size_t n = 0; n < model.nodes.size(); ++n)
      any_dynamic = any_dynamic || (dynamic[n] && model.nodes[n].visible && model.nodes[n].shape >= 0);
    count_frames();
    const Pose pose = pose_at(model, 0);
    scene.static_geometry = emit(pose, false);
    release_static_geometry();
    scene.materials = std::move(model.materials);
    scene.textures = std::move(model.textures);
    scene.name = std::filesystem::path(path).filename().string();
    scene.generator = "artu import " + scene.name;
    scene.width = options.width;
    scene.height = options.height;
    scene.fps = options.fps;
    scene.frame_count = options.last_frame - options.first_frame;
    WorldBox box;
    grow(box, scene.static_geometry);
    const traces::Mesh moving = emit(pose, true);
    grow(box, moving);
    set_view(pose, box, log);
    const std::size_t lamps = static_cast<std::size_t>(
        std::count_if(model.nodes.begin(), model.nodes.end(), [](const Node& n) { return n.light >= 0 && n.visible; }));
    if (lamps + loaded.lights.size() > max_lights)
      log.push_back(path + ": has " + std::to_string(lamps + loaded.lights.size()) +
                    " lights; only the first 64 are used");
    if (scene.static_geometry.triangle_count() + moving.triangle_count() == 0)
      log.push_back(path + ": has no triangles");
    traces::validate(scene, path);
  }
};

SceneSource::SceneSource(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SceneSource::~SceneSource() = default;

std::unique_ptr<SceneSource> SceneSource::open(const std::string& path, const ImportOptions& options,
                                               std::vector<std::string>& log) {
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->options = options;
  if (impl->options.last_frame == 0) impl->options.last_frame = options.first_frame + 1;
  if (impl->options.last_frame <= options.first_frame)
    throw InputError("frames", std::to_string(options.first_frame) + ":" + std::to_string(options.last_frame) +
                                   " is empty; the range A:B means frames A ... B - 1");
  if (!(options.fps > 0 && options.fps <= 1e6))
    throw InputError("fps", "is " + std::to_string(options.fps) + "; it must be above 0 and at most 1000000");
  if (options.width < 1 || options.width > 16384 || options.height < 1 || options.height > 16384)
    throw InputError("size", std::to_string(options.width) + " x " + std::to_string(options.height) +
                                 " pixels; 1 ... 16384 each way is allowed");
  impl->loaded = load_scene(path, log);
  impl->prepare(log);
  return std::unique_ptr<SceneSource>(new SceneSource(std::move(impl)));
}

const traces::Scene& SceneSource::scene() const { return impl_->scene; }

std::uint32_t SceneSource::natural_frame_count() const { return impl_->natural_frames; }

traces::Frame SceneSource::frame(std::uint32_t index) const {
  const Impl& impl = *impl_;
  traces::Frame frame;
  frame.index = index;
  frame.time = impl.time_of(index);
  const Pose pose = pose_at(impl.loaded.model, frame.time);
  frame.camera = impl.camera_at(pose, frame.time);
  frame.lights = impl.lights_at(pose);
  frame.ambient = impl.surroundings.ambient;
  frame.sky_nadir = impl.surroundings.sky_nadir;
  frame.sky_zenith = impl.surroundings.sky_zenith;
  frame.dynamic = impl.emit(pose, true);
  if (index > 0) {
    const Pose before = pose_at(impl.loaded.model, impl.time_of(index - 1));
    // Equal inputs make equal triangles; only where they differ is the mesh worth making twice.
    const bool still = before.world == pose.world && before.weights == pose.weights;
    frame.dynamic_moved = !impl.any_dynamic ? false : !still && !same(frame.dynamic, impl.emit(before, true));
  }
  traces::validate(impl.scene, frame, impl.path + ": frame " + std::to_string(index));
  return frame;
}

}  // namespace artu::sim
