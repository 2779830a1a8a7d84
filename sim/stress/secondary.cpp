#include "sim/stress/secondary.h"

#include "hw/datapath/hit_tests.h"

namespace artu::sim {
namespace {

using hw::Vector;

hw::Ray ray_from(Vector origin, Vector direction, const hw::HitTests& tests) {
  hw::Ray ray;
  ray.origin = origin;
  ray.direction = direction;
  tests.set_up(ray);
  return ray;
}

/// Into the hemisphere around `normal`, the contract's condition for a reflection ray.
Vector upwards(Vector normal, Random& random) {
  const Vector d = random.direction();
  const float cosine = hw::dot(d, normal);
  return cosine > 0 ? d : cosine < 0 ? -d : normal;
}

}  // namespace

SecondaryRays secondary_rays(const hw::Ray& from, const hw::TriangleHit& hit, const Corners& triangle,
                             const hw::PrecisionConfig& precision, Random& random) {
  hw::TriangleRecord record{};
  record.a = triangle[0];
  record.b = triangle[1];
  record.c = triangle[2];
  const hw::Surface surface =
      hw::surface_at(from, hit, record, hw::AttributeRecord{}, static_cast<int>(precision.triangle));
  const hw::HitTests tests(precision);
  const Vector normal = surface.geometric_normal;
  Vector along = hw::unit(from.direction);
  if (!(hw::dot(along, normal) < 0)) along = -normal;  // exactly grazing: no mirror direction
  Vector mirror = hw::unit(along + normal * (2 * -hw::dot(along, normal)));
  if (!(hw::dot(mirror, normal) > 0)) mirror = normal;
  SecondaryRays rays;
  rays.front = surface.front;
  rays.out = {ray_from(surface.outside, upwards(normal, random), tests),
              ray_from(surface.outside, upwards(normal, random), tests), ray_from(surface.outside, mirror, tests)};
  rays.in = {ray_from(surface.inside, -upwards(normal, random), tests), ray_from(surface.inside, along, tests)};
  return rays;
}

}  // namespace artu::sim
