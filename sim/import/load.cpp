#include "sim/import/load.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "sim/import/gltf_import.h"
#include "sim/import/obj_file.h"
#include "sim/import/stage.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

bool ends_with(const std::string& path, const std::string& ending) {
  if (path.size() < ending.size()) return false;
  return std::equal(ending.rbegin(), ending.rend(), path.rbegin(),
                    [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

/// The first clip, and each later one that moves only nodes that none before it does: some exporters write one clip an
/// object, others one clip an action of the same object, of which only one can play.
void play_default_clips(Model& model, const std::string& path, std::vector<std::string>& log) {
  std::set<int> taken;
  for (const Clip& clip : model.clips) {
    const bool free = std::none_of(clip.channels.begin(), clip.channels.end(),
                                   [&](const Channel& c) { return taken.count(c.node) != 0; });
    if (!free || clip.channels.empty()) continue;
    for (const Channel& channel : clip.channels) taken.insert(channel.node);
    model.players.push_back({clip});
  }
  if (model.clips.size() < 2 || model.players.empty()) return;
  // They start again together, or clips of one animation would drift apart.
  double longest = 0;
  for (const Player& player : model.players) longest = std::max(longest, player.clip.length);
  for (Player& player : model.players) player.clip.length = longest;
  const std::string all = std::to_string(model.clips.size());
  if (model.players.size() == 1) {
    log.push_back(path + ": has " + all + " clips; the first, \"" + model.players.front().clip.name + "\", plays" +
                  choice_note);
  } else {
    log.push_back(path + ": has " + all + " clips; " + std::to_string(model.players.size()) +
                  " that move different nodes play together" + choice_note);
  }
}

}  // namespace

Model load_model(const std::string& path, std::vector<std::string>& log) {
  if (ends_with(path, ".glb") || ends_with(path, ".gltf")) {
    Model model = import_gltf(path, log);
    play_default_clips(model, path, log);
    return model;
  }
  if (ends_with(path, ".obj")) return import_obj(path, log);
  throw InputError(path, "is not a model that can be read; .glb, .gltf and .obj can");
}

LoadedScene load_scene(const std::string& path, std::vector<std::string>& log) {
  if (ends_with(path, ".stage.toml")) return load_stage(path, log);
  if (ends_with(path, ".toml")) throw InputError(path, "is not a scene: a stage's name ends in .stage.toml");
  LoadedScene scene;
  scene.model = load_model(path, log);
  return scene;
}

CameraPlace CameraTrack::at(double time) const {
  if (times.size() == 1) return look_at(positions[0], targets[0], up);
  const double t = clip_time(time, length(), loop);
  const auto after = std::upper_bound(times.begin(), times.end(), t);
  const std::size_t next = static_cast<std::size_t>(after - times.begin());
  if (next == 0) return look_at(positions[0], targets[0], up);
  if (next == times.size()) return look_at(positions.back(), targets.back(), up);
  // Catmull-Rom with the keys' own times: passes through the keys without a jerk.
  const std::size_t last = next - 1;
  const double span = times[next] - times[last], s = (t - times[last]) / span;
  const bool closed = loop && positions.front() == positions.back() && targets.front() == targets.back();
  const auto slope = [&](const std::vector<glm::dvec3>& v, std::size_t k) {
    const std::size_t n = times.size();
    if (k > 0 && k + 1 < n) return (v[k + 1] - v[k - 1]) / (times[k + 1] - times[k - 1]);
    if (closed) return (v[1] - v[n - 2]) / (times[1] - times[0] + times[n - 1] - times[n - 2]);
    return k == 0 ? (v[1] - v[0]) / (times[1] - times[0]) : (v[n - 1] - v[n - 2]) / (times[n - 1] - times[n - 2]);
  };
  const auto value = [&](const std::vector<glm::dvec3>& v) {
    const double s2 = s * s, s3 = s2 * s;
    return (2 * s3 - 3 * s2 + 1) * v[last] + (s3 - 2 * s2 + s) * span * slope(v, last) + (3 * s2 - 2 * s3) * v[next] +
           (s3 - s2) * span * slope(v, next);
  };
  return look_at(value(positions), value(targets), up);
}

}  // namespace artu::sim
