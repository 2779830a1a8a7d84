// What a run leaves on disk: the folder and the CSV, each complete or absent.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "sim/command/frame_source.h"
#include "sim/command/options.h"
#include "sim/compare/frame_compare.h"
#include "sim/report/file.h"
#include "sim/report/manifest.h"
#include "sim/report/picture_set.h"
#include "sim/report/run_folder.h"
#include "sim/report/stats_json.h"

namespace artu::sim {

/// What was run, apart from how.
Manifest manifest_of(const std::vector<std::string>& command, const std::string& input, const FrameSource& source);

/// "FILE, 640x360, frame 0"
std::string heading(const std::string& input, const FrameSource& source);

class RunReport {
 public:
  /// Refuses what exists, before anything slow begins.
  explicit RunReport(const RunOptions& options);
  /// Before the first frame.
  void begin_pictures(std::uint32_t frames, double fps);
  /// Whether add() must be given the full render.
  bool needs_full() const { return folder_ && set_.needs_full(); }
  void add(const FrameOutcome& outcome, const Totals& frame, const hw::UnitConfig& unit, const FullRender* full);
  /// For the simulator whose frames are added; must not outlive the report.
  hw::MemoryObserver memory_observer() { return memory_trace_ ? memory_trace_->observer() : hw::MemoryObserver{}; }
  void finish(const Totals& sum, const hw::UnitConfig& unit, const Manifest& manifest, const CheckResult* check);
  /// "" where none was asked for.
  std::string folder() const { return folder_ ? folder_->name() : ""; }

 private:
  std::optional<RunFolder> folder_;
  std::unique_ptr<AtomicFile> csv_;
  std::unique_ptr<MemoryTrace> memory_trace_;
  std::unique_ptr<StatsJson> json_;
  PictureSet set_;
  std::optional<PictureWriter> pictures_;
};

}  // namespace artu::sim
