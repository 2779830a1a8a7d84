// Frames of a scene on a unit, with the fidelity that is asked for.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "hw/memory/dram.h"
#include "hw/run_mode.h"
#include "hw/unit_config.h"
#include "hw/watch/activity.h"
#include "hw/watch/request_sink.h"
#include "sim/driver/dynamic_trees.h"
#include "sim/driver/frame_outcome.h"
#include "sim/driver/static_trees.h"
#include "traces/frame.h"

namespace artu::sim {

/// How the model is run; only `fault` changes a pixel; `fidelity`, `random_stall` and `fault` change cycles.
struct SimulationOptions {
  Fidelity fidelity = Fidelity::event;
  bool random_stall = false;                // random extra latency on every channel
  bool shuffle_ticks = false;               // random order of blocks within each cycle
  std::uint64_t seed = 1;                   // of the two above
  std::vector<hw::LogRule> log;             // which blocks write to the log
  hw::LogSink log_sink;                     // where to; needed where there is a rule
  hw::Fault fault;                          // a datapath's result is falsified, to show that a check sees it
  bool timeline = false;                    // what happens when is recorded, and how many nodes rays visit
  hw::MemoryObserver memory_observer;       // told of every request that reaches the DRAM
  std::vector<hw::ActivitySink*> watchers;  // told what goes on in the window of every frame
  hw::ActivityWindow window;
  hw::RequestSink* request_sink = nullptr;  // told what the caches are asked for; not together with watchers
  StaticTrees* static_trees = nullptr;      // of the scene, where several simulators share them; must outlive them
};

/// The watchdog found that no token moves; what() is the picture of who waits for whom.  Exit code 3.
class DeadLock : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Frames can be run in any order with the same result.
class FrameSimulator {
 public:
  FrameSimulator() = default;
  FrameSimulator(const FrameSimulator&) = delete;
  FrameSimulator& operator=(const FrameSimulator&) = delete;
  virtual ~FrameSimulator() = default;
  virtual FrameOutcome run(const traces::Frame& frame) = 0;
};

/// `scene` must outlive the simulator.  Throws InputError where scene and unit do not fit together, or the options ask
/// for what the fidelity does not have.  With tree_builder.refit a frame may need another one's geometry, which it
/// gets from `frames`.
std::unique_ptr<FrameSimulator> make_simulator(const traces::Scene& scene, const hw::UnitConfig& unit,
                                               const SimulationOptions& options = {}, FrameFrom frames = {});

/// One line for an option that the fidelity cannot honour: throws InputError.
void check_options(const SimulationOptions& options);

}  // namespace artu::sim
