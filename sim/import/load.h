// Any scene file, loaded: a Model that plays, and what a stage adds around it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/import/view.h"

namespace artu::sim {

/// A stage's camera: fixed, or moving along keys (a smooth curve through them).
struct CameraTrack {
  CameraLens lens;
  glm::dvec3 up{0, 1, 0};
  bool loop = true;
  std::vector<double> times;  // at least one
  std::vector<glm::dvec3> positions, targets;

  double length() const { return times.back(); }
  CameraPlace at(double time) const;
};

struct Sky {
  traces::Vec3 zenith, nadir, ambient;
};

struct LoadedScene {
  Model model;
  std::optional<CameraTrack> camera;  // before any camera of a file
  int camera_node = -1;               // a node of the model that the stage chose
  std::vector<traces::Light> lights;  // of the stage, as bright as they say
  std::optional<Sky> sky;
  double duration = 0;  // seconds; 0: as long as the longest player
};

/// By the file's ending.  Throws InputError.
LoadedScene load_scene(const std::string& path, std::vector<std::string>& log);

/// Ends the log line on which clip plays, which is no news where a stage has chosen.
inline constexpr char choice_note[] = " (a stage can choose)";

/// A model file (not a stage); its default clips play.
Model load_model(const std::string& path, std::vector<std::string>& log);

}  // namespace artu::sim
