// One frame's pixels: rays, shading, accumulation (docs/arithmetic.md section 7).
#pragma once

#include <cstdint>
#include <vector>

#include "ref/geometry.h"
#include "ref/golden.h"
#include "ref/hit_point.h"

namespace artu::ref {

class Renderer {
 public:
  /// All references must outlive the renderer; the geometry is that of the scene and the frame.
  Renderer(const traces::Scene& scene, const traces::Frame& frame, const Settings& settings, const Geometry& geometry);

  /// Ray traces a pixel: sets its colour, hit class, primitive and t.
  void trace(std::uint32_t x, std::uint32_t y, Pixel& pixel);
  const RayCounts& rays() const { return rays_; }

 private:
  enum class Kind : std::uint8_t { primary, reflection, refraction };
  struct Task {
    Vec3 origin, direction;
    Vec3 weight;
    unsigned depth;
    Kind kind;
  };

  /// The sum of all that is seen along the ray, depth first; `first` is its own hit.
  Vec3 radiance(const Vec3& origin, const Vec3& direction, Hit& first);
  void shade_miss(const Task& task, Vec3& acc) const;
  void shade_hit(const Task& task, const Hit& hit, Vec3& acc);
  void spawn(const Task& task, const HitPoint& point, const Vec3& kr, const Vec3& kt, float ior);
  bool worth_tracing(const Vec3& weight) const;

  const traces::Scene& scene_;
  const traces::Frame& frame_;
  const Settings& settings_;
  const Geometry& geometry_;
  RayCounts rays_;
  std::vector<Task> pending_;  // a stack; kept between pixels so that no ray allocates
};

}  // namespace artu::ref
