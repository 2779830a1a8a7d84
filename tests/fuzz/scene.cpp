#include "fuzz/scene.h"

#include "fuzz/harness.h"
#include "sim/import/import.h"
#include "traces/validate.h"

namespace artu::fuzz {

void import_scene(const std::string& path) {
  read_or_refuse([&] {
    sim::ImportOptions options;
    options.width = options.height = 8;
    options.last_frame = 2;
    std::vector<std::string> log;
    const auto source = sim::SceneSource::open(path, options, log);
    require(source->natural_frame_count() >= 1, "a scene of at least one frame");
    traces::validate(source->scene(), path);
    for (const std::uint32_t frame : {0u, 17u}) traces::validate(source->scene(), source->frame(frame), path);
  });
}

}  // namespace artu::fuzz
