// `functional`: the picture and the counts, without time.
#pragma once

#include <memory>

#include "sim/driver/frame_simulator.h"

namespace artu::sim {

class FunctionalSimulator : public FrameSimulator {
 public:
  /// As make_simulator.  `portable`: without SSE2; the same bits.
  FunctionalSimulator(const traces::Scene& scene, const hw::UnitConfig& unit, const SimulationOptions& options,
                      FrameFrom frames, bool portable = false);
  ~FunctionalSimulator() override;
  FrameOutcome run(const traces::Frame& frame) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace artu::sim
