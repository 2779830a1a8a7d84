#include "sim/sweep/scenes.h"

namespace artu::sim {

SweepScene& SweepScenes::of(std::size_t scene) {
  std::unique_ptr<SweepScene>& loaded = loaded_[scene];
  if (!loaded) {
    std::vector<std::string> notes;
    loaded = std::make_unique<SweepScene>(scenes_[scene], notes);
    if (noted_.insert(scene).second) log_.insert(log_.end(), notes.begin(), notes.end());
  }
  return *loaded;
}

}  // namespace artu::sim
