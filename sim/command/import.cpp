#include <fmt/format.h>

#include "sim/command/commands.h"
#include "sim/command/frame_source.h"
#include "sim/command/output_places.h"
#include "sim/command/progress.h"
#include "sim/report/file.h"
#include "sim/report/interruption.h"
#include "traces/error.h"

namespace artu::sim {
namespace {

/// Returns how many triangles move, in the frame with the most.
std::size_t write_frames(const FrameSource& source, const traces::Scene& scene, const ImportOptionsOfCommand& options) {
  const RemoveOnInterrupt guard(options.output + ".partial");
  traces::Writer writer(options.output, scene);
  Progress progress(source.range().count(), "frames", options.quiet);
  std::size_t dynamic = 0;
  for (std::uint32_t index = source.range().first; index < source.range().last; ++index) {
    const traces::Frame frame = source.frame(index);
    dynamic = std::max(dynamic, frame.dynamic.triangle_count());
    writer.add(frame);
    progress.one_done();
  }
  writer.close();
  return dynamic;
}

}  // namespace

void print_notes(const std::vector<std::string>& notes, bool quiet) {
  if (quiet) return;
  for (const std::string& note : notes) fmt::print(stderr, "note: {}\n", note);
}

int import_command(const ImportOptionsOfCommand& options) {
  require_file(options.source.path);
  if (traces::is_trace(options.source.path)) {
    throw InputError(options.source.path,
                     "is a trace already; a scene (.glb, .gltf, .obj, .stage.toml) would be right");
  }
  refuse_input_as_output(options.output, options.source.path);
  refuse_existing(options.output, options.force);
  std::vector<std::string> log;
  const FrameSource source(options.source, log);
  const traces::Scene& scene = source.scene();
  std::size_t dynamic = 0;
  if (scene.frame_count == source.range().count()) {
    dynamic = write_frames(source, scene, options);
  } else {
    traces::Scene counted = scene;
    counted.frame_count = source.range().count();
    dynamic = write_frames(source, counted, options);
  }
  print_notes(log, options.quiet);
  if (!options.quiet) {
    fmt::print("{}: {}x{}, frames {}:{}, {} static and up to {} dynamic triangles\n", options.output, scene.width,
               scene.height, source.range().first, source.range().last, scene.static_geometry.triangle_count(),
               dynamic);
  }
  return exit_fine;
}

}  // namespace artu::sim
