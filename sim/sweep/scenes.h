// The scenes of a sweep, each loaded once and kept as long as a point needs it.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "sim/command/frame_source.h"
#include "sim/driver/static_trees.h"
#include "sim/report/memory_use.h"

namespace artu::sim {

struct SweepScene {
  SweepScene(const SourceOptions& options, std::vector<std::string>& log)
      : source(options, log), trees(source.scene()) {}
  MemoryMeter memory;  // from before the scene was loaded
  FrameSource source;
  StaticTrees trees;
};

class SweepScenes {
 public:
  explicit SweepScenes(const std::vector<SourceOptions>& scenes) : scenes_(scenes) {}
  /// Loads it if it is not there.
  SweepScene& of(std::size_t scene);
  void release(std::size_t scene) { loaded_.erase(scene); }
  /// The importer's notes on all that were loaded.
  const std::vector<std::string>& log() const { return log_; }

 private:
  const std::vector<SourceOptions>& scenes_;
  std::map<std::size_t, std::unique_ptr<SweepScene>> loaded_;
  std::set<std::size_t> noted_;
  std::vector<std::string> log_;
};

}  // namespace artu::sim
