// What the simulation of one frame gives.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hw/fabric/sampler.h"
#include "hw/fabric/statistics.h"
#include "hw/pixel_record.h"
#include "sim/driver/fidelity.h"
#include "sim/driver/tree_quality.h"
#include "sim/driver/visit_histogram.h"
#include "traces/frame.h"

namespace artu::sim {

/// A figure that was not simulated to the end: it lies between `low` and `high` with 95 % confidence.
struct Estimate {
  std::string block;  // "" = of the frame: a name of `frame_numbers`, as "cycles" or "dram.read_bytes"
  std::string name, unit;
  double value = 0, low = 0, high = 0;
};

/// One frame as the unit rendered it.  What `fidelity` does not know is 0 here and absent from reports.
struct FrameOutcome {
  Fidelity fidelity = Fidelity::event;
  std::uint32_t index = 0;  // Frame::index
  std::uint32_t width = 0, height = 0;
  std::uint64_t cycles = 0;  // of the unit's clock, from start to the last write-back
  std::uint64_t static_triangles = 0, dynamic_triangles = 0;
  std::uint64_t rays_primary = 0, rays_shadow = 0, rays_reflection = 0, rays_refraction = 0;
  std::uint64_t node_visits = 0, triangle_tests = 0;
  std::uint64_t dram_read_bytes = 0, dram_write_bytes = 0;
  TreeQuality dynamic_tree;
  hw::PixelRecords pixels;     // row by row
  hw::Statistics statistics;   // all counters of all blocks, in a fixed order
  hw::FrameTimeline timeline;  // where it was asked for, as are the visits
  VisitHistogram visits;
  std::vector<Estimate> estimates;      // the intervals of those figures above that are estimates
  std::vector<std::string> violations;  // accounting laws that do not hold: must be empty
  double simulation_seconds = 0;        // the model alone; loading and tree builds are not in it
};

/// What the counters say, without cycles, pixels and wall time.
FrameOutcome outcome_of(const traces::Scene& scene, const traces::Frame& frame, hw::Statistics statistics);

}  // namespace artu::sim
