#include "sim/stress/rays.h"

#include <algorithm>
#include <cmath>

namespace artu::sim {
namespace {

using hw::Vector;

constexpr float far_away = 1e3f;  // in sizes of the model

/// The other components are zero, of either sign.
Vector along_axis(std::uint32_t axis, Random& random) {
  float d[3];
  for (float& component : d) component = random.sign() * 0.0f;
  d[axis] = random.sign();
  return {d[0], d[1], d[2]};
}
Vector axis_direction(Random& random) { return along_axis(random.below(3), random); }

/// Exactly zero components of the direction keep the goal's coordinates in the origin, to the bit.
Vector back_from(Vector goal, Vector direction, float distance) {
  return {goal.x - direction.x * distance, goal.y - direction.y * distance, goal.z - direction.z * distance};
}

}  // namespace

const char* kind_name(RayKind kind) {
  static constexpr const char* names[ray_kinds] = {"near",    "inside", "far",     "surface", "axis",
                                                   "grazing", "tiny",   "segment", "along",   "wild"};
  return names[static_cast<std::size_t>(kind)];
}

RaySource::RaySource(const StressGeometry& geometry, const std::vector<Corners>& triangles, std::uint64_t seed,
                     const hw::PrecisionConfig& precision)
    : triangles_(triangles), bounds_(bounds_of(triangles)), seed_(seed), precision_(precision), tests_(precision) {
  Random random(seed, 0x1751deu);
  if (geometry.closed) collect_inside(random);
}

void RaySource::collect_inside(Random& random) {
  // On the surface the winding number has any value, and nearer to a triangle than rounding moves its vertices nothing
  // is promised (docs/arithmetic.md section 10): points near a triangle's box are left out.
  const double margin = 1e-4 * bounds_.size;
  const double rounding = std::ldexp(10.0, -1 - static_cast<int>(std::min(precision_.box, precision_.triangle)));
  const auto is_near = [&](const Corners& t, Vector point) {
    double near = 0, far = 0;  // squares of the distances of the box's nearest and farthest point
    for (int axis = 0; axis < 3; ++axis) {
      const double lo = double(std::min({t[0][axis], t[1][axis], t[2][axis]})) - double(point[axis]);
      const double hi = double(std::max({t[0][axis], t[1][axis], t[2][axis]})) - double(point[axis]);
      const double outside = std::max({lo, -hi, 0.0}), farthest = std::max(std::fabs(lo), std::fabs(hi));
      near += outside * outside;
      far += farthest * farthest;
    }
    return std::sqrt(near) <= std::max(margin, rounding * std::sqrt(far));
  };
  const auto is_inside = [&](Vector point) {
    return std::none_of(triangles_.begin(), triangles_.end(), [&](const Corners& t) { return is_near(t, point); }) &&
           std::fabs(winding_number(triangles_, point)) > 0.99;
  };
  for (int tries = 0; tries < 40 && inside_.size() < 12; ++tries) {
    const Vector point = bounds_.center + random.within(0.3f * bounds_.size);
    if (is_inside(point)) inside_.push_back(point);
  }
  for (int tries = 0; tries < 60 && inside_on_axis_.size() < 30; ++tries) {
    const Vector goal = target(random, random.below(triangles_.size()));
    const Vector near = bounds_.center + random.within(0.2f * bounds_.size);
    const std::uint32_t axis = random.below(3);
    const Vector point{axis == 0 ? near.x : goal.x, axis == 1 ? near.y : goal.y, axis == 2 ? near.z : goal.z};
    if (is_inside(point)) inside_on_axis_.push_back({point, axis});
  }
}

Vector RaySource::target(Random& random, std::uint32_t triangle, bool on_edge) const {
  if (triangles_.empty()) return random.within(1);
  const Corners& t = triangles_[triangle];
  const std::uint32_t corner = random.below(3);
  const Vector a = t[corner], b = t[(corner + 1) % 3], c = t[(corner + 2) % 3];
  switch (random.below(on_edge ? 3 : 5)) {
    case 0:
      return a;
    case 1:
      return a * 0.5f + b * 0.5f;
    case 2:
      return a + (b - a) * random.share();
    default: {
      const float s = random.share(), r = random.share() * (1 - s);
      return a + (b - a) * s + (c - a) * r;
    }
  }
}

Vector RaySource::tiny_direction(Random& random) const {
  static constexpr float tiny[] = {0x1p-149f, -0x1p-149f, 0x1p-130f, -0x1p-127f, 0x1p-126f, 1e-35f, -1e-30f, 0x1p-101f,
                                   0x1p-100f, -0x1p-99f,  1e-20f,    -1e-18f,    1e-12f,    -1e-8f, 0.0f,    -0.0f};
  const auto pick = [&] { return tiny[random.below(16)]; };
  const Vector d = random.direction();
  float v[3] = {d.x, d.y, d.z};
  const std::uint32_t axis = random.below(3);
  v[axis] = pick();
  if (random.below(2) != 0) {
    v[(axis + 1) % 3] = pick();
    v[(axis + 2) % 3] = random.sign();
  }
  return {v[0], v[1], v[2]};
}

void RaySource::aim(Random& random, StressRay& out, Vector goal) const {
  const float size = bounds_.size;
  Vector origin = bounds_.center + random.within(1.5f * size);
  Vector direction;
  switch (out.kind) {
    case RayKind::near:
      break;
    case RayKind::inside:
      if (inside_.empty()) {
        origin = bounds_.center + random.within(0.3f * size);
      } else if (!inside_on_axis_.empty() && random.below(2) == 0) {
        const AxisPoint& from = inside_on_axis_[random.below(inside_on_axis_.size())];
        origin = from.origin;
        direction = along_axis(from.axis, random);
        out.must_hit = true;
      } else {
        origin = inside_[random.below(inside_.size())];
        out.must_hit = true;
      }
      break;
    case RayKind::far:
      origin = bounds_.center + random.direction() * (far_away * size);
      break;
    case RayKind::surface:
      origin = goal;
      direction = random.below(4) == 0 ? axis_direction(random) : random.direction();
      break;
    case RayKind::axis:
      direction = axis_direction(random);
      origin = back_from(goal, direction, random.below(8) == 0 ? 0.0f : 3 * size * random.share());
      break;
    case RayKind::tiny:
      direction = tiny_direction(random);
      origin = back_from(goal, direction, 3 * size * random.share());
      break;
    case RayKind::grazing: {  // in the target's plane, or nearly so
      if (triangles_.empty()) break;
      const Corners& t = triangles_[out.target];
      origin = t[0] + (t[1] - t[0]) * random.between(-3, 3) + (t[2] - t[0]) * random.between(-3, 3);
      if (random.below(2) != 0) origin = origin + random.within(1e-5f * size);
      break;
    }
    case RayKind::segment:
      direction = goal - origin;
      out.ray.tmax = 1;
      break;
    case RayKind::along:  // from vertex to vertex, or along an edge
      if (triangles_.empty()) break;
      origin = random.below(2) == 0 ? triangles_[out.target][random.below(3)]
                                    : triangles_[random.below(triangles_.size())][random.below(3)];
      if (random.below(2) == 0) origin = origin - (goal - origin);
      break;
    case RayKind::wild:
      direction = random.direction();
      break;
  }
  if (hw::is_zero(direction)) direction = hw::unit(goal - origin);
  // Small models: a difference may be too short for unit(), as may a segment's for the unit's range of lengths.
  if (hw::is_zero(direction)) direction = random.direction();
  out.ray.origin = origin;
  out.ray.direction = direction;
}

StressRay RaySource::leaving_ray(std::uint64_t index) const {
  Random random(seed_ ^ 0x1ea4u, index);
  StressRay out;
  out.kind = RayKind::inside;
  out.target = random.below(triangles_.size());
  aim(random, out, target(random, out.target, true));
  tests_.set_up(out.ray);
  return out;
}

StressRay RaySource::ray(std::uint64_t index) const {
  Random random(seed_, index);
  StressRay out;
  out.kind = static_cast<RayKind>(index % ray_kinds);
  if (!triangles_.empty()) out.target = random.below(triangles_.size());
  aim(random, out, target(random, out.target));
  tests_.set_up(out.ray);
  return out;
}

}  // namespace artu::sim
