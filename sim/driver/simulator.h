// The driver: a trace's scene and frames -> memory image and trees -> the unit -> what came out.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "hw/ray_tracing_unit.h"
#include "hw/run_mode.h"
#include "hw/unit_config.h"
#include "sim/driver/dynamic_trees.h"
#include "sim/driver/tree_quality.h"
#include "traces/frame.h"

namespace artu::sim {

/// How the model is run; only `fault` changes a pixel, only `random_stall` and `fault` change cycles.
struct SimulationOptions {
  bool clocked = false;                // tick every block in every cycle, not only those that are awake
  bool random_stall = false;           // random extra latency on every channel
  bool shuffle_ticks = false;          // random order of blocks within each cycle
  std::uint64_t seed = 1;              // of the two above
  std::vector<hw::LogRule> log;        // which blocks write to the log
  hw::LogSink log_sink;                // where to; needed where there is a rule
  hw::Fault fault;                     // a datapath's result is falsified, to show that a check sees it
  hw::MemoryObserver memory_observer;  // told of every request that reaches the DRAM
};

/// One frame as the unit rendered it.
struct FrameOutcome {
  std::uint32_t index = 0;  // Frame::index
  std::uint32_t width = 0, height = 0;
  std::uint64_t cycles = 0;  // of the unit's clock, from start to the last write-back
  std::uint64_t static_triangles = 0, dynamic_triangles = 0;
  std::uint64_t rays_primary = 0, rays_shadow = 0, rays_reflection = 0, rays_refraction = 0;
  std::uint64_t node_visits = 0, triangle_tests = 0;
  std::uint64_t dram_read_bytes = 0, dram_write_bytes = 0;
  TreeQuality dynamic_tree;
  hw::PixelRecords pixels;              // row by row
  hw::Statistics statistics;            // all counters of all blocks, in a fixed order
  std::vector<std::string> violations;  // accounting laws that do not hold: must be empty
  double simulation_seconds = 0;        // the unit alone; loading and tree builds are not in it
};

/// What the host takes from the unit's result; without pixels and wall time.
FrameOutcome outcome_of(const traces::Scene& scene, const traces::Frame& frame, hw::FrameResult result);

/// The watchdog found that no token moves; what() is the picture of who waits for whom.  Exit code 3.
class DeadLock : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One unit, elaborated once; frames can be run in any order with the same result.
class Simulator {
 public:
  /// `scene` must outlive the simulator.  Throws InputError where scene and unit do not fit together.  With
  /// tree_builder.refit a frame may need another one's geometry, which it gets from `frames`.
  Simulator(const traces::Scene& scene, const hw::UnitConfig& config, const SimulationOptions& options,
            FrameFrom frames = {});
  ~Simulator();
  FrameOutcome run(const traces::Frame& frame);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace artu::sim
