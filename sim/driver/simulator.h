// The driver: a trace's scene and frames -> memory image and trees -> the unit, cycle by cycle -> what came out.
#pragma once

#include "hw/ray_tracing_unit.h"
#include "sim/driver/frame_simulator.h"

namespace artu::sim {

/// What the host takes from the unit's result; without pixels and wall time.
FrameOutcome outcome_of(const traces::Scene& scene, const traces::Frame& frame, hw::FrameResult result);

/// One unit in SystemC, elaborated once: `event` and `clocked`.
class Simulator : public FrameSimulator {
 public:
  /// As make_simulator.
  Simulator(const traces::Scene& scene, const hw::UnitConfig& config, const SimulationOptions& options,
            FrameFrom frames = {});
  ~Simulator() override;
  FrameOutcome run(const traces::Frame& frame) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace artu::sim
