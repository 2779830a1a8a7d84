// `analytic`: a functional rendering that is listened to, and the cycles that its demand comes to.
#pragma once

#include <memory>

#include "sim/driver/frame_simulator.h"

namespace artu::sim {

class AnalyticSimulator : public FrameSimulator {
 public:
  /// As make_simulator.
  AnalyticSimulator(const traces::Scene& scene, const hw::UnitConfig& unit, const SimulationOptions& options,
                    FrameFrom frames);
  ~AnalyticSimulator() override;
  FrameOutcome run(const traces::Frame& frame) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace artu::sim
