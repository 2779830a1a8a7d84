// What a frame would look like without the unit's rounding and without selective rendering.
//
// The golden model's steps (docs/arithmetic.md sections 2 to 8), each in binary64 from the camera to the code of the
// colour, every pixel ray traced.  What narrow datapaths and interpolation cost is measured against this.
#pragma once

#include <memory>

#include "ref/golden.h"

namespace artu::ref {

/// Vertices, lights and materials are the trace's, whose binary32 is exact here.  Secondary rays begin off the surface
/// by section 11 with the rounding of binary64: m * 2^-48 + L * 2^-48.  Of hits on a ray the smaller t wins, then the
/// smaller id.  A picture of it is no contract: on another machine's library a pixel at a threshold may differ.
class Binary64 {
 public:
  /// `scene` must outlive it; it and the frames are taken as `traces::validate` leaves them.  Depth and smallest
  /// weight of reflection and refraction rays are those of Settings.
  explicit Binary64(const traces::Scene& scene, unsigned max_depth = Settings().max_depth,
                    float min_weight = Settings().min_weight);
  ~Binary64();
  /// Of the pixels: colour, class, primitive and (rounded) t.  Frames may come in any order.  Not for two threads at a
  /// time.
  Result render(const traces::Frame& frame) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace artu::ref
