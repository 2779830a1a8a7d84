#include "sim/sweep/scenes.h"

namespace artu::sim {

LoadedScene& SweepScenes::of(std::size_t scene) {
  std::unique_ptr<LoadedScene>& loaded = loaded_[scene];
  if (!loaded) {
    std::vector<std::string> notes;
    loaded = std::make_unique<LoadedScene>(scenes_[scene], notes);
    if (noted_.insert(scene).second) log_.insert(log_.end(), notes.begin(), notes.end());
  }
  return *loaded;
}

}  // namespace artu::sim
