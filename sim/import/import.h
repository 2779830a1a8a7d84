// Scenes in: a glTF, OBJ or stage file becomes a traces::Scene and one traces::Frame per time step.
//
// Everything the unit cannot do (node hierarchies, skins, morph targets, clips) is resolved here, on the host, so
// that a frame is plain world-space triangles.  docs/scenes.md says what is read and how it is mapped.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "traces/frame.h"

namespace artu::sim {

struct ImportOptions {
  std::uint32_t width = 640, height = 360;        // pixels
  std::uint32_t first_frame = 0, last_frame = 0;  // frames first ... last - 1; last == 0: first alone
  double fps = 30;                                // frames per second of animation time
};

/// A scene that has been loaded and can be posed at any frame.  Files: .glb, .gltf, .obj, .stage.toml.
class SceneSource {
 public:
  /// Throws InputError.  What was left out, approximated or added is appended to `log`, one line each.
  static std::unique_ptr<SceneSource> open(const std::string& path, const ImportOptions& options,
                                           std::vector<std::string>& log);
  ~SceneSource();

  /// Static geometry, materials, textures; `frame_count` is the length of the range in the options.
  const traces::Scene& scene() const;
  /// The pose at time `index / fps`, for any index (the options' range is not a limit).
  traces::Frame frame(std::uint32_t index) const;
  /// Frames until the longest animation repeats; at least 1.
  std::uint32_t natural_frame_count() const;

 private:
  struct Impl;
  explicit SceneSource(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace artu::sim
