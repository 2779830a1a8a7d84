// What a run leaves on disk: the folder and the CSV, each complete or absent.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/command/frame_source.h"
#include "sim/command/options.h"
#include "sim/compare/frame_compare.h"
#include "sim/jobs/results.h"
#include "sim/report/file.h"
#include "sim/report/manifest.h"
#include "sim/report/picture_set.h"
#include "sim/report/run_folder.h"
#include "sim/report/stats_json.h"
#include "sim/report/timeline_json.h"
#include "sim/viewers/trace_set.h"

namespace artu::sim {

/// What was run, apart from how.
Manifest manifest_of(const std::vector<std::string>& command, const std::string& input, const FrameSource& source);

/// "FILE, 640x360, frame 0"
std::string heading(const std::string& input, const FrameSource& source);

/// What a frame leaves, ready to be written.
struct FrameReport {
  std::uint32_t index = 0;
  std::uint64_t dram_clocks = 0;
  Totals totals;
  std::vector<std::string> violations;
  CheckResult check;      // where the golden model is asked
  std::string pixel_csv;  // rows; "" in the process that writes the file, which has done so already
  std::string animation;  // PictureWriter's part
  std::string timeline;   // of timeline.json; "" where nobody asks
};

template <class A>
void transfer(A& archive, FrameReport& r) {
  pass_all(archive, r.index, r.dram_clocks, r.totals, r.violations, r.check, r.pixel_csv, r.animation, r.timeline);
}

class RunReport {
 public:
  /// Refuses what exists, before anything slow begins.
  explicit RunReport(const RunOptions& options);
  /// Before the first frame.
  void begin_pictures(std::uint32_t frames, double fps);
  /// Whether add() must be given the full render.
  bool needs_full() const { return folder_ && set_.needs_full(); }
  /// Writes the frame's pictures; the rest of the report is in what it returns.  Any process may call it.
  FrameReport write(const FrameOutcome& outcome, const hw::UnitConfig& unit, const FullRender* full);
  /// Frame after frame, in the process that made the report.
  void add(const FrameReport& frame, const hw::UnitConfig& unit);
  /// For the simulator whose frames are added; must not outlive the report.
  hw::MemoryObserver memory_observer() { return memory_trace_ ? memory_trace_->observer() : hw::MemoryObserver{}; }
  /// The same.
  std::vector<hw::ActivitySink*> watchers() const { return traces_.sinks(); }
  /// What --trace has written, for the summary; after finish().
  const TraceSet& traces() const { return traces_; }
  void finish(const Totals& sum, const hw::UnitConfig& unit, const Manifest& manifest, const CheckResult* check);
  /// "" where none was asked for.
  std::string folder() const { return folder_ ? folder_->name() : ""; }

 private:
  void open_traces(const RunOptions& options);

  std::optional<RunFolder> folder_;
  std::unique_ptr<AtomicFile> csv_;
  const bool several_processes_;
  std::unique_ptr<MemoryTrace> memory_trace_;
  TraceSet traces_;
  std::unique_ptr<StatsJson> json_;
  std::unique_ptr<TimelineJson> timeline_;
  PictureSet set_;
  std::optional<PictureWriter> pictures_;
};

}  // namespace artu::sim
