// The frames of a run: from a trace, or straight from a scene through the importer.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/command/options.h"
#include "sim/command/ranges.h"
#include "sim/import/import.h"
#include "traces/trace.h"

namespace artu::sim {

class FrameSource {
 public:
  /// Checks every option against the file.  Notes of the importer go to `log`.
  FrameSource(const SourceOptions& options, std::vector<std::string>& log);
  const traces::Scene& scene() const;
  traces::Frame frame(std::uint32_t index) const;       // any index of range()
  traces::Frame first_from(std::uint32_t index) const;  // the frame of any index, or a trace's next one after it
  FrameRange range() const { return range_; }
  bool is_trace() const { return reader_ != nullptr; }

 private:
  void open_trace(const SourceOptions& options);
  void open_scene(const SourceOptions& options, std::vector<std::string>& log);

  std::string path_;
  std::unique_ptr<traces::Reader> reader_;
  std::unique_ptr<SceneSource> scene_;
  FrameRange range_;
  std::uint32_t first_index_ = 0;  // of a trace's first frame
};

/// Throws InputError unless the path names a file.
void require_file(const std::string& path);

}  // namespace artu::sim
