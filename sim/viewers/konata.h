// A trace for Konata, the pipeline viewer, in the Kanata log format 0004 (docs/viewers.md): a ray a line, its stages
// along the cycles.
// Source: docs/kanata-log-format.md of the Konata project.
#pragma once

#include <map>
#include <vector>

#include "sim/viewers/trace_writer.h"

namespace artu::sim {

class KonataTrace : public TraceWriter {
 public:
  using TraceWriter::TraceWriter;

  void begin(const hw::ActivityLayout& layout, hw::Tick tick) override;
  void ray_begins(hw::Tick tick, const hw::RayInFlight& ray) override;
  void ray_enters(hw::Tick tick, const hw::RayInFlight& ray, hw::RayStage stage) override;
  void ray_ends(hw::Tick tick, const hw::RayInFlight& ray, bool cut) override;
  void end(hw::Tick tick) override;

 private:
  struct Line {
    std::uint64_t id = 0;  // in the file
    hw::RayStage stage = hw::RayStage::set_up;
    bool begun = false;
  };
  void advance(hw::Tick tick);
  void flush();

  hw::Tick unit_period_ = 1, begin_ = 0;
  hw::Cycle cycle_ = 0;
  std::uint64_t ids_ = 0, retired_ = 0;
  std::map<std::uint64_t, Line> lines_;             // of rays in flight, by number
  std::map<std::uint64_t, std::uint64_t> parents_;  // of rays that have ended in this cycle: number and id
  std::string text_;
};

}  // namespace artu::sim
