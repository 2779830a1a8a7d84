#include "sim/command/frame_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "sim/import/files_read.h"
#include "sim/report/digest.h"
#include "sim/report/file.h"
#include "traces/error.h"

namespace artu::sim {

void require_file(const std::string& path) {
  std::error_code error;
  const bool exists = std::filesystem::exists(path, error);
  if (error) {
    throw InputError(path, fmt::format("cannot be read: {}; a scene (.glb, .gltf, .obj, .stage.toml) or a trace would "
                                       "be right",
                                       error.message()));
  }
  if (!exists) {
    throw InputError(path, "no such file; a scene (.glb, .gltf, .obj, .stage.toml) or a trace would be right");
  }
  if (std::filesystem::is_directory(path, error)) {
    throw InputError(path, "is a folder; a scene (.glb, .gltf, .obj, .stage.toml) or a trace would be right");
  }
  refuse_irregular(path);
}

FrameSource::FrameSource(const SourceOptions& options, std::vector<std::string>& log) : path_(options.path) {
  require_file(path_);
  if (traces::is_trace(path_)) {
    open_trace(options);
  } else {
    open_scene(options, log);
  }
}

void FrameSource::open_trace(const SourceOptions& options) {
  if (options.size) throw InputError("--size", "a trace has its own size; without --size, or a scene, would be right");
  if (options.fps) throw InputError("--fps", "a trace has its own rate; without --fps, or a scene, would be right");
  reader_ = std::make_unique<traces::Reader>(path_);
  const std::uint32_t count = reader_->scene().frame_count;
  if (count == 0) throw InputError(path_, "holds no frame; a trace with frames would be right");
  first_index_ = reader_->frame(0).index;
  const std::uint32_t last = (count == 1 ? first_index_ : reader_->frame(count - 1).index) + 1;
  if (!options.frames) {
    range_ = {first_index_, first_index_ + 1};
    return;
  }
  range_ = parse_frames(*options.frames).value_or(FrameRange{first_index_, last});
  if (range_.first < first_index_ || range_.last > last) {
    throw InputError("--frames",
                     fmt::format("{} is not in {}; it holds frames {}:{}", *options.frames, path_, first_index_, last));
  }
}

void FrameSource::open_scene(const SourceOptions& options, std::vector<std::string>& log) {
  const PictureSize size = options.size ? parse_size(*options.size) : PictureSize{};
  ImportOptions import;
  import.width = size.width;
  import.height = size.height;
  if (options.fps) import.fps = *options.fps;
  check_fps(import.fps);
  const auto asked = options.frames ? parse_frames(*options.frames) : FrameRange{};
  range_ = asked.value_or(FrameRange{});
  const FilesRead files;
  import.first_frame = range_.first;
  import.last_frame = range_.last;
  scene_ = SceneSource::open(path_, import, log);
  files_ = files.paths();
  if (asked) return;
  // "all": how many there are is known only now, and what counts as moving may depend on the range.
  range_.last = import.last_frame = scene_->natural_frame_count();
  if (range_.last == 1) return;
  log.clear();
  scene_ = SceneSource::open(path_, import, log);
}

std::string FrameSource::sha256() const { return sha256_of_files(path_, files_); }

std::string sha256_of_input(const std::string& path) {
  if (traces::is_trace(path)) return sha256_of_file(path);
  const FilesRead files;
  std::vector<std::string> log;
  SceneSource::open(path, {}, log);
  return sha256_of_files(path, files.paths());
}

const traces::Scene& FrameSource::scene() const { return reader_ ? reader_->scene() : scene_->scene(); }

traces::Frame FrameSource::frame(std::uint32_t index) const {
  if (scene_) return scene_->frame(index);
  const std::uint32_t count = reader_->scene().frame_count;
  if (index - first_index_ < count) {
    traces::Frame frame = reader_->frame(index - first_index_);
    if (frame.index == index) return frame;
  }
  for (std::uint32_t position = 0; position < count; ++position) {  // a trace that leaves frames out
    traces::Frame frame = reader_->frame(position);
    if (frame.index == index) return frame;
  }
  throw InputError(path_, fmt::format("has no frame {}; --frames with one that it holds would be right", index));
}

traces::Frame FrameSource::first_from(std::uint32_t index) const {
  if (scene_) return scene_->frame(index);
  const std::uint32_t count = reader_->scene().frame_count, place = std::max(index, first_index_) - first_index_;
  if (place < count) {
    traces::Frame frame = reader_->frame(place);
    if (frame.index == std::max(index, first_index_)) return frame;
  }
  std::optional<traces::Frame> first;  // in a trace that leaves frames out
  for (std::uint32_t position = 0; position < count; ++position) {
    traces::Frame frame = reader_->frame(position);
    if (frame.index >= index && (!first || frame.index < first->index)) first = std::move(frame);
  }
  if (!first) throw InputError(path_, fmt::format("has no frame {} or later", index));
  return *first;
}

}  // namespace artu::sim
