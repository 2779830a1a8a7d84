// timeline.json: each frame from cycle to cycle (docs/report.md has the format), written frame by frame.
#pragma once

#include <string>

#include "sim/driver/frame_outcome.h"
#include "sim/report/file.h"

namespace artu::sim {

/// One object of "frames", without a line end.
std::string timeline_of(const FrameOutcome& outcome);

class TimelineJson {
 public:
  static constexpr int schema = 1;

  explicit TimelineJson(const std::string& file);
  /// What timeline_of has returned, frame after frame.
  void add(const std::string& frame);
  void finish();

 private:
  OutputFile file_;
  bool first_ = true;
};

}  // namespace artu::sim
