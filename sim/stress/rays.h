// Rays that are hard on a case's triangles.  Ray i of a case depends on the seed, the case and i alone.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hw/datapath/hit_tests.h"
#include "sim/stress/geometry.h"
#include "sim/stress/random.h"

namespace artu::sim {

enum class RayKind : std::uint8_t { near, inside, far, surface, axis, grazing, tiny, segment, along, wild };
inline constexpr std::uint32_t ray_kinds = 10;
const char* kind_name(RayKind kind);

struct StressRay {
  hw::Ray ray;  // set up
  RayKind kind = RayKind::near;
  std::uint32_t target = 0;  // the triangle that it was aimed at
  bool must_hit = false;     // it begins inside of a closed surface
};

struct Cube {
  hw::Vector center;
  float half;
};

class RaySource {
 public:
  /// `triangles` must outlive the source.
  RaySource(const StressGeometry& geometry, const std::vector<Corners>& triangles, std::uint64_t seed,
            const hw::PrecisionConfig& precision = {});
  StressRay ray(std::uint64_t index) const;
  /// A ray from inside of a closed surface through a vertex or a point of an edge; only where has_inside().
  StressRay leaving_ray(std::uint64_t index) const;
  bool has_inside() const { return !inside_.empty(); }

  /// A cube around the model that holds all origins, and one that holds most of those that are not `far`.
  Cube origins() const { return {bounds_.center, 1100 * bounds_.size}; }
  Cube near_origins() const { return {bounds_.center, 4 * bounds_.size}; }

 private:
  hw::Vector target(Random& random, std::uint32_t triangle, bool on_edge = false) const;
  hw::Vector tiny_direction(Random& random) const;
  void collect_inside(Random& random);
  void aim(Random& random, StressRay& out, hw::Vector goal) const;

  const std::vector<Corners>& triangles_;
  Bounds bounds_;
  std::uint64_t seed_;
  hw::PrecisionConfig precision_;
  hw::HitTests tests_;
  // Points inside of a closed surface: anywhere, and exactly in front of a target along an axis.
  std::vector<hw::Vector> inside_;
  struct AxisPoint {
    hw::Vector origin;
    std::uint32_t axis;
  };
  std::vector<AxisPoint> inside_on_axis_;
};

}  // namespace artu::sim
