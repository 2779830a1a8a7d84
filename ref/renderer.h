// One frame's pixels: rays, shading, accumulation (docs/arithmetic.md section 7).
#pragma once

#include <cstdint>
#include <memory>

#include "ref/geometry.h"
#include "ref/golden.h"

namespace artu::ref {

/// A renderer of `settings.precision.shading`.
class Renderer {
 public:
  /// All references must outlive the renderer; the geometry is that of the scene and the frame, its tests those of
  /// `settings`.  `emulate` computes 23 bits by way of binary64 as well, for tests.
  static std::unique_ptr<Renderer> make(const traces::Scene& scene, const traces::Frame& frame,
                                        const Settings& settings, const Geometry& geometry, bool emulate = false);
  virtual ~Renderer() = default;

  /// Ray traces a pixel: sets its colour, hit class, primitive and t.
  virtual void trace(std::uint32_t x, std::uint32_t y, Pixel& pixel) = 0;
  const RayCounts& rays() const { return rays_; }

 protected:
  RayCounts rays_;
};

}  // namespace artu::ref
