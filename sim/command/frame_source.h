// The frames of a run: from a trace, or straight from a scene through the importer.
#pragma once

#include <memory>
#include <set>
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
  /// Of all files that it is made of (sim/report/digest.h).
  std::string sha256() const;

 private:
  void open_trace(const SourceOptions& options);
  void open_scene(const SourceOptions& options, std::vector<std::string>& log);

  std::string path_;
  std::unique_ptr<traces::Reader> reader_;
  std::unique_ptr<SceneSource> scene_;
  FrameRange range_;
  std::set<std::string> files_;    // that a scene has read
  std::uint32_t first_index_ = 0;  // of a trace's first frame
};

/// FrameSource::sha256() of the file, which is read for it.
std::string sha256_of_input(const std::string& path);

/// Throws InputError unless the path names a file.
void require_file(const std::string& path);

}  // namespace artu::sim
