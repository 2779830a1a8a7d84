// The golden model for single rays: Embree with the contract's tests, and the same tests on every triangle in turn.
//
// Independent of hw/: what a stress test or a tool compares the unit's answers with.
#pragma once

#include <cstdint>
#include <memory>

#include "ref/padding.h"
#include "ref/precision.h"
#include "traces/frame.h"

namespace artu::ref {

/// The winner of docs/arithmetic.md section 3; without a hit all zero.
struct TracedHit {
  bool hit = false;
  std::int64_t primitive = -1;  // global id: static triangles from 0, then the dynamic ones
  std::uint32_t t_bits = 0;
  float t = 0, u = 0, v = 0, det = 0;  // U and V of the contract, against det
};

/// Not for two threads at a time.  A direction of (0, 0, 0) hits nothing.
class Tracer {
 public:
  /// `origins` holds every ray origin that will be asked for; points on the geometry need not be in it.
  /// Throws std::invalid_argument where a width of the two tests is outside of 7 ... 23.
  Tracer(const traces::Mesh& fixed, const traces::Mesh& dynamic, const Extent& origins,
         const Precision& precision = {});
  Tracer(const traces::Scene& scene, const traces::Frame& frame, const Extent& origins, const Precision& precision = {})
      : Tracer(scene.static_geometry, frame.dynamic, origins, precision) {}
  ~Tracer();

  TracedHit closest(const traces::Vec3& origin, const traces::Vec3& direction, float tmax) const;
  bool occluded(const traces::Vec3& origin, const traces::Vec3& direction, float tmax) const;

  /// Without a tree.
  TracedHit closest_of_all(const traces::Vec3& origin, const traces::Vec3& direction, float tmax) const;
  bool occluded_by_any(const traces::Vec3& origin, const traces::Vec3& direction, float tmax) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace artu::ref
