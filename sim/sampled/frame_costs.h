// What a frame is likely to cost: what its tree's build computes, and all rays of a picture with an eighth of its width
// and height, without time.
//
// It need not be right: it must go up and down with the cycles.  The same pixels are looked at in every frame; of
// frames that are equal, all but for their place in the sequence, only the first.  With refit none is known to be
// equal: a tree depends on the frames before it.
#pragma once

#include <memory>

#include "sim/driver/frame_simulator.h"
#include "sim/sampled/frame_sample.h"

namespace artu::sim {

class FrameCosts {
 public:
  static constexpr std::uint32_t reduction = 8;

  /// As make_simulator.
  FrameCosts(const traces::Scene& scene, const hw::UnitConfig& unit, const SimulationOptions& options,
             FrameFrom frames = {});
  ~FrameCosts();

  struct Look {
    FrameCost cost;      // the build; and nodes and triangles, a little for each ray and pixel
    double seconds = 0;  // wall time, without tree builds
  };
  Look at(traces::Frame frame);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace artu::sim
